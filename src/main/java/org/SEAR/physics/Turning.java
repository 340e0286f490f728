package org.SEAR.physics;

import com.bulletphysics.linearmath.Transform;
import javax.vecmath.Matrix3f;
import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;

/**
 * How a body turns within a step, to the bit as jbullet works it out ({@code MatrixUtil.getRotation}, {@code TransformUtil.integrateTransform}), but
 * without its pools, which look into a map of the thread each time, and with the start's quaternion kept. Simulation thread.
 */
final class Turning {
    /** More than this it does not turn in one go, radians. */
    private static final float MOST = 0.25f * (float) Math.PI;
    /** Slower than this the sine is the first two terms of its series, rad/s. */
    private static final float SLOW = 0.001f;
    /** The second of them, 1/48. */
    private static final float CUBIC = 0.020833334f;

    private final Quat4f from = new Quat4f();
    private final Quat4f turn = new Quat4f();
    private final Vector3f axis = new Vector3f();

    /** The quaternion of a rotation matrix. */
    static void quaternion(Matrix3f m, Quat4f into) {
        float trace = m.m00 + m.m11 + m.m22;
        if (trace > 0) {
            float s = (float) Math.sqrt(trace + 1);
            float w = s * 0.5f;
            s = 0.5f / s;
            into.set((m.m21 - m.m12) * s, (m.m02 - m.m20) * s, (m.m10 - m.m01) * s, w);
        } else if (m.m00 < m.m11 && m.m11 >= m.m22) {
            float s = (float) Math.sqrt(m.m11 - m.m22 - m.m00 + 1);
            float y = s * 0.5f;
            s = 0.5f / s;
            into.set((m.m01 + m.m10) * s, y, (m.m21 + m.m12) * s, (m.m02 - m.m20) * s);
        } else if (m.m00 >= m.m11 && m.m00 >= m.m22) {
            float s = (float) Math.sqrt(m.m00 - m.m11 - m.m22 + 1);
            float x = s * 0.5f;
            s = 0.5f / s;
            into.set(x, (m.m10 + m.m01) * s, (m.m20 + m.m02) * s, (m.m21 - m.m12) * s);
        } else {
            float s = (float) Math.sqrt(m.m22 - m.m00 - m.m11 + 1);
            float z = s * 0.5f;
            s = 0.5f / s;
            into.set((m.m02 + m.m20) * s, (m.m12 + m.m21) * s, z, (m.m10 - m.m01) * s);
        }
    }

    /** Where it starts. */
    void start(Matrix3f basis) {
        quaternion(basis, from);
    }

    /**
     * Sets how it is turned after a while.
     *
     * @param angular rad/s, world frame
     * @param time seconds
     */
    void turn(Vector3f angular, float time, Transform into) {
        float speed = angular.length();
        if (speed * time > MOST) {
            speed = MOST / time;
        }
        if (speed < SLOW) {
            axis.scale(0.5f * time - time * time * time * CUBIC * speed * speed, angular);
        } else {
            axis.scale((float) Math.sin(0.5f * speed * time) / speed, angular);
        }
        turn.set(axis.x, axis.y, axis.z, (float) Math.cos(speed * time * 0.5f));
        turn.mul(from);
        turn.normalize();
        into.setRotation(turn);
    }
}
