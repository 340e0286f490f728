package org.myrobotlab.service.lidar;

import java.math.BigDecimal;
import java.util.Locale;

/**
 * One scan of a LIDAR, right to left, with all that is needed to draw it. JSON-friendly; nobody changes the arrays afterwards.
 */
public final class RangeScan {
    /** Values of the device, right to left, flag bits removed; {@link #noReturn} and above, or below {@link #least}, means no distance. */
    public final int[] raw;
    /** {@code "mm"} or {@code "cm"}: the unit of {@link #raw}. */
    public final String unit;
    /** Degrees of each value, 0 right, 90 ahead, 180 left; counter-clockwise seen from above; a whole circle begins behind, at -90. */
    public final double[] angles;
    /** Metres of each value; null where nothing was measured. */
    public final Double[] metres;
    /** Raw values below this one are the device's codes for "no distance". */
    public final int least;
    /** Raw values from here up are the device's codes for "no distance". */
    public final int noReturn;
    /** Degrees from first to last value. */
    public final double spread;
    /** Degrees between values. */
    public final double resolution;
    /** Seconds of the port's clock (simulated time at a simulated port) when the scan was complete. */
    public final double time;

    private static final double MM = 1000;
    private static final double CM = 100;

    /**
     * @param raw values as they came, without flag bits
     * @param unit of raw, {@code "mm"} or {@code "cm"}
     * @param least raw values below this one are codes
     * @param noReturn raw values from this one on are codes
     * @param angles degrees of each value
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

    /** Degrees of values at even distances. */
    static double[] angles(int count, double first, double resolution) {
        double[] angles = new double[count];
        for (int i = 0; i < count; i++) {
            angles[i] = first + i * resolution;
        }
        return angles;
    }

    /** {@code scan of 101 readings over 100 degrees, 97 of them distances, the nearest 2.648 m at 90 degrees}. */
    @Override
    public String toString() {
        int nearest = -1;
        int returns = 0;
        for (int i = 0; i < metres.length; i++) {
            returns += metres[i] == null ? 0 : 1;
            nearest = metres[i] != null && (nearest < 0 || metres[i] < metres[nearest]) ? i : nearest;
        }
        String counted = String.format(Locale.ROOT, "scan of %d readings over %s degrees, %d of them distances", raw.length, plain(spread), returns);
        return nearest < 0 ? counted : counted + String.format(Locale.ROOT, ", the nearest %s m at %s degrees", plain(metres[nearest]),
            plain(angles[nearest]));
    }

    private static String plain(double number) {
        return BigDecimal.valueOf(number).stripTrailingZeros().toPlainString();
    }
}
