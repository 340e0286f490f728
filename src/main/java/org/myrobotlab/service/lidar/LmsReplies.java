package org.myrobotlab.service.lidar;

import java.nio.charset.StandardCharsets;

/** Reads the answers of an LMS2xx (SICK telegram listing 8007954, chapters 7, 8 and 10). Positions count from the command byte. */
final class LmsReplies {
    private static final int COUNT_BITS = 0x3FF;
    private static final int UNIT_SHIFT = 14;
    private static final int MILLIMETRES = 1;
    private static final int PARTIAL_SHIFT = 11;
    private static final int PARTIAL_MASK = 3;
    private static final double PARTIAL_STEP = 0.25;
    private static final int FIRST_VALUE = 3;
    private static final double NARROW = 100;
    private static final double WIDE = 180;
    private static final double STRAIGHT_AHEAD = 90;
    private static final double[] RESOLUTIONS = {1, 0.5, 0.25};
    private static final int POLLUTED = 0x80;
    private static final int SEVERITY = 7;
    private static final int ERROR = 3;

    private LmsReplies() {
    }

    /**
     * A B0h telegram: {@code B0 | count word | values | status}.
     *
     * @param resolution degrees between values, used where the number of values doesn't tell
     */
    static LmsScan scan(byte[] body, int measuringMode, double resolution, double time) {
        int count = LmsTelegram.word(body, 1);
        int[] values = new int[count & COUNT_BITS];
        for (int i = 0; i < values.length; i++) {
            values[i] = LmsTelegram.word(body, FIRST_VALUE + 2 * i);
        }
        boolean millimetres = count >> UNIT_SHIFT == MILLIMETRES;
        double offset = (count >> PARTIAL_SHIFT & PARTIAL_MASK) * PARTIAL_STEP;
        double spread = spreadOf(values.length);
        double degrees = spread > 0 ? spread / (values.length - 1) : resolution;
        double first = spread > 0 ? STRAIGHT_AHEAD - spread / 2 : STRAIGHT_AHEAD - degrees * (values.length - 1) / 2;
        return new LmsScan(values, millimetres, distanceBits(measuringMode), first + offset, degrees, time);
    }

    private static double spreadOf(int values) {
        for (double resolution : RESOLUTIONS) {
            if (values == NARROW / resolution + 1) {
                return NARROW;
            }
            if (values == WIDE / resolution + 1) {
                return WIDE;
            }
        }
        return 0;
    }

    /** How many bits of a value are distance (telegram listing, table of measuring modes). */
    static int distanceBits(int measuringMode) {
        switch (measuringMode) {
            case 3:
            case 4:
                return 14;
            case 5:
            case 6:
                return 15;
            case 0x0F:
                return 16;
            default:
                return 13;
        }
    }

    /** The text of a type or power-on telegram: {@code LMS200;301063;V02.10}. */
    static String text(byte[] body) {
        return new String(body, 1, Math.max(0, body.length - 2), StandardCharsets.US_ASCII).trim();
    }

    /** What the status byte complains about, in words; empty if nothing. */
    static String complaint(byte[] body) {
        int status = body[body.length - 1];
        if ((status & POLLUTED) != 0) {
            return "the LIDAR's window is dirty";
        }
        return (status & SEVERITY) >= ERROR ? "the LIDAR reports an error (status " + Integer.toHexString(status & 0xFF) + "h)" : "";
    }
}
