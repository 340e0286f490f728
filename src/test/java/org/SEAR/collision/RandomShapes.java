// SPDX-License-Identifier: Apache-2.0
package org.SEAR.collision;

import java.util.Random;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Rotation;

/**
 * Random convex solids in random poses. The property {@code sear.seed} selects another series; messages of failed tests
 * contain the seed.
 */
final class RandomShapes {
    static final long SEED = Long.getLong("sear.seed", 14);
    private static final int POINTS = 30;

    final Random random = new Random(SEED);

    /** Returns an exact ball, which the shapes of the grammar only approximate. */
    static Convex ball(double x, double y, double z, double radius) {
        return (dx, dy, dz, into) -> {
            double scale = radius / Math.sqrt(dx * dx + dy * dy + dz * dz);
            into[0] = x + scale * dx;
            into[1] = y + scale * dy;
            into[2] = z + scale * dz;
        };
    }

    /** Returns a shape with half sizes of 0.1 to 1 m. */
    ConvexShape shape() {
        switch (random.nextInt(5)) {
            case 0:
                return new ConvexBox(size(), size(), size());
            case 1:
                return ConvexRound.cylinder(size(), size());
            case 2:
                return ConvexRound.cone(size(), size());
            case 3:
                return new ConvexEllipsoid(size(), size(), size());
            default:
                return ConvexHull.of(cloud(POINTS));
        }
    }

    double size() {
        return 0.1 + 0.9 * random.nextDouble();
    }

    double[] cloud(int count) {
        return random.doubles(3L * count, -1, 1).toArray();
    }

    /** Returns the shape in a random pose within {@code reach} metres of the origin along each axis. */
    PlacedConvex place(ConvexShape shape, double reach) {
        double[] q = direction(4);
        return place(shape, q, reach * (2 * random.nextDouble() - 1), reach * (2 * random.nextDouble() - 1),
            reach * (2 * random.nextDouble() - 1));
    }

    /** Returns the unrotated shape at a place. */
    static PlacedConvex at(ConvexShape shape, double x, double y, double z) {
        return place(shape, new double[] {0, 0, 0, 1}, x, y, z);
    }

    static PlacedConvex place(ConvexShape shape, double[] q, double x, double y, double z) {
        PlacedConvex placed = new PlacedConvex();
        Placement to = placed.set(shape);
        double[] m = new double[9];
        Rotation.write(q[0], q[1], q[2], q[3], m, 0);
        to.m00 = m[0];
        to.m01 = m[1];
        to.m02 = m[2];
        to.m10 = m[3];
        to.m11 = m[4];
        to.m12 = m[5];
        to.m20 = m[6];
        to.m21 = m[7];
        to.m22 = m[8];
        to.x = x;
        to.y = y;
        to.z = z;
        return placed;
    }

    /** Returns a random vector of length 1. */
    double[] direction(int dimensions) {
        double[] d = new double[dimensions];
        double square = 0;
        for (int i = 0; i < dimensions; i++) {
            d[i] = random.nextGaussian();
            square += d[i] * d[i];
        }
        for (int i = 0; i < dimensions; i++) {
            d[i] /= Math.sqrt(square);
        }
        return d;
    }

    static double separation(Convex first, Convex second, double nx, double ny, double nz) {
        double[] a = new double[3];
        double[] b = new double[3];
        first.support(-nx, -ny, -nz, a);
        second.support(nx, ny, nz, b);
        return nx * (a[0] - b[0]) + ny * (a[1] - b[1]) + nz * (a[2] - b[2]);
    }

    /**
     * Returns the greatest separation along any direction: the best of many directions, improved by steps that shrink
     * when none leads on.
     */
    double densest(Convex first, Convex second) {
        double best = Double.NEGATIVE_INFINITY;
        double[] n = new double[3];
        for (int i = 0; i < 5000; i++) {
            double[] d = direction(3);
            double apart = separation(first, second, d[0], d[1], d[2]);
            if (apart > best) {
                best = apart;
                n = d;
            }
        }
        for (double step = 0.1; step > 1e-7; step /= 2) {
            for (int i = 0; i < 100; i++) {
                double[] d = direction(3);
                double length = 0;
                for (int axis = 0; axis < 3; axis++) {
                    d[axis] = n[axis] + step * d[axis];
                    length += d[axis] * d[axis];
                }
                double scale = 1 / Math.sqrt(length);
                double apart = separation(first, second, scale * d[0], scale * d[1], scale * d[2]);
                if (apart > best) {
                    best = apart;
                    n = new double[] {scale * d[0], scale * d[1], scale * d[2]};
                }
            }
        }
        return best;
    }
}
