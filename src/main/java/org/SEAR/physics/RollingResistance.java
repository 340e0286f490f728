package org.SEAR.physics;

import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.dynamics.constraintsolver.TypedConstraint;
import com.bulletphysics.dynamics.constraintsolver.TypedConstraintType;
import javax.vecmath.Matrix3f;
import javax.vecmath.Vector3f;

/**
 * What brakes a body that rolls or spins on others: a torque against its turning of at most coefficient times force times the distance of the point
 * of contact from the centre of mass. jbullet solves it together with the contacts. Simulation thread.
 */
final class RollingResistance extends TypedConstraint {
    private final Vector3f angular = new Vector3f();
    private final Vector3f other = new Vector3f();
    private final Vector3f sum = new Vector3f();
    private final Vector3f change = new Vector3f();
    private final Matrix3f inverse = new Matrix3f();
    private final Matrix3f inertia = new Matrix3f();
    private float limit;
    private boolean first;

    RollingResistance(RigidBody body) {
        super(TypedConstraintType.D6_CONSTRAINT_TYPE, body, new RigidBody(0, null, null));
    }

    /** Forgets the contacts of the last step. */
    void clear() {
        limit = 0;
        other.set(0, 0, 0);
    }

    /**
     * Adds a contact.
     *
     * @param angularImpulse that it can take up in this step, Nms
     * @param on what it rolls on
     */
    void add(double angularImpulse, RigidBody on) {
        limit += (float) angularImpulse;
        if (!on.isStaticObject()) {
            on.getAngularVelocity(other);
        }
    }

    @Override
    public void buildJacobian() {
        first = true;
    }

    @Override
    public void solveConstraint(float timeStep) {
        if (limit == 0) {
            sum.set(0, 0, 0);
            return;
        }
        rbA.getAngularVelocity(angular);
        if (first) {
            first = false;
            rbA.getInvInertiaTensorWorld(inverse);
            inertia.invert(inverse);
            keepWithin();
            change.set(sum);
            push();
        }
        change.sub(other, angular);
        inertia.transform(change);
        float x = sum.x;
        float y = sum.y;
        float z = sum.z;
        sum.add(change);
        keepWithin();
        change.set(sum.x - x, sum.y - y, sum.z - z);
        push();
        rbA.setAngularVelocity(angular);
    }

    private void keepWithin() {
        float length = sum.length();
        if (length > limit) {
            sum.scale(limit / length);
        }
    }

    private void push() {
        inverse.transform(change);
        angular.add(change);
    }
}
