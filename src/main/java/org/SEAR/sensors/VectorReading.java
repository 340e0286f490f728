// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/**
 * Three numbers along the sensor's axes (without rotation the body's: +x left, +y up, +z forward); NaN after a
 * drop-out. Immutable.
 */
public final class VectorReading implements Reading {
    private static final int DIGITS = 3;

    private final double x;
    private final double y;
    private final double z;

    /** Numbers in the unit of the sensor. */
    public VectorReading(double x, double y, double z) {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    /** Along, or counter-clockwise about, the left axis. */
    public double getX() {
        return x;
    }

    /** Along, or counter-clockwise about, the up axis. */
    public double getY() {
        return y;
    }

    /** Along, or counter-clockwise about, the forward axis. */
    public double getZ() {
        return z;
    }

    @Override
    public double[] numbers() {
        return new double[] {x, y, z};
    }

    @Override
    public Object value() {
        return toString();
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit);
    }

    /** Returns the value for scripts: {@code "0.0,9.81,0.0"}. */
    @Override
    public String toString() {
        return x + "," + y + "," + z;
    }
}
