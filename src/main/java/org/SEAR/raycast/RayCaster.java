// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.solid.RayBox;
import org.SEAR.raycast.solid.RayHeights;
import org.SEAR.raycast.solid.RayTriangle;
import org.SEAR.raycast.tree.Bvh;
import org.SEAR.raycast.tree.RayTraversal;

/** Casts single rays. One per thread, so that casting allocates nothing. */
final class RayCaster {
    /** Work since construction: hierarchy nodes visited by fans; shapes and triangles tested by any ray. */
    long fanNodes;
    long tested;
    long triangles;
    /** Boxes inside a tile's frustum, and those whose three pairs of faces were tested for each ray. */
    long boxes;
    long asked;

    /** Traversals of the scene's hierarchy and of a mesh inside it. */
    private final RayTraversal scene = new RayTraversal();
    private final RayTraversal inside = new RayTraversal();
    final RayHeights heights = new RayHeights();
    private final double[] point = new double[3];
    /** Frame of a moving shape. */
    private final double[] frame = new double[Shapes.STRIDE];
    private final Rotation rotation = new Rotation();
    /** Tile of the last successful {@link #tiles}. */
    private HeightField tile;
    /** Triangle of the last successful {@link #mesh}. */
    private int triangle;

    /** Returns the number of hierarchy nodes visited by rays and fans. */
    long nodes() {
        return fanNodes + scene.nodes + inside.nodes + heights.nodes;
    }

    /** Returns the nearest distance of a ray over all shapes that the owner sees. The lower shape number wins a tie. */
    double cast(Shapes shapes, Bvh tree, double ox, double oy, double oz, double dx, double dy, double dz,
        double maxRange, int ignored, Hit hit) {
        double best = Double.POSITIVE_INFINITY;
        int found = -1;
        double limit = maxRange;
        scene.start(tree, ox, oy, oz, dx, dy, dz);
        for (int node = scene.next(limit); node >= 0; node = scene.next(limit)) {
            int first = tree.link(node);
            int end = first + tree.count(node);
            for (int i = first; i < end; i++) {
                int shape = tree.items[i];
                if (shapes.isSeen(shape, ignored)) {
                    double t = test(shapes, shape, ox, oy, oz, dx, dy, dz, limit);
                    if (t < best && t <= maxRange || t == best && shape < found) {
                        best = t;
                        limit = t;
                        found = shape;
                    }
                }
            }
        }
        if (hit != null && found >= 0) {
            describe(shapes, found, ox, oy, oz, dx, dy, dz, best, hit);
        }
        return best;
    }

    /** Returns the nearest distance of a ray at a time, in steps, with moving shapes where they are then. */
    double castAt(ShapeMotion motion, double time, Bvh tree, double ox, double oy, double oz, double dx, double dy,
        double dz, double maxRange, int ignored) {
        double best = cast(motion.still, tree, ox, oy, oz, dx, dy, dz, maxRange, ignored, null);
        for (int i = 0; i < motion.count; i++) {
            double limit = Math.min(best, maxRange);
            int shape = motion.shape(i);
            if (motion.isSeen(shape, ignored) && motion.isNear(i, time, ox, oy, oz, dx, dy, dz, limit)) {
                motion.place(i, time, rotation, frame);
                double t = test(motion.still, shape, frame, 0, ox, oy, oz, dx, dy, dz, limit);
                best = t <= limit ? t : best;
            }
        }
        return best;
    }

    /** Returns the distance to one shape. */
    double test(Shapes shapes, int shape, double ox, double oy, double oz, double dx, double dy, double dz,
        double limit) {
        return test(shapes, shape, shapes.data, shape * Shapes.STRIDE, ox, oy, oz, dx, dy, dz, limit);
    }

    /** Returns the distance to one shape in the frame from {@code m[i]} on. */
    private double test(Shapes shapes, int shape, double[] m, int i, double ox, double oy, double oz, double dx,
        double dy, double dz, double limit) {
        tested++;
        double wx = ox - m[i + 9];
        double wy = oy - m[i + 10];
        double wz = oz - m[i + 11];
        double px = m[i] * wx + m[i + 3] * wy + m[i + 6] * wz;
        double py = m[i + 1] * wx + m[i + 4] * wy + m[i + 7] * wz;
        double pz = m[i + 2] * wx + m[i + 5] * wy + m[i + 8] * wz;
        double vx = m[i] * dx + m[i + 3] * dy + m[i + 6] * dz;
        double vy = m[i + 1] * dx + m[i + 4] * dy + m[i + 7] * dz;
        double vz = m[i + 2] * dx + m[i + 5] * dy + m[i + 8] * dz;
        double a = m[i + 12];
        double b = m[i + 13];
        double c = m[i + 14];
        switch (shapes.kind[shape]) {
            case Shapes.BOX:
                return RayBox.intersect(px, py, pz, vx, vy, vz, a, b, c);
            case Shapes.CONVEX:
                return shapes.solid[shape].intersect(px, py, pz, vx, vy, vz);
            case Shapes.HEIGHTS:
                return heights(shapes.heights[shape], px, py, pz, vx, vy, vz, limit);
            case Shapes.TILES:
                return tiles(shapes.tiles[shape], shapes.tileTrees[shape].tree, px, py, pz, vx, vy, vz, limit);
            default:
                return mesh(shapes.mesh[shape], px / a, py / b, pz / c, vx / a, vy / b, vz / c, limit);
        }
    }

    /** Returns the triangle that was last hit in this mesh, as numbered in its {@link Triangles}. */
    int triangle(Mesh mesh) {
        return mesh.order[triangle];
    }

    private double heights(HeightField field, double ox, double oy, double oz, double dx, double dy, double dz,
        double maxRange) {
        long before = heights.triangles;
        double t = heights.intersect(field, ox, oy, oz, dx, dy, dz, maxRange);
        triangles += heights.triangles - before;
        return t;
    }

    private double tiles(HeightTiles tiles, Bvh tree, double ox, double oy, double oz, double dx, double dy, double dz,
        double maxRange) {
        double best = Double.POSITIVE_INFINITY;
        double limit = maxRange;
        inside.start(tree, ox, oy, oz, dx, dy, dz);
        for (int node = inside.next(limit); node >= 0; node = inside.next(limit)) {
            HeightField next = tiles.tile(tree.items[tree.link(node)]);
            double t = heights(next, ox, oy, oz, dx, dy, dz, limit);
            if (t <= limit && t < Double.POSITIVE_INFINITY) {
                best = t;
                limit = t;
                tile = next;
            }
        }
        return best;
    }

    private double mesh(Mesh mesh, double ox, double oy, double oz, double dx, double dy, double dz, double maxRange) {
        Bvh tree = mesh.tree;
        double best = Double.POSITIVE_INFINITY;
        double limit = maxRange;
        inside.start(tree, ox, oy, oz, dx, dy, dz);
        for (int node = inside.next(limit); node >= 0; node = inside.next(limit)) {
            int first = tree.link(node);
            int end = first + tree.count(node);
            triangles += end - first;
            for (int i = first; i < end; i++) {
                double t = RayTriangle.intersect(mesh.corners, 9 * i, ox, oy, oz, dx, dy, dz);
                if (t <= limit && (t < best || t == best && i < triangle)) {
                    best = t;
                    limit = t;
                    triangle = i;
                }
            }
        }
        return best;
    }

    private void describe(Shapes shapes, int shape, double ox, double oy, double oz, double dx, double dy, double dz,
        double t, Hit hit) {
        hit.shape = shape;
        hit.distance = t;
        double[] m = shapes.data;
        int i = shape * Shapes.STRIDE;
        double a = m[i + 12];
        double b = m[i + 13];
        double c = m[i + 14];
        if (shapes.kind[shape] == Shapes.MESH) {
            test(shapes, shape, ox, oy, oz, dx, dy, dz, t);
            RayTriangle.normal(shapes.mesh[shape].corners, 9 * triangle, point);
            point[0] /= a;
            point[1] /= b;
            point[2] /= c;
        } else if (shapes.kind[shape] == Shapes.HEIGHTS) {
            test(shapes, shape, ox, oy, oz, dx, dy, dz, t);
            heights.normal(shapes.heights[shape], point);
        } else if (shapes.kind[shape] == Shapes.TILES) {
            test(shapes, shape, ox, oy, oz, dx, dy, dz, t);
            heights.normal(tile, point);
        } else {
            double wx = ox + t * dx - m[i + 9];
            double wy = oy + t * dy - m[i + 10];
            double wz = oz + t * dz - m[i + 11];
            point[0] = m[i] * wx + m[i + 3] * wy + m[i + 6] * wz;
            point[1] = m[i + 1] * wx + m[i + 4] * wy + m[i + 7] * wz;
            point[2] = m[i + 2] * wx + m[i + 5] * wy + m[i + 8] * wz;
            if (shapes.kind[shape] == Shapes.BOX) {
                RayBox.normal(point, a, b, c);
            } else {
                shapes.solid[shape].normal(point);
            }
        }
        double nx = m[i] * point[0] + m[i + 1] * point[1] + m[i + 2] * point[2];
        double ny = m[i + 3] * point[0] + m[i + 4] * point[1] + m[i + 5] * point[2];
        double nz = m[i + 6] * point[0] + m[i + 7] * point[1] + m[i + 8] * point[2];
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        hit.nx = nx / length;
        hit.ny = ny / length;
        hit.nz = nz / length;
    }
}
