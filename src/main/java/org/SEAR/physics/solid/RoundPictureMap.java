// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import org.SEAR.geometry.SurfaceMesh;

/**
 * Drawn mesh of a cylinder or cone with circular or elliptic ends: the picture wraps around its side and covers its
 * caps.
 */
final class RoundPictureMap {
    /** Corners of a circle in the window. */
    private static final int SIDES = 32;
    /** Corners of a circle in the tab. */
    private static final int RIM = 24;

    private final SurfaceMesh mesh = new SurfaceMesh();
    private final double a;
    private final double h;
    private final double c;

    private RoundPictureMap(double a, double h, double c) {
        this.a = a;
        this.h = h;
        this.c = c;
    }

    /** @param halfX half extent, metres, likewise halfY and halfZ */
    static SurfaceMesh of(double halfX, double halfY, double halfZ, boolean cone) {
        RoundPictureMap look = new RoundPictureMap(halfX, halfY, halfZ);
        look.side(cone ? 0 : 1);
        if (!cone) {
            look.cap(1);
        }
        look.cap(-1);
        return look.mesh;
    }

    /** Returns the rim of each end, or the apex. */
    static double[][] rims(double halfX, double halfY, double halfZ, boolean cone) {
        double[][] points = new double[cone ? RIM + 1 : 2 * RIM][];
        for (int i = 0; i < points.length; i++) {
            double angle = 2 * Math.PI * i / RIM;
            points[i] = new double[] {halfX * Math.cos(angle), i < RIM ? -halfY : halfY, halfZ * Math.sin(angle)};
        }
        if (cone) {
            points[RIM] = new double[] {0, halfY, 0};
        }
        return points;
    }

    /** The picture's left edge is at +z. It runs counter-clockwise seen from above, so that text on it is readable. */
    private void side(double top) {
        for (int i = 0; i <= SIDES; i++) {
            double sin = Math.sin(2 * Math.PI * i / SIDES);
            double cos = Math.cos(2 * Math.PI * i / SIDES);
            double up = (1 - top) / (2 * h);
            double u = (double) i / SIDES;
            int low = mesh.vertex(a * sin, -h, c * cos, sin / a, up, cos / c, u, 0);
            int high = mesh.vertex(a * top * sin, h, c * top * cos, sin / a, up, cos / c, u, 1);
            if (i < SIDES) {
                mesh.triangle(low, low + 2, high);
                mesh.triangle(low + 2, high + 2, high);
            }
        }
    }

    /** @param up +1 for the upper cap, -1 for the lower one */
    private void cap(int up) {
        int middle = mesh.vertex(0, up * h, 0, 0, up, 0, 0.5, 0.5);
        for (int i = 0; i <= SIDES; i++) {
            double sin = Math.sin(2 * Math.PI * i / SIDES);
            double cos = Math.cos(2 * Math.PI * i / SIDES);
            int rim = mesh.vertex(a * sin, up * h, c * cos, 0, up, 0, 0.5 + sin / 2, 0.5 - cos * up / 2);
            if (i < SIDES) {
                mesh.triangle(middle, up > 0 ? rim : rim + 1, up > 0 ? rim + 1 : rim);
            }
        }
    }
}
