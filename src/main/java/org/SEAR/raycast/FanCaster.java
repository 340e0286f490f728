// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.solid.Patches;
import org.SEAR.raycast.solid.RayBox;
import org.SEAR.raycast.solid.RaySolid;
import org.SEAR.raycast.tree.Bvh;

/**
 * Casts plane fans, such as a LIDAR's. All rays of a fan lie in one plane, which reduces the problem to two dimensions.
 * The hierarchy is walked once per fan. The plane cuts the surface of each shape in lines or a curve ({@link BoxCut},
 * {@link PatchCut}, {@link FanHeights}). Each line is drawn into a {@link DepthBuffer} with one entry per ray, for the
 * rays between its ends only. Boxes behind the hits of all their rays are skipped. This is scan conversion with one
 * dimension less. It is exact because each ray intersects the line itself, not a pixel.
 *
 * <p>One thread. Allocates only for a new fan pattern.
 */
final class FanCaster {
    private final RayCaster rays;
    private final DepthBuffer depth = new DepthBuffer();
    private final PlaneCut world = new PlaneCut();
    private final TriangleCut triangles = new TriangleCut(depth);
    private final PatchCut cut = new PatchCut(depth, triangles);
    private final FanHeights heights = new FanHeights(depth, triangles);
    private final CutStack stack = new CutStack(depth, world);
    private final CutStack meshStack = new CutStack(depth, triangles.plane);
    private final BoxCut boxCut = new BoxCut();
    private final double[] axes = new double[9];
    private final double[] own = new double[12];
    private final Hit hit = new Hit();
    private Shapes shapes;
    private double ox;
    private double oy;
    private double oz;
    private double range;

    FanCaster(RayCaster rays) {
        this.rays = rays;
    }

    void cast(Shapes scene, Bvh tree, Pose pose, double start, double step, int count, double maxRange, int ignored,
        double[] ranges, int[] hits) {
        shapes = scene;
        ox = pose.x;
        oy = pose.y;
        oz = pose.z;
        Rotation.write(pose.qx, pose.qy, pose.qz, pose.qw, axes, 0);
        depth.start(start, step, count, maxRange);
        if (depth.beams.regular) {
            range = maxRange;
            scene(tree, ignored);
            for (int i = 0; i < count; i++) {
                boolean hit = depth.shape[i] >= 0;
                ranges[i] = hit ? Math.min(maxRange, 1 / depth.inverse[i]) : Double.POSITIVE_INFINITY;
            }
        } else {
            for (int i = 0; i < count; i++) {
                ranges[i] = single(tree, i, maxRange, ignored);
            }
        }
        if (hits != null) {
            System.arraycopy(depth.shape, 0, hits, 0, count);
        }
    }

    private double single(Bvh tree, int beam, double maxRange, int ignored) {
        double x = depth.beams.x[beam];
        double z = depth.beams.z[beam];
        hit.shape = -1;
        double t = rays.cast(shapes, tree, ox, oy, oz, axes[0] * x + axes[2] * z, axes[3] * x + axes[5] * z, axes[6] * x
            + axes[8] * z, maxRange, ignored, hit);
        depth.shape[beam] = hit.shape;
        return t;
    }

    private void scene(Bvh tree, int ignored) {
        world.xa = axes[0];
        world.xb = axes[3];
        world.xc = axes[6];
        world.xd = -(axes[0] * ox + axes[3] * oy + axes[6] * oz);
        world.ha = axes[1];
        world.hb = axes[4];
        world.hc = axes[7];
        world.hd = -(axes[1] * ox + axes[4] * oy + axes[7] * oz);
        world.za = axes[2];
        world.zb = axes[5];
        world.zc = axes[8];
        world.zd = -(axes[2] * ox + axes[5] * oy + axes[8] * oz);
        world.ready(tree.farthest(0), tree.farthest(1), tree.farthest(2), range);
        stack.start();
        stack.pushRoot(tree);
        for (int node = (int) stack.pop(); node >= 0; node = (int) stack.pop()) {
            rays.fanNodes++;
            int n = tree.count(node);
            if (n == 0) {
                stack.pushChildren(tree, node);
            }
            int first = tree.link(node);
            for (int i = first; i < first + n; i++) {
                if (shapes.isSeen(tree.items[i], ignored)) {
                    shape(tree.items[i]);
                }
            }
        }
    }

    private void shape(int number) {
        rays.tested++;
        double[] m = shapes.data;
        int i = number * Shapes.STRIDE;
        double wx = ox - m[i + 9];
        double wy = oy - m[i + 10];
        double wz = oz - m[i + 11];
        for (int k = 0; k < 3; k++) {
            double a = m[i + k];
            double b = m[i + 3 + k];
            double c = m[i + 6 + k];
            own[k] = a * wx + b * wy + c * wz;
            own[3 + k] = a * axes[0] + b * axes[3] + c * axes[6];
            own[6 + k] = a * axes[1] + b * axes[4] + c * axes[7];
            own[9 + k] = a * axes[2] + b * axes[5] + c * axes[8];
        }
        double a = m[i + 12];
        double b = m[i + 13];
        double c = m[i + 14];
        switch (shapes.kind[number]) {
            case Shapes.BOX:
                box(number, a, b, c);
                break;
            case Shapes.CONVEX:
                convex(number, a, b, c);
                break;
            case Shapes.HEIGHTS:
                triangles.start(own, number, 1, 1, 1);
                heights.cast(shapes.heights[number], own[0], own[2], range);
                rays.fanNodes += heights.nodes;
                rays.triangles += heights.triangles;
                break;
            case Shapes.TILES:
                tiles(number);
                break;
            default:
                mesh(number, a, b, c);
        }
    }

    private void box(int number, double hx, double hy, double hz) {
        if (boxCut.touches(own, hx, hy, hz, TriangleCut.TOUCHING)) {
            for (int i = 0; i < depth.beams.count; i++) {
                double x = depth.beams.x[i];
                double z = depth.beams.z[i];
                depth.intersect(i, RayBox.intersect(own[0], own[1], own[2], own[3] * x + own[9] * z, own[4] * x
                    + own[10] * z, own[5] * x + own[11] * z,
                    hx, hy, hz), number);
            }
            return;
        }
        boxCut.cut(own, hx, hy, hz);
        for (int e = 0; e < boxCut.size; e++) {
            if (boxCut.turn(e) && boxCut.line(own, e)) {
                depth.line(boxCut.rightX, boxCut.rightZ, boxCut.leftX, boxCut.leftZ, boxCut.a, boxCut.b, number);
            }
        }
    }

    /** Tests the exact solid only against rays that hit the box around it. */
    private void convex(int number, double hx, double hy, double hz) {
        double x = hx * (1 + TriangleCut.TOUCHING);
        double y = hy * (1 + TriangleCut.TOUCHING);
        double z = hz * (1 + TriangleCut.TOUCHING);
        RaySolid solid = shapes.solid[number];
        if (boxCut.touches(own, x, y, z, TriangleCut.TOUCHING)) {
            for (int i = 0; i < depth.beams.count; i++) {
                convexBeam(i, number, solid);
            }
            return;
        }
        boxCut.cut(own, x, y, z);
        FanDirections beams = depth.beams;
        for (int e = 0; e < boxCut.size; e++) {
            if (!boxCut.turn(e) || !boxCut.line(own, e)) {
                continue;
            }
            int first = beams.first(boxCut.rightX, boxCut.rightZ);
            for (int i = first; i < beams.count && beams.side(i, boxCut.leftX, boxCut.leftZ) > 0; i++) {
                convexBeam(i, number, solid);
            }
            if (first != 0 && beams.side(0, boxCut.rightX, boxCut.rightZ) <= 0) {
                for (int i = 0; i < first && beams.side(i, boxCut.leftX, boxCut.leftZ) > 0; i++) {
                    convexBeam(i, number, solid);
                }
            }
        }
    }

    private void convexBeam(int beam, int number, RaySolid solid) {
        double x = depth.beams.x[beam];
        double z = depth.beams.z[beam];
        depth.intersect(beam, solid.intersect(own[0], own[1], own[2], own[3] * x + own[9] * z, own[4] * x + own[10] * z,
            own[5] * x + own[11] * z), number);
    }

    private void tiles(int number) {
        triangles.start(own, number, 1, 1, 1);
        Bvh tree = shapes.tileTrees[number].tree;
        ready(tree);
        meshStack.start();
        meshStack.pushRoot(tree);
        for (int node = (int) meshStack.pop(); node >= 0; node = (int) meshStack.pop()) {
            rays.fanNodes++;
            int n = tree.count(node);
            if (n == 0) {
                meshStack.pushChildren(tree, node);
                continue;
            }
            for (int i = tree.link(node); i < tree.link(node) + n; i++) {
                heights.cast(shapes.tiles[number].tile(tree.items[i]), own[0], own[2], range);
                rays.fanNodes += heights.nodes;
                rays.triangles += heights.triangles;
            }
            ready(tree);    // casting the tile has changed the tolerances
        }
    }

    private void ready(Bvh tree) {
        triangles.plane.ready(tree.farthest(0), tree.farthest(1), tree.farthest(2), range);
    }

    private void mesh(int number, double sx, double sy, double sz) {
        triangles.start(own, number, sx, sy, sz);
        Mesh mesh = shapes.mesh[number];
        Patches patches = mesh.patches;
        Bvh tree = patches.tree;
        ready(tree);
        meshStack.start();
        meshStack.pushRoot(tree);
        for (int node = (int) meshStack.pop(); node >= 0; node = (int) meshStack.pop()) {
            rays.fanNodes++;
            int n = tree.count(node);
            if (n == 0) {
                meshStack.pushChildren(tree, node);
                continue;
            }
            int patch = tree.link(node);
            if (!meshStack.around) {
                rays.triangles += cut.intersect(patches, patch, n, meshStack.first, meshStack.last);
                continue;
            }
            rays.triangles += n;
            int first = 9 * patches.links[patch + Patches.TRIANGLE];
            for (int at = first; at < first + 9 * n; at += 9) {
                triangles.triangle(mesh.corners, at);
            }
        }
    }
}
