// SPDX-License-Identifier: Apache-2.0
package org.example;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.SEAR.sensors.Picture;
import org.SEAR.sensors.Reading;

/** Picture of a thermal camera: 8 x 8 temperatures, degrees Celsius, row by row from the top left. */
final class ThermalImage implements Reading {
    static final int SIDE = 8;
    private static final double COLDEST = -20;
    private static final double WARMEST = 80;

    private final double[] pixels;

    /** @param pixels belong to this reading afterwards */
    ThermalImage(double[] pixels) {
        this.pixels = pixels;
    }

    /** Minimum and maximum, for records and plots. */
    @Override
    public double[] numbers() {
        return new double[] {Arrays.stream(pixels).min().getAsDouble(), Arrays.stream(pixels).max().getAsDouble()};
    }

    @Override
    public List<String> names() {
        return List.of(".coldest", ".warmest");
    }

    /** All temperatures, for scripts. */
    @Override
    public Object value() {
        return pixels.clone();
    }

    @Override
    public String words(double[] kept, String unit) {
        return String.format(Locale.ROOT, "%.1f to %.1f %s", kept[0], kept[1], unit);
    }

    /** From blue to red. */
    @Override
    public Picture picture() {
        return new Picture(SIDE, Arrays.stream(pixels).mapToInt(ThermalImage::color).toArray());
    }

    private static int color(double celsius) {
        int warm = (int) Math.round(255 * share(celsius));
        return warm << 16 | 255 - warm;
    }

    /** Voltage of the warmest pixel: 0 V for -20 and 5 V for 80 degrees. */
    @Override
    public double volts() {
        return 5 * share(numbers()[1]);
    }

    private static double share(double celsius) {
        return Math.max(0, Math.min(1, (celsius - COLDEST) / (WARMEST - COLDEST)));
    }
}
