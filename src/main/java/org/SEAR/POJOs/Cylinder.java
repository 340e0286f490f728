// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** A vertical cylinder about the y axis, centred on its origin. Its default picture is a recycling bin. */
@Described("a vertical cylinder about the y axis")
public class Cylinder extends RoundShape {
    /** For reading from a file. */
    protected Cylinder() {
    }

    /** Fixed in place, mass 0. */
    public Cylinder(String name, double radius, double height) {
        this(name, radius, height, 0);
    }

    /**
     * Centred on the origin, with the default picture of a recycling bin.
     *
     * @param mass kg, 0 fixes it in place
     */
    public Cylinder(String name, double radius, double height, double mass) {
        this(name, radius, height, mass, null);
    }

    /** @param image path below assets; null for the default picture */
    public Cylinder(String name, double radius, double height, double mass, String image) {
        this(name, radius, height, mass, image, 0, 0, 0, 0, 0, 0);
    }

    /** With its centre at (x, y, z), metres. */
    public Cylinder(String name, double radius, double height, double mass, double x, double y, double z) {
        this(name, radius, height, mass, null, x, y, z, 0, 0, 0);
    }

    /** With its centre at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Cylinder(String name, double radius, double height, double mass, double x, double y, double z, double rx,
        double ry, double rz) {
        this(name, radius, height, mass, null, x, y, z, rx, ry, rz);
    }

    /** With all parameters. */
    public Cylinder(String name, double radius, double height, double mass, String image,
            double x, double y, double z, double rx, double ry, double rz) {
        super(name, radius, height, mass, image, x, y, z, rx, ry, rz);
        created(Cylinder.class);
    }

    @Override
    protected String defaultPicture() {
        return "textures/recycling.png";
    }

    @Override
    protected String defaultColor() {
        return "#5b8c5a";
    }
}
