// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.start;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.collision.Convex;
import org.SEAR.collision.ConvexShape;
import org.SEAR.collision.GjkDistance;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.solid.Solid;

/** Tests whether bodies overlap at given poses, in double precision from their exact shapes. Too slow for each step. */
final class Overlap {
    /** Leans to test, metres per metre along x and z. */
    private static final double[][] LEANS = {{0, 0}, {0.1, 0.1}, {0.1, -0.1}, {-0.1, 0.1}, {-0.1, -0.1}, {0.2, 0},
        {-0.2, 0}, {0, 0.2}, {0, -0.2}};

    /** Least thickness of a closed mesh around a body that is a room, as a multiple of the body's size. */
    private static final double ROOM = 2;

    private final Body body;
    private final GjkDistance gjk = new GjkDistance();
    /** Largest depth of all measurements since it was set to 0, metres. */
    private double deepest;

    Overlap(Body body) {
        this.body = body;
    }

    Body getBody() {
        return body;
    }

    /** Returns the colliding parts of a body's solid at a pose of the body. */
    private static List<Placed> parts(Body of, int solid, Pose pose) {
        Pose place = pose.times(of.places[solid]);
        Solid whole = of.solids.get(solid);
        List<Placed> parts = new ArrayList<>();
        if (whole.isMesh() || whole.pieces().size() == 1) {
            parts.add(new Placed(whole::farthest, place));
        } else {
            whole.pieces().forEach(piece -> parts.add(new Placed((x, y, z) -> farthest(piece, x, y, z), place)));
        }
        return parts;
    }

    private static double[] farthest(ConvexShape shape, double x, double y, double z) {
        double[] point = new double[3];
        shape.support(x, y, z, point);
        return point;
    }

    /** Returns the bounding box of the body at a pose. */
    Aabb bounds(Pose pose) {
        Aabb box = new Aabb();
        double[] low = new double[3];
        double[] high = new double[3];
        for (int i = 0; i < body.solids.size(); i++) {
            Placed part = new Placed(body.solids.get(i)::farthest, pose.times(body.places[i]));
            for (int axis = 0; axis < 3; axis++) {
                part.support(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0, high);
                box.add(high[0], high[1], high[2]);
                part.support(axis == 0 ? -1 : 0, axis == 1 ? -1 : 0, axis == 2 ? -1 : 0, low);
                box.add(low[0], low[1], low[2]);
            }
        }
        return box;
    }

    /** Returns the lowest points at a pose and at small leans to all sides, in the body's frame. */
    double[][] lowest(Pose pose) {
        double[][] points = new double[body.solids.size() * LEANS.length][];
        for (int i = 0; i < points.length; i++) {
            int part = i / LEANS.length;
            double[] lean = LEANS[i % LEANS.length];
            double[] down = pose.times(body.places[part]).rotateBack(lean[0], -1, lean[1]);
            double[] point = body.solids.get(part).farthest(down[0], down[1], down[2]);
            points[i] = body.places[part].transform(point[0], point[1], point[2]);
        }
        return points;
    }

    /** Whether the body at a pose overlaps another at its start by more than {@code allowed} metres. */
    boolean overlaps(Pose pose, Overlap other, double allowed) {
        return overlaps(pose, other, other.body.getStart(), allowed);
    }

    /** The same with the other body at another pose. */
    boolean overlaps(Pose pose, Overlap other, Pose otherPose, double allowed) {
        for (int i = 0; i < body.solids.size(); i++) {
            for (Placed mine : parts(body, i, pose)) {
                for (int k = 0; k < other.body.solids.size(); k++) {
                    Solid solid = other.body.solids.get(k);
                    Pose place = otherPose.times(other.body.places[k]);
                    if (solid.isMesh() ? intersects(mine, bounds(pose), solid, place, allowed)
                            : isDeeper(mine, parts(other.body, k, otherPose), allowed)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /** Whether the body at a pose overlaps another one, or its centre of mass is inside a closed mesh of it. */
    boolean isIn(Pose pose, Overlap other, Pose otherPose) {
        return overlaps(pose, other, otherPose, 0) || isEnclosed(pose, other, otherPose, Double.POSITIVE_INFINITY);
    }

    /**
     * Whether the body at a pose overlaps another one by more than {@code allowed} metres, or is inside a closed mesh
     * of it that is too thin for a room.
     */
    boolean isStuck(Pose pose, Overlap other, Pose otherPose, double allowed) {
        return overlaps(pose, other, otherPose, allowed) || isEnclosed(pose, other, otherPose, ROOM * size(pose));
    }

    private double size(Pose pose) {
        Aabb box = bounds(pose);
        return Math.max(box.maxX - box.minX, Math.max(box.maxY - box.minY, box.maxZ - box.minZ));
    }

    /** Whether the centre of mass is inside a closed mesh that is thinner than a limit, metres. */
    private boolean isEnclosed(Pose pose, Overlap other, Pose otherPose, double limit) {
        double[] centre = body.getCentre();
        double[] at = pose.transform(centre[0], centre[1], centre[2]);
        boolean inside = false;
        for (int i = 0; i < other.body.solids.size() && !inside; i++) {
            Pose place = otherPose.times(other.body.places[i]);
            double[] own = place.rotateBack(at[0] - place.x, at[1] - place.y, at[2] - place.z);
            Solid solid = other.body.solids.get(i);
            inside = solid.isMesh() && solid.thickness() < limit && solid.encloses(own[0], own[1], own[2]);
        }
        return inside;
    }

    private boolean isDeeper(Convex mine, List<Placed> others, double allowed) {
        boolean deeper = false;
        for (int i = 0; i < others.size() && !deeper; i++) {
            deeper = isDeeper(mine, others.get(i), allowed);
        }
        return deeper;
    }

    /** Returns the largest depth of the body at a pose in another at its start, metres. */
    double depth(Pose pose, Overlap other) {
        deepest = 0;
        overlaps(pose, other, Double.POSITIVE_INFINITY);
        return deepest;
    }

    private boolean isDeeper(Convex mine, Convex other, double allowed) {
        if (!gjk.measure(mine, other, 0)) {
            return false;
        }
        deepest = Math.max(deepest, -gjk.distance);
        return gjk.distance < -allowed;
    }

    private boolean intersects(Placed mine, Aabb box, Solid solid, Pose place, double allowed) {
        Corners corners = new Corners();
        return solid.anyTriangle(inFrame(box, place), at -> {
            corners.set(at, place);
            return corners.near(box) && isDeeper(mine, corners, allowed);
        });
    }

    /** Returns the bounding box of a box in another frame. */
    private static Aabb inFrame(Aabb box, Pose frame) {
        Aabb around = new Aabb();
        Vec3 corner = new Vec3();
        for (int i = 0; i < 8; i++) {
            box.corner(i, corner);
            double[] at = frame.rotateBack(corner.x - frame.x, corner.y - frame.y, corner.z - frame.z);
            around.add(at[0], at[1], at[2]);
        }
        return around;
    }

    /** Finds the furthest point of a shape in a direction, both in its frame. */
    private interface Farthest {
        double[] point(double x, double y, double z);
    }

    /** Convex shape at a pose. */
    private static final class Placed implements Convex {
        private final Farthest shape;
        private final Pose pose;

        Placed(Farthest shape, Pose pose) {
            this.shape = shape;
            this.pose = pose;
        }

        @Override
        public void support(double dx, double dy, double dz, double[] into) {
            double[] inside = pose.rotateBack(dx, dy, dz);
            double[] point = shape.point(inside[0], inside[1], inside[2]);
            double[] world = pose.transform(point[0], point[1], point[2]);
            System.arraycopy(world, 0, into, 0, 3);
        }
    }

    /** Triangle. */
    private static final class Corners implements Convex {
        private final double[][] at = new double[3][];
        private final Aabb around = new Aabb();

        void set(double[] corners, Pose place) {
            around.clear();
            for (int i = 0; i < at.length; i++) {
                at[i] = place.transform(corners[3 * i], corners[3 * i + 1], corners[3 * i + 2]);
                around.add(at[i][0], at[i][1], at[i][2]);
            }
        }

        boolean near(Aabb box) {
            return around.overlaps(box);
        }

        @Override
        public void support(double dx, double dy, double dz, double[] into) {
            double best = Double.NEGATIVE_INFINITY;
            for (double[] corner : at) {
                double along = corner[0] * dx + corner[1] * dy + corner[2] * dz;
                if (along > best) {
                    best = along;
                    System.arraycopy(corner, 0, into, 0, 3);
                }
            }
        }
    }
}
