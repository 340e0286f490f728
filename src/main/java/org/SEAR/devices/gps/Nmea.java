package org.SEAR.devices.gps;

import java.util.Locale;

/** Puts NMEA sentences in their frame: {@code $ ... *cs CR LF}, where cs is the exclusive or of what stands between $ and *. */
public final class Nmea {
    private Nmea() {
    }

    /** The sentence of a body, for example {@code "PMTK010,001"} gives {@code "$PMTK010,001*2E\r\n"}. */
    public static String sentence(String body) {
        return "$" + body + "*" + String.format(Locale.ROOT, "%02X", checksum(body)) + "\r\n";
    }

    /** The body of a line with the right checksum; null otherwise. @param line without CR LF */
    public static String body(String line) {
        int star = line.length() - 3;
        if (star < 1 || line.charAt(0) != '$' || line.charAt(star) != '*') {
            return null;
        }
        int high = Character.digit(line.charAt(star + 1), 16);
        int low = Character.digit(line.charAt(star + 2), 16);
        String body = line.substring(1, star);
        return high >= 0 && low >= 0 && high * 16 + low == checksum(body) ? body : null;
    }

    private static int checksum(String body) {
        int sum = 0;
        for (int i = 0; i < body.length(); i++) {
            sum ^= body.charAt(i);
        }
        return sum & 0xFF;
    }

    /** Degrees as {@code ddmm.mmmm}; rounded as a whole, so that minutes never show as 60. @param width digits of the degrees */
    static String degrees(double degrees, int width, int decimals) {
        long scale = Math.round(Math.pow(10, decimals));
        long minutes = Math.round(Math.abs(degrees) * 60 * scale);
        return String.format(Locale.ROOT, "%0" + width + "d%02d.%0" + decimals + "d", minutes / (60 * scale), minutes / scale % 60, minutes % scale);
    }

    /** A decimal number with a point, whatever the computer's language. */
    static String number(double value, int decimals) {
        String text = String.format(Locale.ROOT, "%." + decimals + "f", value);
        return text.startsWith("-") && text.matches("-0*\\.?0*") ? text.substring(1) : text;
    }
}
