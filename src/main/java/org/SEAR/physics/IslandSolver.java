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
    /** A stack. */
    private static final int ITERATIONS_TOGETHER = 40;

    private long iterations;

    /** Called for each group of moving bodies that touch each other; what is fixed does not count among them. */
    @Override
    public float solveGroup(ObjectArrayList<CollisionObject> bodies, int bodyCount, ObjectArrayList<PersistentManifold> manifolds,
            int firstManifold, int manifoldCount, ObjectArrayList<TypedConstraint> constraints, int firstConstraint, int constraintCount,
            ContactSolverInfo info, IDebugDraw drawer, Dispatcher dispatcher) {
        info.numIterations = bodyCount > 1 ? ITERATIONS_TOGETHER : ITERATIONS_ALONE;
        iterations += manifoldCount + constraintCount > 0 ? info.numIterations : 0;
        return super.solveGroup(bodies, bodyCount, manifolds, firstManifold, manifoldCount, constraints, firstConstraint, constraintCount, info,
            drawer, dispatcher);
    }

    /** Iterations so far, of all groups that touched anything: the work it has done. */
    long getIterations() {
        return iterations;
    }
}
