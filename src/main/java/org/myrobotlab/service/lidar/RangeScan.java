// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.math.BigDecimal;
import java.util.Locale;

/**
 * One scan of a LIDAR with all data to draw it, ordered right to left. JSON-friendly; callers must not change the
 * arrays.
 */
public final class RangeScan {
    /**
     * Raw values, right to left, without flag bits. Values below {@link #least}, or from {@link #noReturn} up, are
     * codes for "no distance".
     */
    public final int[] raw;
    /** Unit of {@link #raw}: {@code "mm"} or {@code "cm"}. */
    public final String unit;
    /**
     * Direction of each value, degrees counter-clockwise seen from above: 0 right, 90 ahead, 180 left. A full circle
     * starts behind, at -90.
     */
    public final double[] angles;
    /** Distance of each value, metres; null without a distance. */
    public final Double[] metres;
    /** Least distance, raw units; values below are codes for "no distance". */
    public final int least;
    /** Lowest raw value of the codes for "no distance" beyond the range. */
    public final int noReturn;
    /** Degrees from first to last value. */
    public final double spread;
    /** Degrees between values. */
    public final double resolution;
    /** Time at the end of the scan, seconds of the port's clock (simulated time at a virtual port). */
    public final double time;

    private static final double MM = 1000;
    private static final double CM = 100;

    /**
     * @param raw values without flag bits
     * @param unit unit of raw, {@code "mm"} or {@code "cm"}
     * @param least raw values below are codes
     * @param noReturn raw values from this one up are codes
     * @param angles direction of each value, degrees
     * @param resolution degrees between values
     */
    RangeScan(int[] raw, String unit, int least, int noReturn, double[] angles, double resolution, double time) {
        this.raw = raw;
        this.unit = unit;
        this.least = least;
        this.noReturn = noReturn;
        this.angles = angles;
        this.metres = new Double[raw.length];
        this.resolution = resolution;
        this.spread = resolution * (raw.length - 1);
        this.time = time;
        double unitsPerMetre = unit.equals("mm") ? MM : CM;
        for (int i = 0; i < raw.length; i++) {
            metres[i] = raw[i] < least || raw[i] >= noReturn ? null : Double.valueOf(raw[i] / unitsPerMetre);
        }
    }

    /** Returns evenly spaced directions, degrees. */
    static double[] angles(int count, double first, double resolution) {
        double[] angles = new double[count];
        for (int i = 0; i < count; i++) {
            angles[i] = first + i * resolution;
        }
        return angles;
    }

    /**
     * Returns for example {@code scan of 101 readings over 100 degrees, 97 of them distances, the nearest 2.648 m at 90
     * degrees}.
     */
    @Override
    public String toString() {
        int nearest = -1;
        int returns = 0;
        for (int i = 0; i < metres.length; i++) {
            returns += metres[i] == null ? 0 : 1;
            nearest = metres[i] != null && (nearest < 0 || metres[i] < metres[nearest]) ? i : nearest;
        }
        String counted = String.format(Locale.ROOT, "scan of %d readings over %s degrees, %d of them distances",
            raw.length, plain(spread), returns);
        return nearest < 0 ? counted : counted + String.format(Locale.ROOT, ", the nearest %s m at %s degrees",
            plain(metres[nearest]), plain(angles[nearest]));
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }
}
