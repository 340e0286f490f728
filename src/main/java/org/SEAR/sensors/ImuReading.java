package org.SEAR.sensors;

/**
 * What an inertial measurement unit knows, in its own axes: +x forward, +y right, +z down. Immutable but for its arrays, which are not to be changed.
 */
public final class ImuReading implements Reading {
    private final double[] angles;
    private final double[] acceleration;
    private final double[] rates;
    private final double[] field;

    /**
     * @param angles yaw, pitch, roll in degrees
     * @param acceleration proper, along the axes, m/s^2: -9.81 downwards at rest
     * @param rates about the axes, clockwise along them, rad/s
     * @param field direction of the Earth's magnetic field, of length 1
     */
    public ImuReading(double[] angles, double[] acceleration, double[] rates, double[] field) {
        this.angles = angles;
        this.acceleration = acceleration;
        this.rates = rates;
        this.field = field;
    }

    /** Degrees clockwise from magnetic north, (-180, 180]. */
    public double getYaw() {
        return angles[0];
    }

    /** Degrees, nose up positive, -90 to 90. */
    public double getPitch() {
        return angles[1];
    }

    /** Degrees, right side down positive, (-180, 180]. */
    public double getRoll() {
        return angles[2];
    }

    /** Proper acceleration along an axis, m/s^2. */
    public double getAcceleration(int axis) {
        return acceleration[axis];
    }

    /** Rate of turn about an axis, clockwise along it, rad/s. */
    public double getRate(int axis) {
        return rates[axis];
    }

    /** Share of the Earth's magnetic field along an axis, -1 to 1. */
    public double getField(int axis) {
        return field[axis];
    }

    /** Yaw, pitch, roll. */
    @Override
    public double[] numbers() {
        return angles.clone();
    }

    @Override
    public Object value() {
        return toString();
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit("yaw " + ReadingWords.fixed(kept[0], 1) + ", pitch " + ReadingWords.fixed(kept[1], 1) + ", roll "
            + ReadingWords.fixed(kept[2], 1), unit);
    }

    /** As scripts get it: {@code "yaw,pitch,roll"} in degrees. */
    @Override
    public String toString() {
        return angles[0] + "," + angles[1] + "," + angles[2];
    }
}
