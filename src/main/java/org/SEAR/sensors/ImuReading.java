// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/**
 * Reading of an inertial measurement unit in its own axes: +x forward, +y right, +z down. Immutable except for its
 * arrays, which callers must not change.
 */
public final class ImuReading implements Reading {
    private final double[] angles;
    private final double[] acceleration;
    private final double[] rates;
    private final double[] field;

    /**
     * @param angles yaw, pitch, roll, degrees
     * @param acceleration proper acceleration along the axes, m/s^2: -9.81 along +z at rest
     * @param rates about the axes, clockwise along them, rad/s
     * @param field unit vector of the Earth's magnetic field
     */
    public ImuReading(double[] angles, double[] acceleration, double[] rates, double[] field) {
        this.angles = angles;
        this.acceleration = acceleration;
        this.rates = rates;
        this.field = field;
    }

    /** Returns degrees clockwise from magnetic north, (-180, 180]. */
    public double getYaw() {
        return angles[0];
    }

    /** Returns degrees, nose up positive, -90 to 90. */
    public double getPitch() {
        return angles[1];
    }

    /** Returns degrees, right side down positive, (-180, 180]. */
    public double getRoll() {
        return angles[2];
    }

    /** Returns the proper acceleration along an axis, m/s^2. */
    public double getAcceleration(int axis) {
        return acceleration[axis];
    }

    /** Returns the rate of turn about an axis, clockwise along it, rad/s. */
    public double getRate(int axis) {
        return rates[axis];
    }

    /** Returns the component of the magnetic field's unit vector along an axis, -1 to 1. */
    public double getField(int axis) {
        return field[axis];
    }

    /** Returns yaw, pitch, roll. */
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
        return ReadingWords.withUnit("yaw " + ReadingWords.fixed(kept[0], 1) + ", pitch "
            + ReadingWords.fixed(kept[1], 1) + ", roll " + ReadingWords.fixed(kept[2], 1), unit);
    }

    /** Returns the value for scripts: {@code "yaw,pitch,roll"}, degrees. */
    @Override
    public String toString() {
        return angles[0] + "," + angles[1] + "," + angles[2];
    }
}
