// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;

/**
 * Expected hits of beams, computed slowly and independently of the code under test: every shape in the world's frame by
 * textbook vector formulas (planes, cross products, apex and axis).
 */
final class Oracle {
    private static final double MISS = Double.POSITIVE_INFINITY;

    /** One shape in the world. */
    interface Surface {
        /** Nearest distance >= 0 along the unit direction. */
        double meet(double[] o, double[] d);
    }

    final List<Surface> surfaces = new ArrayList<>();

    double cast(double[] o, double[] d, double maxRange) {
        double best = MISS;
        for (Surface surface : surfaces) {
            double t = surface.meet(o, d);
            if (t <= maxRange && t < best) {
                best = t;
            }
        }
        return best;
    }

    static double[] add(double[] a, double[] b, double f) {
        return new double[] {a[0] + f * b[0], a[1] + f * b[1], a[2] + f * b[2]};
    }

    static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }

    /** Returns the world directions of a pose's three axes. */
    static double[][] axes(Pose pose) {
        return new double[][] {pose.rotate(1, 0, 0), pose.rotate(0, 1, 0), pose.rotate(0, 0, 1)};
    }

    /** Tests the six squares of a box, each in its plane. */
    static Surface box(Pose pose, double hx, double hy, double hz) {
        double[] half = {hx, hy, hz};
        double[] centre = {pose.x, pose.y, pose.z};
        double[][] axes = axes(pose);
        return (o, d) -> {
            double best = MISS;
            for (int face = 0; face < 6; face++) {
                int k = face / 2;
                double[] normal = axes[k];
                double[] point = add(centre, normal, face % 2 == 0 ? half[k] : -half[k]);
                double t = dot(add(point, o, -1), normal) / dot(d, normal);
                double[] at = add(add(o, d, t), centre, -1);
                boolean in = Math.abs(dot(at, axes[(k + 1) % 3])) <= half[(k + 1) % 3]
                    && Math.abs(dot(at, axes[(k + 2) % 3])) <= half[(k + 2) % 3];
                if (in && t >= 0 && t < best) {
                    best = t;
                }
            }
            return best;
        };
    }

    private static double disc(double[] centre, double[] axis, double radius, double[] o, double[] d) {
        double t = dot(add(centre, o, -1), axis) / dot(d, axis);
        double[] off = add(add(o, d, t), centre, -1);
        return t >= 0 && dot(off, off) <= radius * radius ? t : MISS;
    }

    /** Tests the distance of the beam's points from the axis by cross products, and two discs. */
    static Surface cylinder(Pose pose, double radius, double h) {
        double[] centre = {pose.x, pose.y, pose.z};
        double[] axis = axes(pose)[1];
        return (o, d) -> {
            double[] w = cross(add(o, centre, -1), axis);
            double[] v = cross(d, axis);
            double best = Math.min(disc(add(centre, axis, h), axis, radius, o, d),
                disc(add(centre, axis, -h), axis, radius, o, d));
            double middle = -dot(w, v) / dot(v, v);
            double[] nearest = add(w, v, middle);
            double rest = radius * radius - dot(nearest, nearest);
            if (rest >= 0) {
                double half = Math.sqrt(rest / dot(v, v));
                for (double t : new double[] {middle - half, middle + half}) {
                    double along = dot(add(add(o, d, t), centre, -1), axis);
                    if (t >= 0 && Math.abs(along) <= h) {
                        best = Math.min(best, t);
                    }
                }
            }
            return best;
        };
    }

    /** Tests points whose direction from the apex makes the half-angle with the axis, and one disc. */
    static Surface cone(Pose pose, double radius, double h) {
        double[] axis = axes(pose)[1];
        double[] centre = {pose.x, pose.y, pose.z};
        double[] apex = add(centre, axis, h);
        double cos2 = 4 * h * h / (4 * h * h + radius * radius);
        return (o, d) -> {
            double[] w = add(o, apex, -1);
            double best = disc(add(centre, axis, -h), axis, radius, o, d);
            double a = dot(d, axis) * dot(d, axis) - cos2;
            double b = 2 * (dot(d, axis) * dot(w, axis) - cos2 * dot(d, w));
            double c = dot(w, axis) * dot(w, axis) - cos2 * dot(w, w);
            double rest = b * b - 4 * a * c;
            if (rest >= 0) {
                for (double t : new double[] {(-b - Math.sqrt(rest)) / (2 * a), (-b + Math.sqrt(rest)) / (2 * a)}) {
                    double below = -dot(add(w, d, t), axis);
                    if (t >= 0 && below >= 0 && below <= 2 * h) {
                        best = Math.min(best, t);
                    }
                }
            }
            return best;
        };
    }

    /**
     * Solves for points whose coordinates along the axes, divided by the half sizes, have squares that sum to 1. It
     * starts from the beam's point beside the centre.
     */
    static Surface ellipsoid(Pose pose, double... half) {
        double[] centre = {pose.x, pose.y, pose.z};
        double[][] axes = axes(pose);
        return (o, d) -> {
            double beside = dot(add(centre, o, -1), d);
            double[] w = add(add(o, d, beside), centre, -1);
            double a = 0;
            double b = 0;
            double c = -1;
            for (int k = 0; k < 3; k++) {
                double along = dot(d, axes[k]) / half[k];
                double at = dot(w, axes[k]) / half[k];
                a += along * along;
                b += 2 * along * at;
                c += at * at;
            }
            double rest = b * b - 4 * a * c;
            if (rest < 0) {
                return MISS;
            }
            double near = beside + (-b - Math.sqrt(rest)) / (2 * a);
            double far = beside + (-b + Math.sqrt(rest)) / (2 * a);
            return near >= 0 ? near : far >= 0 ? far : MISS;
        };
    }

    /** Tests every triangle: its plane, then the side of its three edges. */
    static Surface mesh(Pose pose, Triangles triangles, double sx, double sy, double sz) {
        double[][] corner = new double[triangles.vertices.length / 3][];
        for (int i = 0; i < corner.length; i++) {
            corner[i] = pose.transform(triangles.vertices[3 * i] * sx, triangles.vertices[3 * i + 1] * sy,
                triangles.vertices[3 * i + 2] * sz);
        }
        return (o, d) -> {
            double best = MISS;
            for (int i = 0; i < triangles.indices.length; i += 3) {
                double[] a = corner[triangles.indices[i]];
                double[] b = corner[triangles.indices[i + 1]];
                double[] c = corner[triangles.indices[i + 2]];
                double[] normal = cross(add(b, a, -1), add(c, a, -1));
                double t = dot(add(a, o, -1), normal) / dot(d, normal);
                double[] p = add(o, d, t);
                boolean in = dot(cross(add(b, a, -1), add(p, a, -1)), normal) >= 0
                    && dot(cross(add(c, b, -1), add(p, b, -1)), normal) >= 0
                    && dot(cross(add(a, c, -1), add(p, c, -1)), normal) >= 0;
                if (in && t >= 0 && t < best) {
                    best = t;
                }
            }
            return best;
        };
    }
}
