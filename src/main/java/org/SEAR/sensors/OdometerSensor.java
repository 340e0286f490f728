// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.SearObject;

/**
 * Signed distance by the wheels' encoders since the count was last reset, whole millimetres, 16 bit; the true path of
 * the body's origin if the object says so or the robot has no driven wheels. Like a Roomba's packet 19 it stops at
 * 32767 or -32768 until it is taken. Fractions of a millimetre carry over to the next reading.
 *
 * <p>{@link #read} only reads, so that a window may show the count. {@link #take} reads and resets the count, like a
 * robot's program.
 */
public final class OdometerSensor extends Sensor<OdometerReading> {
    private static final double MILLIMETRES = 1000;

    private final Odometer odometer;
    private double count;
    private double before;

    /** @param seed random seed of the simulation */
    public OdometerSensor(Odometer parameters, long seed) {
        super(parameters, seed, 1);
        odometer = parameters;
    }

    /** Reads the count and resets it. A dropped-out reading resets nothing. Simulation thread. */
    public OdometerReading take(Truth truth) {
        OdometerReading reading = read(truth);
        if (reading.isValid()) {
            count -= (int) count;
            forget();
        }
        return reading;
    }

    @Override
    public void track(Truth truth) {
        super.track(truth);
        double now = odometer.isTruePath() ? truth.path() : truth.odometry();
        count = Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, count + (now - before) * MILLIMETRES));
        before = now;
    }

    @Override
    public void reset() {
        super.reset();
        count = 0;
        before = 0;
    }

    @Override
    protected OdometerReading measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            return new OdometerReading(0, false);
        }
        double millimetres = MILLIMETRES * errors.apply(count / MILLIMETRES, truth.step(), 0, 0);
        double rounded = errors.isNone() ? count : Math.rint(millimetres);
        return new OdometerReading((int) Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, rounded)), true);
    }

    /** Registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Odometer.class;
        }

        @Override
        public String description() {
            return "signed distance by the wheels' encoders since the last reading, + forward: whole millimetres, "
                + "-32768 to 32767 (scripts get m)";
        }

        @Override
        public String unit() {
            return "m";
        }

        @Override
        public Sensor<?> create(SearObject parameters, long seed) {
            return new OdometerSensor((Odometer) parameters, seed);
        }
    }
}
