package org.SEAR.simulator;

import com.bulletphysics.collision.broadphase.CollisionAlgorithm;
import com.bulletphysics.collision.broadphase.CollisionAlgorithmConstructionInfo;
import com.bulletphysics.collision.broadphase.DispatcherInfo;
import com.bulletphysics.collision.dispatch.CollisionAlgorithmCreateFunc;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.ConvexPenetrationDepthSolver;
import com.bulletphysics.collision.narrowphase.DiscreteCollisionDetectorInterface;
import com.bulletphysics.collision.narrowphase.GjkPairDetector;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import com.bulletphysics.collision.narrowphase.SimplexSolverInterface;
import com.bulletphysics.collision.shapes.ConvexShape;
import com.bulletphysics.linearmath.Transform;
import com.bulletphysics.util.ObjectArrayList;
import javax.vecmath.Vector3f;

/**
 * The contact of two boxes, cylinders or cones. jbullet's GJK gives the direction in which they are nearest, but one point in a step; here what both
 * turn to each other is cut to the part that they share, and its outermost corners are the contact, all in the same step and in exact geometry. So
 * things stand still. Where no face is part of it (edge on edge), GJK's point stands. Simulation thread.
 */
final class ContactPatch extends CollisionAlgorithm {
    /** Surfaces this close already carry each other, metres: a face that rests has all its corners in touch. */
    static final float SKIN = 5e-4f;
    /** Surfaces farther apart than this have no contact, metres; jbullet's own limit. */
    private static final float BREAKING = 0.02f;
    /** A face whose normal has at least this cosine to the direction of the contact is part of it (6 degrees). */
    private static final double ALIGNED = 0.995;
    /** Faces of both are equally good within this. */
    private static final double EVEN = 1e-3;
    private static final int CORNERS = 4;

    private final GjkPairDetector detector = new GjkPairDetector();
    private final DiscreteCollisionDetectorInterface.ClosestPointInput input = new DiscreteCollisionDetectorInterface.ClosestPointInput();
    private final Nearest nearest = new Nearest();
    private final SimplexSolverInterface simplex;
    private final ConvexPenetrationDepthSolver depths;
    private final PersistentManifold shared;
    private final Feature featureA = new Feature();
    private final Feature featureB = new Feature();
    private final int[] chosen = new int[CORNERS];
    private final Vector3f direction = new Vector3f();
    private final Vector3f point = new Vector3f();
    private PersistentManifold manifold;

    private ContactPatch(CollisionAlgorithmConstructionInfo info, SimplexSolverInterface simplex, ConvexPenetrationDepthSolver depths) {
        init(info);
        this.simplex = simplex;
        this.depths = depths;
        shared = info.manifold;
        manifold = shared;
    }

    /** Makes them for a world. */
    static final class Maker extends CollisionAlgorithmCreateFunc {
        private final SimplexSolverInterface simplex;
        private final ConvexPenetrationDepthSolver depths;

        Maker(SimplexSolverInterface simplex, ConvexPenetrationDepthSolver depths) {
            this.simplex = simplex;
            this.depths = depths;
        }

        @Override
        public CollisionAlgorithm createCollisionAlgorithm(CollisionAlgorithmConstructionInfo info, CollisionObject a, CollisionObject b) {
            return new ContactPatch(info, simplex, depths);
        }

        @Override
        public void releaseCollisionAlgorithm(CollisionAlgorithm algorithm) {
            // garbage collection does
        }
    }

    /** What GJK answers. */
    private static final class Nearest extends DiscreteCollisionDetectorInterface.Result {
        private final Vector3f normal = new Vector3f();
        private final Vector3f pointOnB = new Vector3f();
        private float distance;
        private boolean found;

        @Override
        public void setShapeIdentifiers(int partId0, int index0, int partId1, int index1) {
            found = false;
        }

        @Override
        public void addContactPoint(Vector3f normalOnB, Vector3f pointInWorld, float depth) {
            normal.set(normalOnB);
            pointOnB.set(pointInWorld);
            distance = depth;
            found = true;
        }
    }

    @Override
    public void processCollision(CollisionObject a, CollisionObject b, DispatcherInfo info, ManifoldResult result) {
        if (manifold == null) {
            manifold = dispatcher.getNewManifold(a, b);
        }
        result.setPersistentManifold(manifold);
        ConvexShape shapeA = (ConvexShape) a.getCollisionShape();
        ConvexShape shapeB = (ConvexShape) b.getCollisionShape();
        a.getWorldTransform(input.transformA);
        b.getWorldTransform(input.transformB);
        float reach = shapeA.getMargin() + shapeB.getMargin() + BREAKING;
        input.maximumDistanceSquared = reach * reach;
        detector.init(shapeA, shapeB, simplex, depths);
        nearest.found = false;
        detector.getClosestPoints(input, nearest, info.debugDraw, false);
        if (nearest.found && !patch((Solid) shapeA.getUserPointer(), (Solid) shapeB.getUserPointer(), result)) {
            float outA = outside(shapeA);
            float outB = outside(shapeB);
            point.scaleAdd(-outB, nearest.normal, nearest.pointOnB);
            result.addContactPoint(nearest.normal, point, nearest.distance + outA + outB - SKIN);
        }
        if (shared == null) {
            result.refreshContactPoints();
        }
    }

    /** By how much jbullet's shape is larger than the solid. */
    private static float outside(ConvexShape shape) {
        return ((Solid) shape.getUserPointer()).isMarginOutside() ? shape.getMargin() : 0;
    }

    private void take(Solid solid, Transform at, double sign, Feature into) {
        Vector3f n = nearest.normal;
        direction.set((float) (sign * (at.basis.m00 * n.x + at.basis.m10 * n.y + at.basis.m20 * n.z)),
            (float) (sign * (at.basis.m01 * n.x + at.basis.m11 * n.y + at.basis.m21 * n.z)),
            (float) (sign * (at.basis.m02 * n.x + at.basis.m12 * n.y + at.basis.m22 * n.z)));
        solid.feature(direction.x, direction.y, direction.z, into);
        into.place(at);
    }

    /** @return whether there is a common patch */
    private boolean patch(Solid a, Solid b, ManifoldResult result) {
        take(a, input.transformA, -1, featureA);
        take(b, input.transformB, 1, featureB);
        Vector3f n = nearest.normal;
        double alongA = featureA.flat ? -(n.x * featureA.nx + n.y * featureA.ny + n.z * featureA.nz) : 0;
        double alongB = featureB.flat ? n.x * featureB.nx + n.y * featureB.ny + n.z * featureB.nz : 0;
        if (Math.max(alongA, alongB) < ALIGNED) {
            return false;
        }
        boolean onB = alongB >= alongA - EVEN;
        Feature face = onB ? featureB : featureA;
        Feature cut = onB ? featureA : featureB;
        cut.clip(face);
        int corners = choose(face, cut);
        float sign = onB ? 1 : -1;
        direction.set((float) (sign * face.nx), (float) (sign * face.ny), (float) (sign * face.nz));
        for (int i = 0; i < corners; i++) {
            int corner = chosen[i];
            double height = face.height(cut.x(corner), cut.y(corner), cut.z(corner));
            double down = onB ? height : 0;
            point.set((float) (cut.x(corner) - down * face.nx), (float) (cut.y(corner) - down * face.ny), (float) (cut.z(corner) - down * face.nz));
            result.addContactPoint(direction, point, (float) height - SKIN);
        }
        return corners > 0;
    }

    /** The lowest corner, the one farthest from it, and those farthest from their line to either side. */
    private int choose(Feature face, Feature cut) {
        int lowest = -1;
        double least = BREAKING;
        for (int i = 0; i < cut.count; i++) {
            double height = face.height(cut.x(i), cut.y(i), cut.z(i));
            if (height < least) {
                least = height;
                lowest = i;
            }
        }
        if (lowest < 0) {
            return 0;
        }
        int count = 0;
        chosen[count++] = lowest;
        int far = lowest;
        double most = 0;
        for (int i = 0; i < cut.count; i++) {
            double distance = square(cut.x(i) - cut.x(lowest)) + square(cut.y(i) - cut.y(lowest)) + square(cut.z(i) - cut.z(lowest));
            if (distance > most && face.height(cut.x(i), cut.y(i), cut.z(i)) < BREAKING) {
                most = distance;
                far = i;
            }
        }
        if (far == lowest) {
            return count;
        }
        chosen[count++] = far;
        for (int side = -1; side <= 1; side += 2) {
            int best = -1;
            most = 0;
            for (int i = 0; i < cut.count; i++) {
                double area = side * area(face, cut, lowest, far, i);
                if (area > most + SKIN * SKIN && face.height(cut.x(i), cut.y(i), cut.z(i)) < BREAKING) {
                    most = area;
                    best = i;
                }
            }
            if (best >= 0) {
                chosen[count++] = best;
            }
        }
        return count;
    }

    private static double square(double value) {
        return value * value;
    }

    /** Twice the area of a triangle of corners, + counter-clockwise seen from above the face. */
    private static double area(Feature face, Feature cut, int a, int b, int c) {
        double ux = cut.x(b) - cut.x(a);
        double uy = cut.y(b) - cut.y(a);
        double uz = cut.z(b) - cut.z(a);
        double vx = cut.x(c) - cut.x(a);
        double vy = cut.y(c) - cut.y(a);
        double vz = cut.z(c) - cut.z(a);
        return face.nx * (uy * vz - uz * vy) + face.ny * (uz * vx - ux * vz) + face.nz * (ux * vy - uy * vx);
    }

    @Override
    public float calculateTimeOfImpact(CollisionObject a, CollisionObject b, DispatcherInfo info, ManifoldResult result) {
        return 1;
    }

    @Override
    public void getAllContactManifolds(ObjectArrayList<PersistentManifold> into) {
        if (manifold != null && shared == null) {
            into.add(manifold);
        }
    }

    @Override
    public void destroy() {
        if (manifold != null && shared == null) {
            dispatcher.releaseManifold(manifold);
        }
        manifold = null;
    }
}
