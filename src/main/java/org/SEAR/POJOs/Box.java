// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/**
 * A box: length along x, height along y, width along z, centred on its origin. Its default picture is a cardboard box.
 */
@Described("a box: length along x, height along y, width along z")
public class Box extends Shape {
    @Param(doc = "size along x", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.25")
    private double length;
    @Param(doc = "size along z", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.25")
    private double width;
    @Param(doc = "size along y", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.25")
    private double height;

    /** For reading from a file. */
    protected Box() {
    }

    /** Fixed in place, mass 0. */
    public Box(String name, double length, double width, double height) {
        this(name, length, width, height, 0);
    }

    /**
     * Centred on the origin, with the default picture of a cardboard box.
     *
     * @param mass kg, 0 fixes it in place
     */
    public Box(String name, double length, double width, double height, double mass) {
        this(name, length, width, height, mass, null);
    }

    /** @param image path below assets; null for the default picture */
    public Box(String name, double length, double width, double height, double mass, String image) {
        this(name, length, width, height, mass, image, 0, 0, 0, 0, 0, 0);
    }

    /** With its centre at (x, y, z), metres. */
    public Box(String name, double length, double width, double height, double mass, double x, double y, double z) {
        this(name, length, width, height, mass, null, x, y, z, 0, 0, 0);
    }

    /** With its centre at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Box(String name, double length, double width, double height, double mass, double x, double y, double z,
        double rx, double ry, double rz) {
        this(name, length, width, height, mass, null, x, y, z, rx, ry, rz);
    }

    /** With all parameters. */
    public Box(String name, double length, double width, double height, double mass, String image,
            double x, double y, double z, double rx, double ry, double rz) {
        super(name, mass);
        this.length = length;
        this.width = width;
        this.height = height;
        wrap(image);
        pose(x, y, z, rx, ry, rz);
        created(Box.class);
    }

    public double getLength() {
        return length;
    }

    public double getWidth() {
        return width;
    }

    public double getHeight() {
        return height;
    }

    @Override
    protected String defaultPicture() {
        return "textures/cardboard.png";
    }

    @Override
    protected String defaultColor() {
        return "#c49a6c";
    }
}
