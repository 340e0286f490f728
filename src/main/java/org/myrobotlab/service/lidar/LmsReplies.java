// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import org.SEAR.protocol.lms.CountWord;
import org.SEAR.protocol.lms.MeasuringMode;
import org.SEAR.protocol.lms.StatusByte;
import org.SEAR.protocol.lms.Telegram;

/**
 * Reads the replies of an LMS2xx (SICK telegram listing 8007954, chapters 7, 8 and 10). Positions count from the
 * command byte.
 */
final class LmsReplies {
    private static final int MILLIMETRES = 1;
    private static final double QUARTER = 0.25;
    private static final int FIRST_VALUE = 3;
    private static final double NARROW = 100;
    private static final double WIDE = 180;
    private static final double STRAIGHT_AHEAD = 90;
    private static final double[] RESOLUTIONS = {1, 0.5, 0.25};

    private LmsReplies() {
    }

    /**
     * Returns the scan in a B0h telegram: {@code B0 | count word | values | status}.
     *
     * @param resolution degrees between values, used if the number of values fits no scan mode
     */
    static RangeScan scan(Telegram telegram, MeasuringMode measuringMode, double resolution, double time) {
        CountWord count = CountWord.of(telegram.wordAt(1));
        int[] values = new int[count.getCount()];
        for (int i = 0; i < values.length; i++) {
            values[i] = measuringMode.getDistance(telegram.wordAt(FIRST_VALUE + 2 * i));
        }
        double offset = count.getQuarter() * QUARTER;
        double spread = spreadOf(values.length);
        double degrees = spread > 0 ? spread / (values.length - 1) : resolution;
        double first = spread > 0 ? STRAIGHT_AHEAD - spread / 2 : STRAIGHT_AHEAD - degrees * (values.length - 1) / 2;
        double[] angles = RangeScan.angles(values.length, first + offset, degrees);
        return new RangeScan(values, count.getUnit() == MILLIMETRES ? "mm" : "cm", 0, measuringMode.getBeyondRange(),
            angles, degrees, time);
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

    /** Returns the text of a type or power-on telegram: {@code LMS200;301063;V02.10}. */
    static String text(Telegram telegram) {
        return telegram.text(1, telegram.size() - 1).trim();
    }

    /** Returns the problem in the status byte as text; empty if there is none. */
    static String complaint(Telegram telegram) {
        int status = telegram.last();
        if (StatusByte.isPolluted(status)) {
            return "the LIDAR's window is dirty";
        }
        return StatusByte.isError(status) ? "the LIDAR reports an error (status " + Integer.toHexString(status)
            + "h)" : "";
    }
}
