// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** A sphere, centred on its origin; non-uniform scaling makes it an ellipsoid. Without a picture it is plain. */
@Described("a sphere; non-uniform scaling makes it an ellipsoid")
public class Sphere extends Shape {
    @Param(doc = "radius", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.1")
    private double radius;

    /** For reading from a file. */
    protected Sphere() {
    }

    /** Fixed in place, mass 0. */
    public Sphere(String name, double radius) {
        this(name, radius, 0);
    }

    /**
     * Centred on the origin, plain.
     *
     * @param mass kg, 0 fixes it in place
     */
    public Sphere(String name, double radius, double mass) {
        this(name, radius, mass, null);
    }

    /** @param image path below assets; null for none */
    public Sphere(String name, double radius, double mass, String image) {
        this(name, radius, mass, image, 0, 0, 0, 0, 0, 0);
    }

    /** With its centre at (x, y, z), metres. */
    public Sphere(String name, double radius, double mass, double x, double y, double z) {
        this(name, radius, mass, null, x, y, z, 0, 0, 0);
    }

    /** With its centre at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Sphere(String name, double radius, double mass, double x, double y, double z, double rx, double ry,
        double rz) {
        this(name, radius, mass, null, x, y, z, rx, ry, rz);
    }

    /** With all parameters. */
    public Sphere(String name, double radius, double mass, String image, double x, double y, double z, double rx,
        double ry, double rz) {
        super(name, mass);
        this.radius = radius;
        wrap(image);
        pose(x, y, z, rx, ry, rz);
        created(Sphere.class);
    }

    public double getRadius() {
        return radius;
    }

    @Override
    protected String defaultColor() {
        return "#9b6fb0";
    }
}
