// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

/** The colour that a sensor sees: red, green and blue, 0 to 255 (sRGB); NaN after a drop-out. Immutable; any thread. */
public final class ColorReading implements Reading {
    private final double red;
    private final double green;
    private final double blue;

    ColorReading(double red, double green, double blue) {
        this.red = red;
        this.green = green;
        this.blue = blue;
    }

    /** Returns 0 to 255. */
    public double getRed() {
        return red;
    }

    /** Returns 0 to 255. */
    public double getGreen() {
        return green;
    }

    /** Returns 0 to 255. */
    public double getBlue() {
        return blue;
    }

    @Override
    public double[] numbers() {
        return new double[] {red, green, blue};
    }

    @Override
    public String words(double[] kept, String unit) {
        return "red " + ReadingWords.fixed(kept[0], 0) + ", green " + ReadingWords.fixed(kept[1], 0) + ", blue "
            + ReadingWords.fixed(kept[2], 0);
    }

    /** {@code 255.0,128.0,0.0}. */
    @Override
    public String toString() {
        return red + "," + green + "," + blue;
    }
}
