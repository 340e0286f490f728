// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.util.Arrays;

/** Output interval of each sentence in fixes: the 19 fields of PMTK314. */
final class OutputRates {
    static final int GLL = 0;
    static final int RMC = 1;
    static final int VTG = 2;
    static final int GGA = 3;
    static final int GSA = 4;
    static final int GSV = 5;
    static final int ZDA = 17;
    static final int CHANNELS = 18;
    private static final int FIELDS = 19;
    private static final int MAX = 5;

    private final int[] every = new int[FIELDS];

    OutputRates() {
        setDefault();
    }

    /** Sets the recorded default: GGA, RMC, VTG with each fix, GSA and GSV with every fifth. */
    void setDefault() {
        Arrays.fill(every, 0);
        every[GGA] = 1;
        every[RMC] = 1;
        every[VTG] = 1;
        every[GSA] = MAX;
        every[GSV] = MAX;
    }

    /**
     * @param fields as in PMTK314
     * @return whether they are legal: 19 numbers from 0 to 5
     */
    boolean set(int[] fields) {
        if (fields.length != FIELDS || Arrays.stream(fields).anyMatch(value -> value < 0 || value > MAX)) {
            return false;
        }
        System.arraycopy(fields, 0, every, 0, FIELDS);
        return true;
    }

    boolean isDue(int sentence, long fixNumber) {
        return every[sentence] > 0 && fixNumber % every[sentence] == 0;
    }

    /** Fields as in PMTK514. */
    String describe() {
        StringBuilder text = new StringBuilder();
        for (int value : every) {
            text.append(',').append(value);
        }
        return text.toString();
    }
}
