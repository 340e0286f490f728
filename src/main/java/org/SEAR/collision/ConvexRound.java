// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import org.SEAR.geometry.InertiaTensor;

/** Cylinder or cone about the y axis, centred in the origin; a cone's apex is up. Immutable. */
public final class ConvexRound implements ConvexShape {
    /** Corners of the polygon that approximates a round face. */
    private static final int CORNERS = 16;
    /** Sine of the angle to the axis below which a direction has no sideways part. */
    private static final double ON_AXIS = 1e-3;

    private final double bottom;
    private final double top;
    private final double half;
    private final double skin;
    /** Core: radius of its base, y of its base, y of its top or apex, metres. */
    private final double coreRadius;
    private final double coreLow;
    private final double coreHigh;

    private ConvexRound(double bottom, double top, double half) {
        this.bottom = bottom;
        this.top = top;
        this.half = half;
        skin = ConvexRadius.of(least());
        coreLow = -half + skin;
        // moving the side of a cone in by the convex radius lowers the apex by this much
        coreHigh = half - (top == 0 ? skin * Math.hypot(bottom, 2 * half) / bottom : skin);
        coreRadius = top == 0 ? bottom * (coreHigh - coreLow) / (2 * half) : bottom - skin;
    }

    /**
     * Returns a cylinder.
     * @param radius metres
     * @param half of its height, metres
     */
    public static ConvexRound cylinder(double radius, double half) {
        return new ConvexRound(radius, radius, half);
    }

    /**
     * Returns a cone.
     * @param radius of its base, metres
     * @param half of its height, metres
     */
    public static ConvexRound cone(double radius, double half) {
        return new ConvexRound(radius, 0, half);
    }

    @Override
    public void support(double dx, double dy, double dz, double[] into) {
        support(dx, dy, dz, bottom, -half, half, into);
    }

    @Override
    public void coreSupport(double dx, double dy, double dz, double[] into) {
        support(dx, dy, dz, coreRadius, coreLow, coreHigh, into);
    }

    private void support(double dx, double dy, double dz, double radius, double low, double high, double[] into) {
        double across = Math.sqrt(dx * dx + dz * dz);
        boolean cone = top == 0;
        if (cone && dy * 2 * half > across * bottom) {
            into[0] = 0;
            into[1] = high;
            into[2] = 0;
            return;
        }
        into[0] = across > 0 ? radius * dx / across : 0;
        into[1] = cone || dy < 0 ? low : high;
        into[2] = across > 0 ? radius * dz / across : 0;
    }

    @Override
    public double skin() {
        return skin;
    }

    /** Adds an end face, as a polygon, or the line along the side. */
    @Override
    public void feature(double dx, double dy, double dz, ContactFeature into) {
        double across = Math.hypot(dx, dz);
        double slant = Math.hypot(2 * half, bottom - top);
        double sideways = (across * 2 * half + dy * (bottom - top)) / slant;
        double end = dy > 0 && top == 0 ? -1 : Math.abs(dy);
        double ux = across > ON_AXIS ? dx / across : 1;
        double uz = across > ON_AXIS ? dz / across : 0;
        if (sideways >= end) {
            into.add(bottom * ux, -half, bottom * uz);
            into.add(top * ux, half, top * uz);
            into.setCurvature(bottom * slant / (2 * half), top * slant / (2 * half));
            return;
        }
        double radius = dy > 0 ? top : bottom;
        double y = dy > 0 ? half : -half;
        for (int i = 0; i < CORNERS; i++) {
            double angle = 2 * Math.PI * i / CORNERS;
            double cosine = Math.cos(angle);
            double sine = Math.sin(angle);
            into.add(radius * (cosine * ux - sine * uz), y, radius * (sine * ux + cosine * uz));
        }
        into.setNormal(0, Math.signum(dy), 0);
        into.setCircle(across > ON_AXIS);
    }

    @Override
    public double volume() {
        return 8 * bottom * half * bottom * Math.PI / (top == 0 ? 12 : 4);
    }

    /** The centre of a cone is a quarter of its height above the base. */
    @Override
    public double[] centre() {
        return new double[] {0, top == 0 ? -half / 2 : 0, 0};
    }

    @Override
    public InertiaTensor inertia() {
        double square = bottom * bottom;
        if (top == 0) {
            double across = 0.15 * (square + half * half);
            return new InertiaTensor(across, 0.3 * square, across);
        }
        double across = square / 4 + half * half / 3;
        return new InertiaTensor(across, square / 2, across);
    }

    @Override
    public double radius() {
        return Math.hypot(bottom, half);
    }

    @Override
    public double least() {
        return Math.min(bottom, half);
    }

    @Override
    public boolean isTurned() {
        return true;
    }

    @Override
    public boolean isRimmed() {
        return true;
    }

    /** The apex of a cone. */
    @Override
    public boolean isCorner(double x, double y, double z) {
        return top == 0 && y > half - skin;
    }
}
