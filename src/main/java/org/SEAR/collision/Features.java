package org.SEAR.collision;

/** Which part of a solid faces a direction. */
public final class Features {
    /** Corners of the polygon that stands for a round face. */
    private static final int CORNERS = 8;
    /** A direction closer to the axis than this has no side, sine. */
    private static final double ON_AXIS = 1e-3;

    private Features() {
    }

    /** A face of a box. @param d unit direction */
    public static void box(double hx, double hy, double hz, double dx, double dy, double dz, Feature into) {
        double ax = Math.abs(dx);
        double ay = Math.abs(dy);
        double az = Math.abs(dz);
        for (int i = 0; i < 4; i++) {
            double u = i == 0 || i == 3 ? 1 : -1;
            double v = i < 2 ? 1 : -1;
            if (ax >= ay && ax >= az) {
                into.add(Math.copySign(hx, dx), u * hy, v * hz);
            } else if (ay >= az) {
                into.add(u * hx, Math.copySign(hy, dy), v * hz);
            } else {
                into.add(u * hx, v * hy, Math.copySign(hz, dz));
            }
        }
        if (ax >= ay && ax >= az) {
            into.setNormal(Math.signum(dx), 0, 0);
        } else if (ay >= az) {
            into.setNormal(0, Math.signum(dy), 0);
        } else {
            into.setNormal(0, 0, Math.signum(dz));
        }
    }

    /** An end face, or the line along the side, of a cylinder or cone about the y axis. @param top radius at +half @param d unit direction */
    public static void round(double bottom, double top, double half, double dx, double dy, double dz, Feature into) {
        double across = Math.hypot(dx, dz);
        double slant = Math.hypot(2 * half, bottom - top);
        double sideways = (across * 2 * half + dy * (bottom - top)) / slant;
        double end = dy > 0 && top == 0 ? -1 : Math.abs(dy);
        double ux = across > ON_AXIS ? dx / across : 1;
        double uz = across > ON_AXIS ? dz / across : 0;
        if (sideways >= end) {
            into.add(bottom * ux, -half, bottom * uz);
            into.add(top * ux, half, top * uz);
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
    }
}
