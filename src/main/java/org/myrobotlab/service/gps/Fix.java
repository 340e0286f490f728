// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.util.Arrays;
import java.util.Locale;
import org.SEAR.protocol.nmea.Nmea;

/**
 * A receiver's report about one moment, from GGA, GNS, RMC, GLL or NAV-PVT. Missing values are null. JSON-friendly,
 * immutable except for its array.
 */
public final class Fix {
    /** Index of the UTC in {@link #tokens}, hhmmss.sss. */
    static final int UTC = 1;
    /** Index of the latitude, ddmm.mmmm; N or S follows. */
    static final int LATITUDE = 2;
    /** Index of the longitude, dddmm.mmmm; E or W follows. */
    static final int LONGITUDE = 4;
    /** Index of the fix quality. */
    static final int QUALITY = 6;
    /** Index of the number of satellites. */
    static final int SATELLITES = 7;
    /** Index of the horizontal dilution of precision. */
    static final int HDOP = 8;
    /** Index of the altitude, metres. */
    static final int ALTITUDE = 9;
    /** Index of the geoid separation, metres. */
    static final int SEPARATION = 11;
    private static final int ALTITUDE_UNIT = 10;
    private static final int SEPARATION_UNIT = 12;
    private static final int SIZE = 15;
    private static final double LONGEST_LATITUDE = 90;
    private static final double LONGEST_LONGITUDE = 180;

    /** Fields as in GGA; latitude (2) and longitude (4) start with a minus in the south and west. */
    public final String[] tokens;
    /** Decimal degrees, north positive; null without a fix. */
    public final Double latitude;
    /** Decimal degrees, east positive; null without a fix. */
    public final Double longitude;
    /** Metres above mean sea level; null if not reported. */
    public final Double altitude;
    /** 0 none, 1 GPS, 2 differential, 3 precise, 4 and 5 RTK, 6 dead reckoning, 7 manual, 8 simulator. */
    public final int quality;
    /** Number of satellites used; null if not reported. */
    public final Integer satellites;
    /** Time of the fix, hhmmss.sss; null if not reported. */
    public final String utc;

    private final transient String source;
    private final transient int rank;

    /**
     * @param source talker and type of the sentence, or name of the message
     * @param tokens fields as in GGA, without checksum, latitude and longitude without sign
     * @param published the same fields as scripts get them; becomes signed
     * @param rank of two reports of one moment, the one with the higher rank is used
     * @throws IllegalArgumentException if a field is no number or no coordinate
     */
    Fix(String source, String[] tokens, String[] published, int rank) {
        this.source = source;
        this.tokens = published;
        this.rank = rank;
        utc = tokens[UTC].isEmpty() ? null : tokens[UTC];
        satellites = tokens[SATELLITES].isEmpty() ? null : Integer.valueOf(tokens[SATELLITES]);
        int reported = tokens[QUALITY].isEmpty() ? 0 : Integer.parseInt(tokens[QUALITY]);
        boolean known = reported > 0 && !tokens[LATITUDE].isEmpty() && !tokens[LONGITUDE].isEmpty();
        quality = known ? reported : 0;
        latitude = known ? degrees(tokens, LATITUDE, "S", LONGEST_LATITUDE) : null;
        longitude = known ? degrees(tokens, LONGITUDE, "W", LONGEST_LONGITUDE) : null;
        altitude = known && !tokens[ALTITUDE].isEmpty() ? Double.valueOf(tokens[ALTITUDE]) : null;
        sign(published, LATITUDE, "S");
        sign(published, LONGITUDE, "W");
    }

    /** Returns the fields of a GGA of the same fix: empty apart from units. */
    static String[] empty(String type) {
        String[] tokens = new String[SIZE];
        Arrays.fill(tokens, "");
        tokens[0] = type;
        tokens[ALTITUDE_UNIT] = "M";
        tokens[SEPARATION_UNIT] = "M";
        return tokens;
    }

    /** Puts a minus before a coordinate in the south or west. The hemisphere follows the coordinate. */
    private static void sign(String[] tokens, int token, String negative) {
        if (negative.equals(tokens[token + 1]) && !tokens[token].isEmpty()) {
            tokens[token] = "-" + tokens[token];
        }
    }

    private static double degrees(String[] tokens, int token, String negative, double most) {
        double degrees = Nmea.degrees(tokens[token]);
        if (degrees > most) {
            throw new IllegalArgumentException("coordinate \"" + tokens[token] + "\" is " + degrees
                + " degrees, legal: 0 to " + most);
        }
        return negative.equals(tokens[token + 1]) ? -degrees : degrees;
    }

    public boolean hasFix() {
        return quality > 0;
    }

    /** Returns for example {@code fix at 48.117300, 11.516667 degrees, 545.4 m, quality 1, UTC 120000.00}. */
    @Override
    public String toString() {
        StringBuilder text = new StringBuilder(hasFix()
            ? String.format(Locale.ROOT, "fix at %.6f, %.6f degrees", latitude, longitude) : "no fix");
        if (altitude != null) {
            text.append(", ").append(altitude).append(" m");
        }
        if (hasFix()) {
            text.append(", quality ").append(quality);
        }
        if (satellites != null) {
            text.append(", ").append(satellites).append(" satellites");
        }
        return utc == null ? text.toString() : text.append(", UTC ").append(utc).toString();
    }

    String source() {
        return source;
    }

    int rank() {
        return rank;
    }
}
