package org.SEAR.physics;

import com.bulletphysics.dynamics.RigidBody;
import javax.vecmath.Matrix3f;
import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;

/**
 * How a body spins on when nothing turns it: its angular momentum stays, so the axis of a long or flat body wanders (Euler's equations, here by the
 * classical Runge-Kutta method on the orientation). Simulation thread.
 */
final class Spin {
    /** A share of the angular velocity; if it changes by less in a step, it stays. */
    private static final double NOTHING = 1e-6;
    /** Turned by no more than this in one go, radians. */
    private static final double SMALL = 0.1;
    private static final int MOST_PARTS = 64;

    /** 1/(kg m^2), about the body's axes. */
    private final double[] inverse = new double[3];
    private final boolean even;
    private boolean wanders;
    /** Angular momentum, world frame, kg m^2/s. */
    private final double[] momentum = new double[3];
    /** Orientation {x, y, z, w}, and what it is tried at. */
    private final double[] q = new double[4];
    private final double[] at = new double[4];
    private final double[] sum = new double[4];
    private final double[] slope = new double[4];
    private final double[] w = new double[3];
    private final double[] inBody = new double[3];
    private final Quat4f start = new Quat4f();
    private final Matrix3f inverseInertia = new Matrix3f();
    private final Vector3f vector = new Vector3f();

    Spin(RigidBody rigid) {
        rigid.getInvInertiaDiagLocal(vector);
        inverse[0] = vector.x;
        inverse[1] = vector.y;
        inverse[2] = vector.z;
        even = vector.x == vector.y && vector.y == vector.z;
    }

    /**
     * Changes an angular velocity into that constant one which turns the body in a step as it will turn.
     *
     * @param angular rad/s, world frame
     * @param time of the step, seconds
     */
    void plan(RigidBody rigid, Matrix3f basis, Vector3f angular, float time) {
        wanders = false;
        double speed = angular.length();
        if (even || speed * time < NOTHING) {
            return;
        }
        Turning.quaternion(basis, start);
        q[0] = start.x;
        q[1] = start.y;
        q[2] = start.z;
        q[3] = start.w;
        rotate(q, -1, angular.x, angular.y, angular.z, inBody);
        double lx = inBody[0] / inverse[0];
        double ly = inBody[1] / inverse[1];
        double lz = inBody[2] / inverse[2];
        double cx = inverse[0] * (ly * inBody[2] - lz * inBody[1]);
        double cy = inverse[1] * (lz * inBody[0] - lx * inBody[2]);
        double cz = inverse[2] * (lx * inBody[1] - ly * inBody[0]);
        if (Math.sqrt(cx * cx + cy * cy + cz * cz) * time < NOTHING * speed) {
            return;
        }
        wanders = true;
        rotate(q, 1, lx, ly, lz, momentum);
        int parts = (int) Math.min(MOST_PARTS, Math.ceil(speed * time / SMALL));
        for (int i = 0; i < parts; i++) {
            advance(time / (double) parts);
        }
        constant(speed * time, time, angular);
    }

    private void advance(double h) {
        for (int i = 0; i < 4; i++) {
            at[i] = q[i];
            sum[i] = 0;
        }
        for (int stage = 0; stage < 4; stage++) {
            slope();
            double weight = stage == 0 || stage == 3 ? h / 6 : h / 3;
            double ahead = stage == 2 ? h : h / 2;
            for (int i = 0; i < 4; i++) {
                sum[i] += weight * slope[i];
                at[i] = q[i] + ahead * slope[i];
            }
        }
        double square = 0;
        for (int i = 0; i < 4; i++) {
            q[i] += sum[i];
            square += q[i] * q[i];
        }
        double length = Math.sqrt(square);
        for (int i = 0; i < 4; i++) {
            q[i] /= length;
        }
    }

    /** The change of the orientation that is tried, 1/s: half the angular velocity times it. */
    private void slope() {
        rotate(at, -1, momentum[0], momentum[1], momentum[2], inBody);
        rotate(at, 1, inBody[0] * inverse[0], inBody[1] * inverse[1], inBody[2] * inverse[2], w);
        slope[0] = (w[0] * at[3] + w[1] * at[2] - w[2] * at[1]) / 2;
        slope[1] = (w[1] * at[3] + w[2] * at[0] - w[0] * at[2]) / 2;
        slope[2] = (w[2] * at[3] + w[0] * at[1] - w[1] * at[0]) / 2;
        slope[3] = -(w[0] * at[0] + w[1] * at[1] + w[2] * at[2]) / 2;
    }

    /** Rotates a vector by a quaternion of length 1, or back. */
    private static void rotate(double[] by, int direction, double x, double y, double z, double[] into) {
        double qx = direction * by[0];
        double qy = direction * by[1];
        double qz = direction * by[2];
        double tx = 2 * (qy * z - qz * y);
        double ty = 2 * (qz * x - qx * z);
        double tz = 2 * (qx * y - qy * x);
        into[0] = x + by[3] * tx + qy * tz - qz * ty;
        into[1] = y + by[3] * ty + qz * tx - qx * tz;
        into[2] = z + by[3] * tz + qx * ty - qy * tx;
    }

    /** The constant angular velocity from the start's orientation to the end's, of as many whole turns as are nearest to the angle. */
    private void constant(double angle, float time, Vector3f angular) {
        double x = -q[3] * start.x + q[0] * start.w - q[1] * start.z + q[2] * start.y;
        double y = -q[3] * start.y + q[0] * start.z + q[1] * start.w - q[2] * start.x;
        double z = -q[3] * start.z - q[0] * start.y + q[1] * start.x + q[2] * start.w;
        double cosine = q[3] * start.w + q[0] * start.x + q[1] * start.y + q[2] * start.z;
        double sine = Math.sqrt(x * x + y * y + z * z);
        if (sine < NOTHING) {
            return;
        }
        double turned = 2 * Math.atan2(sine, cosine);
        turned += 2 * Math.PI * Math.rint((angle - turned) / (2 * Math.PI));
        double scale = turned / (sine * time);
        angular.set((float) (scale * x), (float) (scale * y), (float) (scale * z));
    }

    /** At the end of the step: the angular velocity that the momentum makes where the body is now. */
    void end(RigidBody rigid) {
        if (wanders) {
            rigid.getInvInertiaTensorWorld(inverseInertia);
            vector.set((float) momentum[0], (float) momentum[1], (float) momentum[2]);
            inverseInertia.transform(vector);
            rigid.setAngularVelocity(vector);
        }
    }
}
