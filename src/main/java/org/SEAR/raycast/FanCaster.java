package org.SEAR.raycast;

import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.solid.RaySolid;

/**
 * Casts plane fans: cuts the scene with the fan's plane and lets each beam look only at the lines that lie in its direction. Holds what one thread
 * needs for it; allocates only when a fan of another pattern comes.
 */
final class FanCaster {
    /** Metres from a surface at which the origin counts as lying on it; such a shape is tested beam by beam. */
    private static final double TOUCHING = 1e-9;

    private final RayCaster rays;
    private final DepthBuffer depth = new DepthBuffer();
    private final PlaneCut world = new PlaneCut();
    private final PlaneCut model = new PlaneCut();
    private final CutStack stack = new CutStack();
    private final CutStack meshStack = new CutStack();
    private final BoxCut boxCut = new BoxCut();
    private final double[] axes = new double[9];
    private final double[] own = new double[12];
    private final Hit hit = new Hit();
    private Shapes shapes;
    private double ox;
    private double oy;
    private double oz;
    private double reachSquared;

    FanCaster(RayCaster rays) {
        this.rays = rays;
    }

    void cast(Shapes scene, Bvh tree, Pose pose, double start, double step, int count, double maxRange, int ignored, double[] ranges, int[] hits) {
        shapes = scene;
        ox = pose.x;
        oy = pose.y;
        oz = pose.z;
        Rotation.write(pose.qx, pose.qy, pose.qz, pose.qw, axes, 0);
        depth.start(start, step, count, maxRange);
        if (depth.beams.regular) {
            reachSquared = maxRange * maxRange * (1 + 1e-12);
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
        double t = rays.cast(shapes, tree, ox, oy, oz, axes[0] * x + axes[2] * z, axes[3] * x + axes[5] * z, axes[6] * x + axes[8] * z, maxRange,
            ignored, hit);
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
        world.ready(tree);
        stack.start(tree, world, reachSquared);
        for (int node = stack.pop(depth); node >= 0; node = stack.pop(depth)) {
            rays.fanNodes++;
            int n = tree.count(node);
            if (n == 0) {
                stack.pushChildren(tree, node, world, reachSquared);
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
            default:
                mesh(number, a, b, c);
        }
    }

    private void box(int number, double hx, double hy, double hz) {
        if (boxCut.touches(own, hx, hy, hz, TOUCHING)) {
            for (int i = 0; i < depth.beams.count; i++) {
                double x = depth.beams.x[i];
                double z = depth.beams.z[i];
                depth.meet(i, RayBox.meet(own[0], own[1], own[2], own[3] * x + own[9] * z, own[4] * x + own[10] * z, own[5] * x + own[11] * z,
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

    /** Only the beams that meet the box around a convex solid are tested, each against the exact solid. */
    private void convex(int number, double hx, double hy, double hz) {
        double x = hx * (1 + TOUCHING);
        double y = hy * (1 + TOUCHING);
        double z = hz * (1 + TOUCHING);
        RaySolid solid = shapes.solid[number];
        if (boxCut.touches(own, x, y, z, TOUCHING)) {
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
        depth.meet(beam, solid.meet(own[0], own[1], own[2], own[3] * x + own[9] * z, own[4] * x + own[10] * z, own[5] * x + own[11] * z),
            number);
    }

    private void mesh(int number, double sx, double sy, double sz) {
        PlaneCut cut = model;
        cut.xa = own[3] * sx;
        cut.xb = own[4] * sy;
        cut.xc = own[5] * sz;
        cut.xd = -(own[0] * own[3] + own[1] * own[4] + own[2] * own[5]);
        cut.ha = own[6] * sx;
        cut.hb = own[7] * sy;
        cut.hc = own[8] * sz;
        cut.hd = -(own[0] * own[6] + own[1] * own[7] + own[2] * own[8]);
        cut.za = own[9] * sx;
        cut.zb = own[10] * sy;
        cut.zc = own[11] * sz;
        cut.zd = -(own[0] * own[9] + own[1] * own[10] + own[2] * own[11]);
        Mesh mesh = shapes.mesh[number];
        Bvh tree = mesh.tree;
        cut.ready(tree);
        meshStack.start(tree, cut, reachSquared);
        for (int node = meshStack.pop(depth); node >= 0; node = meshStack.pop(depth)) {
            rays.fanNodes++;
            int n = tree.count(node);
            if (n == 0) {
                meshStack.pushChildren(tree, node, cut, reachSquared);
                continue;
            }
            rays.triangles += n;
            int first = tree.link(node);
            for (int i = first; i < first + n; i++) {
                triangle(mesh.corners, 9 * i, number, sx, sy, sz);
            }
        }
    }

    private void triangle(float[] v, int at, int number, double sx, double sy, double sz) {
        PlaneCut cut = model;
        double h0 = cut.height(v[at], v[at + 1], v[at + 2]);
        double h1 = cut.height(v[at + 3], v[at + 4], v[at + 5]);
        double h2 = cut.height(v[at + 6], v[at + 7], v[at + 8]);
        boolean up0 = h0 >= 0;
        boolean up1 = h1 >= 0;
        boolean up2 = h2 >= 0;
        if (up0 == up1 && up1 == up2) {
            return;
        }
        int lone = up1 == up2 ? 0 : up0 == up2 ? 3 : 6;
        int next = lone == 6 ? 0 : lone + 3;
        int last = lone == 0 ? 6 : lone - 3;
        double hLone = lone == 0 ? h0 : lone == 3 ? h1 : h2;
        double hNext = next == 0 ? h0 : next == 3 ? h1 : h2;
        double hLast = last == 0 ? h0 : last == 3 ? h1 : h2;
        double x0 = cut.x(v[at + lone], v[at + lone + 1], v[at + lone + 2]);
        double z0 = cut.z(v[at + lone], v[at + lone + 1], v[at + lone + 2]);
        double x1 = cut.x(v[at + next], v[at + next + 1], v[at + next + 2]);
        double z1 = cut.z(v[at + next], v[at + next + 1], v[at + next + 2]);
        double x2 = cut.x(v[at + last], v[at + last + 1], v[at + last + 2]);
        double z2 = cut.z(v[at + last], v[at + last + 1], v[at + last + 2]);
        double px;
        double pz;
        double qx;
        double qz;
        if (hLone >= 0) {
            double f = hLone / (hLone - hNext);
            double g = hLone / (hLone - hLast);
            px = x0 + (x1 - x0) * f;
            pz = z0 + (z1 - z0) * f;
            qx = x0 + (x2 - x0) * g;
            qz = z0 + (z2 - z0) * g;
        } else {
            double f = hNext / (hNext - hLone);
            double g = hLast / (hLast - hLone);
            px = x1 + (x0 - x1) * f;
            pz = z1 + (z0 - z1) * f;
            qx = x2 + (x0 - x2) * g;
            qz = z2 + (z0 - z2) * g;
        }
        segment(px, pz, qx, qz, number, v, at, sx, sy, sz);
    }

    private void segment(double px, double pz, double qx, double qz, int number, float[] v, int at, double sx, double sy, double sz) {
        double turn = pz * qx - px * qz;
        double ex = qx - px;
        double ez = qz - pz;
        double length = Math.abs(ex) + Math.abs(ez);
        if (Math.abs(turn) <= TOUCHING * length) {
            if (px * qx + pz * qz <= TOUCHING * length) {
                for (int i = 0; i < depth.beams.count; i++) {
                    double x = depth.beams.x[i];
                    double z = depth.beams.z[i];
                    depth.meet(i, Mesh.triangle(v, at, own[0] / sx, own[1] / sy, own[2] / sz, (own[3] * x + own[9] * z) / sx,
                        (own[4] * x + own[10] * z) / sy, (own[5] * x + own[11] * z) / sz), number);
                }
                return;
            }
            if (turn == 0) {
                return;
            }
        }
        double a = -ez / turn;
        double b = ex / turn;
        if (turn > 0) {
            depth.line(px, pz, qx, qz, a, b, number);
        } else {
            depth.line(qx, qz, px, pz, a, b, number);
        }
    }
}
