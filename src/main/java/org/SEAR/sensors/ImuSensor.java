// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Collections;
import java.util.List;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;

/**
 * Attitude, acceleration, rates of turn and magnetic field in the sensor's own axes: +x forward, +y right, +z down.
 *
 * <p>The order of rotations is yaw, pitch, roll. Yaw counts from magnetic north by the {@link Earth}'s magnetic model.
 * If the world's origin on Earth is unknown, yaw counts from the world's +x and the field is level. Accelerations are
 * proper. They and the rates are exact means over 20 ms, as of an {@link AccelerometerSensor} with gravity and a
 * {@link GyroscopeSensor} of 50 Hz. The object's noise, degrees, applies to the three angles; a dropped-out reading is
 * NaN throughout.
 */
public final class ImuSensor extends Sensor<ImuReading> {
    private static final int ANGLES = 3;
    private static final double BANDWIDTH = 50;

    private final AccelerometerSensor acceleration;
    private final GyroscopeSensor rates;
    private final Rotation rotation = new Rotation();

    /** @param seed random seed of the simulation */
    public ImuSensor(IMU parameters, long seed) {
        super(parameters, seed, ANGLES);
        acceleration = new AccelerometerSensor(parameters, BANDWIDTH);
        rates = new GyroscopeSensor(parameters, BANDWIDTH);
    }

    @Override
    public void track(Truth truth) {
        super.track(truth);
        acceleration.track(truth);
        rates.track(truth);
    }

    @Override
    public void reset() {
        super.reset();
        acceleration.reset();
        rates.reset();
    }

    @Override
    protected ImuReading measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            double[] none = {Double.NaN, Double.NaN, Double.NaN};
            return new ImuReading(none, none, none, none);
        }
        Pose pose = pose(truth);
        boolean placed = truth.earth().getOrigin() != null;
        MagneticModel.Field field = placed ? CompassSensor.field(truth, pose) : null;
        double[] north = placed ? new double[] {field.north / field.total(), -field.down / field.total(),
            field.east / field.total()}
            : new double[] {1, 0, 0};
        double[] angles = angles(pose, placed ? field.declination() : 0);
        for (int i = 0; i < ANGLES; i++) {
            angles[i] = errors.apply(angles[i], truth.step(), i, i);
        }
        rotation.set(pose);
        VectorReading seen = new VectorReading(rotation.inX(north[0], north[1], north[2]),
            rotation.inY(north[0], north[1], north[2]), rotation.inZ(north[0], north[1], north[2]));
        return new ImuReading(new double[] {CompassSensor.wrap(angles[0]), angles[1], CompassSensor.wrap(angles[2])},
            own(acceleration.read(truth)), own(rates.read(truth)), own(seen));
    }

    /** Returns yaw, pitch and roll, degrees. */
    private static double[] angles(Pose pose, double declination) {
        double[] forward = pose.rotate(0, 0, 1);
        double[] left = pose.rotate(1, 0, 0);
        double[] up = pose.rotate(0, 1, 0);
        return new double[] {Math.toDegrees(Math.atan2(forward[2], forward[0])) - declination,
            Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, forward[1])))),
                Math.toDegrees(Math.atan2(left[1], up[1]))};
    }

    /** Converts from +x left, +y up, +z forward to +x forward, +y right, +z down. */
    private static double[] own(VectorReading body) {
        return new double[] {body.getZ(), -body.getX(), -body.getY()};
    }

    @Override
    public List<String> warnings(Truth truth) {
        return truth.earth().getOrigin() != null ? Collections.emptyList()
            : Collections.singletonList("imu " + getName()
            + " shows true north: without a GPS the world's place on Earth is unknown; add a GPS for the "
                + "magnetic field");
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return IMU.class;
        }

        @Override
        public String description() {
            return "yaw clockwise from magnetic north, pitch with the nose up, roll with the right side down: three "
                + "numbers in degrees";
        }

        @Override
        public String unit() {
            return "deg";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new ImuSensor((IMU) parameters, seed);
        }
    }
}
