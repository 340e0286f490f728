// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.nmea;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/**
 * Commands of MediaTek receivers, for example {@code $PMTK220,200*2C}: three digits and arguments. The receiver
 * acknowledges each with {@code $PMTK001,command,flag}. Source: MTK NMEA packet user manual.
 */
public enum Pmtk {
    ACKNOWLEDGE(1),
    TEST(0),
    HOT_START(101),
    WARM_START(102),
    COLD_START(103),
    FULL_COLD_START(104),
    SET_PERIOD(220),
    SET_BAUD(251),
    SET_FIX_INTERVAL(300),
    SET_DGPS(301),
    SET_SBAS(313),
    SET_OUTPUT(314),
    SET_POWER_SAVING(320),
    QUERY_FIX_INTERVAL(400),
    QUERY_DGPS(401),
    QUERY_SBAS(413),
    QUERY_OUTPUT(414),
    FIX_INTERVAL(500),
    DGPS(501),
    SBAS(513),
    OUTPUT(514),
    QUERY_FIRMWARE(604),
    QUERY_RELEASE(605),
    RELEASE(705);

    /** Baud rates, bits per second. */
    public static final List<Integer> BAUDS = Collections.unmodifiableList(
        Arrays.asList(4800, 9600, 14400, 19200, 38400, 57600, 115200));
    private static final String TALKER = "PMTK";
    private static final int DIGITS = 3;

    private final int number;

    Pmtk(int number) {
        this.number = number;
    }

    /** Finds a command by number; null if unknown. */
    public static Pmtk of(int number) {
        for (Pmtk command : values()) {
            if (command.number == number) {
                return command;
            }
        }
        return null;
    }

    /** Number in a sentence's first field, for example 220 in {@code PMTK220}; -1 for other fields. */
    public static int numberOf(String field) {
        boolean known = field.length() == TALKER.length() + DIGITS && field.matches(TALKER + "[0-9]+");
        return known ? Integer.parseInt(field.substring(TALKER.length())) : -1;
    }

    /** Returns the body of a sentence, for {@link Nmea#sentence}: {@code PMTK220,200}. */
    public String body(Object... fields) {
        StringBuilder body = new StringBuilder(String.format(Locale.ROOT, TALKER + "%0" + DIGITS + "d", number));
        for (Object field : fields) {
            body.append(',').append(field);
        }
        return body.toString();
    }
}
