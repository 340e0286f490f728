// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;

/**
 * Position, speed and effort of a joint: degrees, degrees a second and N m of a hinge, else metres, m/s and N. The
 * effort is the mean force of its motor in the last step. Immutable; any thread.
 */
public final class JointReading implements Reading {
    private static final List<String> NAMES = List.of(".position", ".speed", ".effort");
    private static final String[][] UNITS = {{"m", "m/s", "N"}, {"deg", "deg/s", "N m"}};
    private static final int[][] DIGITS = {{3, 3, 2}, {1, 1, 3}};

    private final boolean hinge;
    private final double[] numbers;

    public JointReading(boolean hinge, double position, double speed, double effort) {
        this.hinge = hinge;
        numbers = new double[] {position, speed, effort};
    }

    /** Returns the units of the three numbers, separated by commas. */
    public String unit() {
        return String.join(", ", UNITS[hinge ? 1 : 0]);
    }

    @Override
    public double[] numbers() {
        return numbers.clone();
    }

    @Override
    public List<String> names() {
        return NAMES;
    }

    /** Returns each number with its unit: {@code 45.0 deg, 0.0 deg/s, 1.500 N m}. */
    @Override
    public String words(double[] kept, String unit) {
        StringBuilder words = new StringBuilder();
        for (int i = 0; i < kept.length; i++) {
            String number = ReadingWords.fixed(kept[i], DIGITS[hinge ? 1 : 0][i]);
            words.append(i == 0 ? "" : ", ").append(ReadingWords.withUnit(number, UNITS[hinge ? 1 : 0][i]));
        }
        return words.toString();
    }
}
