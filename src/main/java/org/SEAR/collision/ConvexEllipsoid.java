// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.InertiaTensor;

/** Ellipsoid with its axes along x, y and z, centred in the origin; a sphere if they are equal. Immutable. */
public final class ConvexEllipsoid implements ConvexShape {
    private final double a;
    private final double b;
    private final double c;
    private final double skin;

    /** @param a half extent along x, metres, likewise b along y and c along z */
    public ConvexEllipsoid(double a, double b, double c) {
        this.a = a;
        this.b = b;
        this.c = c;
        skin = isBall() ? a : ConvexRadius.of(least());
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        double length = Math.sqrt(a * dx * (a * dx) + b * dy * (b * dy) + c * dz * (c * dz));
        into[0] = a * a * dx / length;
        into[1] = b * b * dy / length;
        into[2] = c * c * dz / length;
    }

    /** Adds the point whose normal is the direction. */
    @Override
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        double length = Math.sqrt(a * dx * (a * dx) + b * dy * (b * dy) + c * dz * (c * dz));
        into.add(a * a * dx / length, b * b * dy / length, c * c * dz / length);
    }

    @Override
    public double volume() {
        return 4 * Math.PI / 3 * a * b * c;
    }

    @Override
    public double[] centre() {
        return new double[3];
    }

    @Override
    public InertiaTensor inertia() {
        return new InertiaTensor((b * b + c * c) / 5, (a * a + c * c) / 5, (a * a + b * b) / 5);
    }

    @Override
    public double radius() {
        return Math.max(a, Math.max(b, c));
    }

    @Override
    public double least() {
        return Math.min(a, Math.min(b, c));
    }

    @Override
    public boolean isTurned() {
        return a == c;
    }

    @Override
    public boolean isBall() {
        return a == b && a == c;
    }

    /** A sphere's core is its centre. The core of another ellipsoid has shorter axes and nearly the same normals. */
    @Override
    public void coreSupport(double dx, double dy, double dz, double[] into) {
        if (isBall()) {
            into[0] = 0;
            into[1] = 0;
            into[2] = 0;
            return;
        }
        double u = a - skin;
        double v = b - skin;
        double w = c - skin;
        double length = Math.sqrt(u * dx * (u * dx) + v * dy * (v * dy) + w * dz * (w * dz));
        into[0] = u * u * dx / length;
        into[1] = v * v * dy / length;
        into[2] = w * w * dz / length;
    }

    @Override
    public double skin() {
        return skin;
    }
}
