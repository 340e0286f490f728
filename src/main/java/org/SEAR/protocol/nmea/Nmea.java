// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.nmea;

import java.util.Locale;
import java.util.regex.Pattern;

/**
 * Frame and numbers of NMEA 0183 sentences: {@code $ ... *cs CR LF}, where cs is the exclusive or of the characters
 * between $ and *.
 */
public final class Nmea {
    /** Number of digits of a latitude's degrees. */
    public static final int LATITUDE_DIGITS = 2;
    /** Number of digits of a longitude's degrees. */
    public static final int LONGITUDE_DIGITS = 3;
    private static final int MINUTES = 60;
    /** Number of digits of a coordinate's minutes before the point. */
    private static final int MINUTE_DIGITS = 2;
    private static final Pattern COORDINATE = Pattern.compile("[0-9]{1,5}[.][0-9]*");
    private static final int HEX = 16;
    private static final int CHECKSUM_SIZE = 3;

    private Nmea() {
    }

    /** Returns the sentence of a body; {@code "PMTK010,001"} gives {@code "$PMTK010,001*2E\r\n"}. */
    public static String sentence(String body) {
        return "$" + body + "*" + String.format(Locale.ROOT, "%02X", checksum(body)) + "\r\n";
    }

    /**
     * Returns the body of a line with a valid checksum; null otherwise.
     *
     * @param line without CR LF
     */
    public static String body(String line) {
        int star = line.length() - CHECKSUM_SIZE;
        if (star < 1 || line.charAt(0) != '$' || line.charAt(star) != '*') {
            return null;
        }
        int high = Character.digit(line.charAt(star + 1), HEX);
        int low = Character.digit(line.charAt(star + 2), HEX);
        String body = line.substring(1, star);
        return high >= 0 && low >= 0 && high * HEX + low == checksum(body) ? body : null;
    }

    private static int checksum(String body) {
        int sum = 0;
        for (int i = 0; i < body.length(); i++) {
            sum ^= body.charAt(i);
        }
        return sum & 0xFF;
    }

    /**
     * Formats degrees as {@code ddmm.mmmm}, without sign. Rounds the total minutes, so that they never show as 60.
     *
     * @param width digits of the degrees
     * @param decimals of the minutes
     */
    public static String degrees(double degrees, int width, int decimals) {
        long scale = Math.round(Math.pow(10, decimals));
        long minutes = Math.round(Math.abs(degrees) * MINUTES * scale);
        return String.format(Locale.ROOT, "%0" + width + "d%02d.%0" + decimals + "d", minutes / (MINUTES * scale),
            minutes / scale % MINUTES, minutes % scale);
    }

    /**
     * Parses {@code ddmm.mmmm} or {@code dddmm.mmmm} to decimal degrees. The two digits before the point are minutes.
     *
     * @throws IllegalArgumentException if it is no coordinate
     */
    public static double degrees(String field) {
        if (!COORDINATE.matcher(field).matches()) {
            throw new IllegalArgumentException("\"" + field + "\" is no coordinate, legal: ddmm.mmmm or dddmm.mmmm");
        }
        int minutes = Math.max(0, field.indexOf('.') - MINUTE_DIGITS);
        int degrees = minutes == 0 ? 0 : Integer.parseInt(field.substring(0, minutes));
        return degrees + Double.parseDouble(field.substring(minutes)) / MINUTES;
    }

    /** Formats a number with a decimal point, regardless of the computer's locale. */
    public static String number(double value, int decimals) {
        String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
        return text.startsWith("-") && text.matches("-0*\\.?0*") ? text.substring(1) : text;
    }
}
