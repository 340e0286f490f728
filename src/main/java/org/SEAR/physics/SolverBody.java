package org.SEAR.physics;

import com.bulletphysics.dynamics.RigidBody;
import javax.vecmath.Matrix3f;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.TimeStep;

/** A rigid body as constraints see it while jbullet's solver runs. Simulation thread. */
public final class SolverBody {
    /** Velocities of the centre of mass, world frame: {vx, vy, vz, wx, wy, wz}, m/s and rad/s. Constraints change them. */
    public final double[] v = new double[6];
    /** The centre of mass in the world: {x, y, z}, metres. */
    final double[] centre = new double[3];
    /** 1/kg. */
    double inverseMass;
    /** World frame, 1/(kg m^2). */
    final Matrix3f inverseInertia = new Matrix3f();
    private final Vector3f linear = new Vector3f();
    private final Vector3f angular = new Vector3f();

    /** Takes over what stays the same in all iterations of a step. */
    void prepare(RigidBody rigid) {
        rigid.getInvInertiaTensorWorld(inverseInertia);
        rigid.getCenterOfMassPosition(linear);
        centre[0] = linear.x;
        centre[1] = linear.y;
        centre[2] = linear.z;
        inverseMass = rigid.getInvMass();
    }

    void read(RigidBody rigid) {
        rigid.getLinearVelocity(linear);
        rigid.getAngularVelocity(angular);
        v[0] = linear.x;
        v[1] = linear.y;
        v[2] = linear.z;
        v[3] = angular.x;
        v[4] = angular.y;
        v[5] = angular.z;
    }

    void write(RigidBody rigid) {
        linear.set((float) v[0], (float) v[1], (float) v[2]);
        angular.set((float) v[3], (float) v[4], (float) v[5]);
        rigid.setLinearVelocity(linear);
        rigid.setAngularVelocity(angular);
    }

    /** Length of the time in which constraints are being solved, seconds: that of a step, or of a part of it. */
    public double seconds() {
        return TimeStep.SECONDS;
    }

    /**
     * How far a point of it has moved along a direction since the step began, metres.
     *
     * @param nx unit direction, world frame, likewise ny and nz
     * @param x where the point was when the step began, world frame, metres, likewise y and z
     */
    public double travel(double nx, double ny, double nz, double x, double y, double z) {
        return 0;
    }
}
