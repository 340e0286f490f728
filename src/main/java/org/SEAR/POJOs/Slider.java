// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** A slider: the second object moves along the slider's y axis without turning. */
@Described("a slider: the second object moves along the slider's y axis without turning")
public class Slider extends GuidedJoint {
    /** For reading from a file. */
    protected Slider() {
    }

    /**
     * With a vertical axis; {@code move} and {@code rotate} place it.
     *
     * @param first null for the world
     */
    public Slider(String name, SearObject first, SearObject second) {
        this(name, first, second, 0, 0, 0, 0, 0, 0);
    }

    /** With a vertical axis at (x, y, z), metres. */
    public Slider(String name, SearObject first, SearObject second, double x, double y, double z) {
        this(name, first, second, x, y, z, 0, 0, 0);
    }

    /** At (x, y, z), metres, turned by (rx, ry, rz), degrees: (0, 0, 90) makes it point along -x. */
    public Slider(String name, SearObject first, SearObject second, double x, double y, double z, double rx, double ry,
        double rz) {
        super(name, first, second);
        pose(x, y, z, rx, ry, rz);
        created(Slider.class);
    }
}
