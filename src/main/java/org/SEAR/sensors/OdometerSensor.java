package org.SEAR.sensors;

import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.SearObject;

/**
 * Signed path of the body's origin since it was last cleared, in whole millimetres, 16 bit: like a Roomba's packet 19 it stays at 32767 or -32768 if
 * nobody reads it in time. Fractions of a millimetre are kept for the next reading.
 *
 * <p>{@link #read} only looks, so that a window may show the count; {@link #take} is what a robot's program does: it reads and clears.
 */
public final class OdometerSensor extends Sensor<OdometerReading> {
    private static final double MILLIMETRES = 1000;

    private double count;
    private double pathBefore;

    /** @param seed of the simulation */
    public OdometerSensor(Odometer parameters, long seed) {
        super(parameters, seed, 1);
    }

    /** Reads and clears: the next reading counts from here. A reading that dropped out clears nothing. Simulation thread. */
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
        count = Math.max(Short.MIN_VALUE, Math.min(Short.MAX_VALUE, count + (truth.path() - pathBefore) * MILLIMETRES));
        pathBefore = truth.path();
    }

    @Override
    public void reset() {
        super.reset();
        count = 0;
        pathBefore = 0;
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

    /** The registry entry. */
    public static final class Type implements SensorType {
        @Override
        public Class<? extends SearObject> parameterType() {
            return Odometer.class;
        }

        @Override
        public String description() {
            return "path of the robot's centre since the last reading, forward positive: whole millimetres, -32768 to 32767 (scripts get m)";
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
