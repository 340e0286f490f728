// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

/** An ellipsoid with its axes along x, y and z; a sphere if they are equal. Immutable. */
public final class RayEllipsoid implements RaySolid {
    private static final double MISS = Double.POSITIVE_INFINITY;

    private final double a;
    private final double b;
    private final double c;

    /** @param a half size along x, metres, likewise b along y and c along z */
    public RayEllipsoid(double a, double b, double c) {
        this.a = a;
        this.b = b;
        this.c = c;
    }

    /** Scales to the unit sphere. Solves from the ray's closest point to the centre to avoid cancellation. */
    @Override
    public double intersect(double ox, double oy, double oz, double dx, double dy, double dz) {
        double ux = dx / a;
        double uy = dy / b;
        double uz = dz / c;
        double square = ux * ux + uy * uy + uz * uz;
        double middle = -(ox / a * ux + oy / b * uy + oz / c * uz) / square;
        double px = ox / a + middle * ux;
        double py = oy / b + middle * uy;
        double pz = oz / c + middle * uz;
        double inside = 1 - (px * px + py * py + pz * pz);
        if (inside < 0) {
            return MISS;
        }
        double half = Math.sqrt(inside / square);
        double in = middle - half;
        double out = middle + half;
        return out < 0 ? MISS : in >= 0 ? in : out;
    }

    @Override
    public void normal(double[] point) {
        point[0] /= a * a;
        point[1] /= b * b;
        point[2] /= c * c;
    }

    @Override
    public double reach(double dx, double dy, double dz) {
        return Math.sqrt(a * dx * (a * dx) + b * dy * (b * dy) + c * dz * (c * dz));
    }
}
