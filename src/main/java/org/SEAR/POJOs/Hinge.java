// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** A hinge: the second object turns about the hinge's y axis, which is vertical without a rotation. */
@Described("a hinge: the second object turns about the hinge's y axis, counter-clockwise seen from its tip")
public class Hinge extends GuidedJoint {
    /** For reading from a file. */
    protected Hinge() {
    }

    /**
     * With its axis through the world's origin; {@code move} and {@code rotate} place it.
     *
     * @param first null for the world
     */
    public Hinge(String name, SearObject first, SearObject second) {
        this(name, first, second, 0, 0, 0, 0, 0, 0);
    }

    /** With its axis through (x, y, z), metres, vertical. */
    public Hinge(String name, SearObject first, SearObject second, double x, double y, double z) {
        this(name, first, second, x, y, z, 0, 0, 0);
    }

    /** With its axis through (x, y, z), metres, turned by (rx, ry, rz), degrees: (90, 0, 0) makes it point along z. */
    public Hinge(String name, SearObject first, SearObject second, double x, double y, double z, double rx, double ry,
        double rz) {
        super(name, first, second);
        pose(x, y, z, rx, ry, rz);
        created(Hinge.class);
    }
}
