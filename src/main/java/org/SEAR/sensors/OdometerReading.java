// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/** Count of an odometer since its last reset. Immutable. */
public final class OdometerReading implements Reading {
    private static final int DIGITS = 3;

    private final int millimetres;
    private final boolean valid;

    OdometerReading(int millimetres, boolean valid) {
        this.millimetres = millimetres;
        this.valid = valid;
    }

    /** Returns -32768 to 32767, + forward; 0 after a drop-out. */
    public int getMillimetres() {
        return millimetres;
    }

    /** Returns the count in metres, -32.768 to 32.767; NaN after a drop-out. */
    public double getMetres() {
        return valid ? millimetres / 1000.0 : Double.NaN;
    }

    public boolean isValid() {
        return valid;
    }

    /** Returns metres. */
    @Override
    public double[] numbers() {
        return new double[] {getMetres()};
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit);
    }

    @Override
    public String toString() {
        return getMetres() + " m";
    }
}
