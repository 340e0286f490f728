package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.Dispatcher;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import com.bulletphysics.dynamics.constraintsolver.ContactSolverInfo;
import com.bulletphysics.dynamics.constraintsolver.SequentialImpulseConstraintSolver;
import com.bulletphysics.dynamics.constraintsolver.TypedConstraint;
import com.bulletphysics.linearmath.IDebugDraw;
import com.bulletphysics.util.ObjectArrayList;

/** jbullet's solver, with as many iterations as the bodies that hang together need. Simulation thread. */
final class IslandSolver extends SequentialImpulseConstraintSolver {
    /** A body that touches nothing that moves: its few contacts need not pass impulses on. */
    private static final int ITERATIONS_ALONE = 10;
    /** A few bodies. */
    private static final int ITERATIONS_TOGETHER = 40;
    /** For each body of a tall stack: a stack of 40 boxes stands. */
    private static final int ITERATIONS_EACH = 5;
    /** Iterations times bodies; a heap of more bodies is no tower. */
    private static final int MOST_WORK = 20_000;

    private long iterations;

    /** Called for each group of moving bodies that touch each other; what is fixed does not count among them. */
    @Override
    public float solveGroup(ObjectArrayList<CollisionObject> bodies, int bodyCount, ObjectArrayList<PersistentManifold> manifolds,
            int firstManifold, int manifoldCount, ObjectArrayList<TypedConstraint> constraints, int firstConstraint, int constraintCount,
            ContactSolverInfo info, IDebugDraw drawer, Dispatcher dispatcher) {
        info.numIterations = bodyCount == 1 && !bounces(manifolds, firstManifold, manifoldCount) ? ITERATIONS_ALONE : iterations(bodyCount);
        iterations += manifoldCount + constraintCount > 0 ? info.numIterations : 0;
        return super.solveGroup(bodies, bodyCount, manifolds, firstManifold, manifoldCount, constraints, firstConstraint, constraintCount, info,
            drawer, dispatcher);
    }

    /** The more bodies carry each other, the more iterations, as long as that can be paid for. */
    private static int iterations(int bodies) {
        return Math.max(ITERATIONS_TOGETHER, Math.min(ITERATIONS_EACH * bodies, MOST_WORK / bodies));
    }

    /** Whether something is thrown back: all points of a face have to agree how fast, or it would tumble. */
    private static boolean bounces(ObjectArrayList<PersistentManifold> manifolds, int first, int count) {
        for (int i = first; i < first + count; i++) {
            PersistentManifold manifold = manifolds.getQuick(i);
            for (int k = 0; k < manifold.getNumContacts(); k++) {
                if (manifold.getContactPoint(k).combinedRestitution > 0) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Iterations so far, of all groups that touched anything: the work it has done. */
    long getIterations() {
        return iterations;
    }
}
