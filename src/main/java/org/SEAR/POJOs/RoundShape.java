// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/** A shape with rotational symmetry about its y axis, centred on its origin. */
public abstract class RoundShape extends Shape {
    @Param(doc = "radius, of a cone at its base", unit = "m", min = SMALL, max = LARGE, required = true,
        initial = "0.1")
    private double radius;
    @Param(doc = "size along y", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.25")
    private double height;

    /** For reading from a file. */
    protected RoundShape() {
    }

    /**
     * Centred at (x, y, z), metres, turned by (rx, ry, rz), degrees.
     *
     * @param mass kg, 0 fixes it in place
     * @param image path below assets; null for the default picture
     */
    RoundShape(String name, double radius, double height, double mass, String image,
            double x, double y, double z, double rx, double ry, double rz) {
        super(name, mass);
        this.radius = radius;
        this.height = height;
        wrap(image);
        pose(x, y, z, rx, ry, rz);
    }

    public double getRadius() {
        return radius;
    }

    public double getHeight() {
        return height;
    }
}
