// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import java.util.List;

/** Force in N and torque in N m along three axes; NaN after a drop-out. Immutable. */
public final class WrenchReading implements Reading {
    static final int SIZE = 6;
    static final String UNIT = "N, N, N, N m, N m, N m";
    private static final List<String> NAMES = List.of(".fx", ".fy", ".fz", ".tx", ".ty", ".tz");
    private static final int DIGITS = 3;

    private final double[] numbers;

    WrenchReading(double[] numbers) {
        this.numbers = numbers;
    }

    @Override
    public double[] numbers() {
        return numbers.clone();
    }

    @Override
    public List<String> names() {
        return NAMES;
    }

    @Override
    public String words(double[] kept, String unit) {
        return ReadingWords.fixed(Arrays.copyOf(kept, 3), DIGITS) + " N; "
            + ReadingWords.fixed(Arrays.copyOfRange(kept, 3, SIZE), DIGITS) + " N m";
    }
}
