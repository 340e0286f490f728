// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.solid.RayRound;

/** Solids both in a beam scene and as exact distance functions for ray marching. The two methods share no code. */
final class MarchedWorld {
    private static final double CLOSE = 1e-7;
    private static final int STEPS = 200_000;

    final BeamScene scene = new BeamScene();
    private final List<Solid> solids = new ArrayList<>();

    /** Distance from a point of its own frame to its surface. */
    private interface Surface {
        double distance(double x, double y, double z);
    }

    private static final class Solid {
        final int shape;
        final int owner;
        final Surface surface;
        Pose pose;

        Solid(int shape, int owner, Surface surface) {
            this.shape = shape;
            this.owner = owner;
            this.surface = surface;
        }
    }

    int box(double halfX, double halfY, double halfZ, int owner) {
        return add(scene.addBox(halfX, halfY, halfZ, owner), owner, (x, y, z) -> {
            double qx = Math.abs(x) - halfX;
            double qy = Math.abs(y) - halfY;
            double qz = Math.abs(z) - halfZ;
            double outside = Math.sqrt(sq(Math.max(qx, 0)) + sq(Math.max(qy, 0)) + sq(Math.max(qz, 0)));
            return outside > 0 ? outside : -Math.max(qx, Math.max(qy, qz));
        });
    }

    int cylinder(double radius, double half, int owner) {
        return add(scene.addSolid(RayRound.cylinder(radius, half), owner), owner, (x, y, z) -> {
            double r = Math.sqrt(x * x + z * z);
            return Math.min(segment(r, y, 0, half, radius, half),
                Math.min(segment(r, y, radius, half, radius, -half), segment(r, y, radius, -half, 0, -half)));
        });
    }

    int cone(double radius, double half, int owner) {
        return add(scene.addSolid(RayRound.cone(radius, half), owner), owner, (x, y, z) -> {
            double r = Math.sqrt(x * x + z * z);
            return Math.min(segment(r, y, 0, half, radius, -half), segment(r, y, radius, -half, 0, -half));
        });
    }

    private static double sq(double value) {
        return value * value;
    }

    /** Returns the distance from a point of the (radius, y) half-plane to a segment in it. */
    private static double segment(double r, double y, double r1, double y1, double r2, double y2) {
        double t = ((r - r1) * (r2 - r1) + (y - y1) * (y2 - y1)) / (sq(r2 - r1) + sq(y2 - y1));
        double clamped = Math.max(0, Math.min(1, t));
        return Math.sqrt(sq(r - r1 - clamped * (r2 - r1)) + sq(y - y1 - clamped * (y2 - y1)));
    }

    private int add(int shape, int owner, Surface surface) {
        solids.add(new Solid(shape, owner, surface));
        return shape;
    }

    void move(int shape, Pose pose) {
        scene.setPose(shape, pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw);
        for (Solid solid : solids) {
            if (solid.shape == shape) {
                solid.pose = pose;
            }
        }
    }

    /** Places every solid at random within a cube about the origin. */
    void scatter(Random random, double size) {
        for (Solid solid : solids) {
            move(solid.shape, pose(random, size));
        }
        scene.commit();
    }

    static Pose pose(Random random, double size) {
        return Pose.ofDegrees(size * (random.nextDouble() - 0.5), size * (random.nextDouble() - 0.5),
            size * (random.nextDouble() - 0.5),
            360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
    }

    static MarchedWorld random(Random random, int count, int owner) {
        MarchedWorld world = new MarchedWorld();
        for (int i = 0; i < count; i++) {
            int whose = i == 0 ? owner : BeamScene.WORLD;
            double a = 0.05 + random.nextDouble();
            double b = 0.05 + random.nextDouble();
            switch (i % 3) {
                case 0:
                    world.box(a, b, 0.05 + random.nextDouble(), whose);
                    break;
                case 1:
                    world.cylinder(a, b, whose);
                    break;
                default:
                    world.cone(a, b, whose);
            }
        }
        return world;
    }

    /** Returns the range of a beam by ray marching: each step is as long as the distance to the nearest solid. */
    double march(double[] origin, double[] direction, double maxRange, int ignoredOwner) {
        double far = 0;
        for (int step = 0; step < STEPS && far <= maxRange; step++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (Solid solid : solids) {
                if (solid.owner == BeamScene.WORLD || solid.owner != ignoredOwner) {
                    Pose p = solid.pose;
                    double[] in = p.rotateBack(origin[0] + far * direction[0] - p.x,
                        origin[1] + far * direction[1] - p.y, origin[2] + far * direction[2] - p.z);
                    nearest = Math.min(nearest, solid.surface.distance(in[0], in[1], in[2]));
                }
            }
            if (nearest < CLOSE) {
                return far;
            }
            far += nearest;
        }
        return Double.POSITIVE_INFINITY;
    }
}
