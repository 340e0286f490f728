// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;

/**
 * Acceleration at the sensor's position along its axes, m/s^2 (without rotation: +x left, +y up, +z forward).
 *
 * <p>a = mean over the window 1/bandwidth of R_i' (v_i - v_(i-1)) / dt, where v = velocity of the body's origin + omega
 * x mount, and R_i is the attitude in the middle of the step. This is the velocity difference over the window, rotated
 * into the axes of each step. With gravity on it is proper acceleration, a - g: +9.81 upwards at rest, 0 in free fall.
 * A robot starts at rest. No error unless the object has noise.
 */
public final class AccelerometerSensor extends InertialSensor {
    private final boolean gravity;
    private final Rotation rotation = new Rotation();
    private final double[] before = new double[3];
    private final double[] now = new double[3];
    private Pose bodyBefore;

    /** @param seed random seed of the simulation */
    public AccelerometerSensor(Accelerometer parameters, long seed) {
        super(parameters, parameters.getBandwidth(), seed);
        this.gravity = parameters.isGravity();
    }

    /** Part of another sensor: with gravity, without errors. */
    AccelerometerSensor(SearObject parameters, double bandwidth) {
        super(parameters, bandwidth);
        this.gravity = true;
    }

    @Override
    public void track(Truth truth) {
        super.track(truth);
        Pose body = truth.body();
        velocity(truth, body);
        double fall = gravity ? truth.gravity() : 0;
        turn(bodyBefore == null ? body : bodyBefore, body);
        double rate = 1 / truth.stepLength();
        put(truth, (now[0] - before[0]) * rate, (now[1] - before[1]) * rate + fall, (now[2] - before[2]) * rate);
        System.arraycopy(now, 0, before, 0, now.length);
        bodyBefore = body;
    }

    /** Computes the velocity of the sensor's position in the world. */
    private void velocity(Truth truth, Pose body) {
        Pose mount = getMount();
        rotation.set(body);
        double x = rotation.outX(mount.x, mount.y, mount.z);
        double y = rotation.outY(mount.x, mount.y, mount.z);
        double z = rotation.outZ(mount.x, mount.y, mount.z);
        double[] v = truth.velocity();
        double[] w = truth.angularVelocity();
        now[0] = v[0] + w[1] * z - w[2] * y;
        now[1] = v[1] + w[2] * x - w[0] * z;
        now[2] = v[2] + w[0] * y - w[1] * x;
    }

    /** Sets the body's attitude halfway between two steps. */
    private void turn(Pose a, Pose b) {
        double sign = a.qx * b.qx + a.qy * b.qy + a.qz * b.qz + a.qw * b.qw < 0 ? -1 : 1;
        rotation.set(a.qx + sign * b.qx, a.qy + sign * b.qy, a.qz + sign * b.qz, a.qw + sign * b.qw);
    }

    private void put(Truth truth, double x, double y, double z) {
        double bodyX = rotation.inX(x, y, z);
        double bodyY = rotation.inY(x, y, z);
        double bodyZ = rotation.inZ(x, y, z);
        rotation.set(getMount());
        add(truth, rotation.inX(bodyX, bodyY, bodyZ), rotation.inY(bodyX, bodyY, bodyZ),
            rotation.inZ(bodyX, bodyY, bodyZ));
    }

    @Override
    public void reset() {
        super.reset();
        Arrays.fill(before, 0);
        bodyBefore = null;
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Accelerometer.class;
        }

        @Override
        public String description() {
            return "acceleration along the sensor's axes (+x left, +y up, +z forward): three numbers in m/s^2";
        }

        @Override
        public String unit() {
            return "m/s2";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new AccelerometerSensor((Accelerometer) parameters, seed);
        }
    }
}
