package org.SEAR.physics;

import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.dynamics.constraintsolver.TypedConstraint;
import com.bulletphysics.dynamics.constraintsolver.TypedConstraintType;

/** Puts a robot's {@link PhysicsWorld.Drive}, and what its body comes near to, among the constraints that jbullet solves. Simulation thread. */
final class DriveConstraint extends TypedConstraint {
    private final Body body;
    private final PhysicsWorld.Drive drive;
    private final SolverBody solver = new SolverBody();
    private boolean first = true;

    DriveConstraint(Body body, PhysicsWorld.Drive drive) {
        super(TypedConstraintType.D6_CONSTRAINT_TYPE, body.getRigid(), new RigidBody(0, null, null));
        this.body = body;
        this.drive = drive;
    }

    @Override
    public void buildJacobian() {
        first = true;
    }

    @Override
    public void solveConstraint(float timeStep) {
        solver.read(rbA);
        if (first) {
            first = false;
            solver.prepare(rbA);
            drive.prepare(solver);
            body.getApproach().prepare(solver);
        }
        drive.solve(solver);
        body.getApproach().solve(solver.v);
        solver.write(rbA);
    }
}
