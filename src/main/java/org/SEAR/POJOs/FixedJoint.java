// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** A fixed joint: both objects move as one, until it breaks. */
@Described("a fixed joint: both objects move as one, until it breaks")
public class FixedJoint extends Joint {
    /** For reading from a file. */
    protected FixedJoint() {
    }

    /**
     * At the world's origin.
     *
     * @param first null for the world
     */
    public FixedJoint(String name, SearObject first, SearObject second) {
        this(name, first, second, 0, 0, 0);
    }

    /** At (x, y, z), metres, where {@code sear.getJointForce} measures. */
    public FixedJoint(String name, SearObject first, SearObject second, double x, double y, double z) {
        super(name, first, second);
        pose(x, y, z, 0, 0, 0);
        created(FixedJoint.class);
    }
}
