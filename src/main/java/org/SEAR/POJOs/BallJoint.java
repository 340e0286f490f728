// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** A ball joint: both objects turn freely about a common point, as on the hitch of a trailer. */
@Described("a ball joint: both objects turn freely about a common point, as on the hitch of a trailer")
public class BallJoint extends Joint {
    /** For reading from a file. */
    protected BallJoint() {
    }

    /**
     * About the world's origin; {@code move} places it.
     *
     * @param first null for the world
     */
    public BallJoint(String name, SearObject first, SearObject second) {
        this(name, first, second, 0, 0, 0);
    }

    /** About (x, y, z), metres. */
    public BallJoint(String name, SearObject first, SearObject second, double x, double y, double z) {
        super(name, first, second);
        pose(x, y, z, 0, 0, 0);
        created(BallJoint.class);
    }
}
