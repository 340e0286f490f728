// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Integrals of 1, x, y, z and their products over the solid that triangles enclose: signed tetrahedra between the
 * triangles and a reference point (Lien and Kajiya 1984, "A symbolic method for calculating the integral properties of
 * arbitrary nonconvex polyhedra"). The triangles must be closed; the reference point then only affects rounding. Not
 * thread-safe.
 */
public final class VolumeIntegrals {
    private final double ox;
    private final double oy;
    private final double oz;
    private double volume;
    private final double[] first = new double[3];
    /** Integrals of xx, yy, zz, xy, xz and yz, relative to the reference point. */
    private final double[] second = new double[6];

    /** @param ox reference point on or near the solid, metres, likewise oy and oz */
    public VolumeIntegrals(double ox, double oy, double oz) {
        this.ox = ox;
        this.oy = oy;
        this.oz = oz;
    }

    /**
     * Adds a triangle, counter-clockwise seen from outside.
     * @param p coordinates, metres
     * @param i index of x, y and z of a corner in {@code p}, likewise k and l
     */
    public void add(double[] p, int i, int k, int l) {
        double ax = p[i] - ox;
        double ay = p[i + 1] - oy;
        double az = p[i + 2] - oz;
        double bx = p[k] - ox;
        double by = p[k + 1] - oy;
        double bz = p[k + 2] - oz;
        double cx = p[l] - ox;
        double cy = p[l + 1] - oy;
        double cz = p[l + 2] - oz;
        double part = (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx)) / 6;
        double x = ax + bx + cx;
        double y = ay + by + cy;
        double z = az + bz + cz;
        volume += part;
        first[0] += part * x / 4;
        first[1] += part * y / 4;
        first[2] += part * z / 4;
        second[0] += part * (x * x + ax * ax + bx * bx + cx * cx) / 20;
        second[1] += part * (y * y + ay * ay + by * by + cy * cy) / 20;
        second[2] += part * (z * z + az * az + bz * bz + cz * cz) / 20;
        second[3] += part * (x * y + ax * ay + bx * by + cx * cy) / 20;
        second[4] += part * (x * z + ax * az + bx * bz + cx * cz) / 20;
        second[5] += part * (y * z + ay * az + by * bz + cy * cz) / 20;
    }

    /**
     * Adds the integrals of another set of triangles with the same reference point.
     * @param sign -1 if its triangles are clockwise seen from outside, else 1
     */
    public void add(VolumeIntegrals other, double sign) {
        volume += sign * other.volume;
        for (int i = 0; i < first.length; i++) {
            first[i] += sign * other.first[i];
        }
        for (int i = 0; i < second.length; i++) {
            second[i] += sign * other.second[i];
        }
    }

    /** Volume, m^3; negative if the triangles are clockwise seen from outside. */
    public double volume() {
        return volume;
    }

    /** Returns the centre of mass at uniform density: {x, y, z}, metres. */
    public double[] centre() {
        return new double[] {ox + first[0] / volume, oy + first[1] / volume, oz + first[2] / volume};
    }

    /** Returns the inertia tensor of one kilogram at uniform density about the centre of mass, m^2. */
    public InertiaTensor inertia() {
        double x = first[0] / volume;
        double y = first[1] / volume;
        double z = first[2] / volume;
        double xx = second[0] / volume - x * x;
        double yy = second[1] / volume - y * y;
        double zz = second[2] / volume - z * z;
        return new InertiaTensor(yy + zz, xx + zz, xx + yy, x * y - second[3] / volume, x * z - second[4] / volume,
            y * z - second[5] / volume);
    }
}
