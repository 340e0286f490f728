package org.myrobotlab.service.gps;

import org.SEAR.protocol.nmea.Nmea;

/**
 * One GGA sentence: {@code
 * $GPGGA,hhmmss.sss,ddmm.mmmm,N,dddmm.mmmm,E,quality,satellites,hdop,altitude,M,separation,M,age,station*cs}.
 * JSON-friendly, immutable except for its array.
 */
public final class GgaFix {
    private static final int UTC = 1;
    private static final int LATITUDE = 2;
    private static final int NORTH_SOUTH = 3;
    private static final int LONGITUDE = 4;
    private static final int EAST_WEST = 5;
    private static final int QUALITY = 6;
    private static final int SATELLITES = 7;
    private static final int ALTITUDE = 9;
    private static final int FEWEST_TOKENS = 15;

    /** Fields of the sentence; latitude (2) and longitude (4) start with a minus in the south and west. */
    public final String[] tokens;
    /** Decimal degrees, north positive; 0 without a fix. */
    public final double latitude;
    /** Decimal degrees, east positive; 0 without a fix. */
    public final double longitude;
    /** Metres above mean sea level; 0 without a fix. */
    public final double altitude;
    /** 0 none, 1 GPS, 2 differential, 6 dead reckoning, 7 manual, 8 simulator. */
    public final int quality;
    /** Number of satellites used. */
    public final int satellites;
    /** Time of the fix, hhmmss.sss. */
    public final String utc;

    /** @throws IllegalArgumentException if it isn't a GGA sentence */
    public GgaFix(String sentence) {
        tokens = sentence.split(",", -1);
        if (tokens.length < FEWEST_TOKENS || !tokens[0].endsWith("GGA")) {
            throw new IllegalArgumentException("not a GGA sentence: " + sentence);
        }
        utc = tokens[UTC];
        quality = tokens[QUALITY].isEmpty() ? 0 : Integer.parseInt(tokens[QUALITY]);
        satellites = tokens[SATELLITES].isEmpty() ? 0 : Integer.parseInt(tokens[SATELLITES]);
        latitude = hasFix() ? degrees(tokens[LATITUDE], Nmea.LATITUDE_DIGITS, "S".equals(tokens[NORTH_SOUTH])) : 0;
        longitude = hasFix() ? degrees(tokens[LONGITUDE], Nmea.LONGITUDE_DIGITS, "W".equals(tokens[EAST_WEST])) : 0;
        altitude = hasFix() && !tokens[ALTITUDE].isEmpty() ? Double.parseDouble(tokens[ALTITUDE]) : 0;
        sign(LATITUDE, "S".equals(tokens[NORTH_SOUTH]));
        sign(LONGITUDE, "W".equals(tokens[EAST_WEST]));
    }

    private void sign(int token, boolean negative) {
        if (negative) {
            tokens[token] = "-" + tokens[token];
        }
    }

    private static double degrees(String token, int degreeDigits, boolean negative) {
        double degrees = Nmea.degrees(token, degreeDigits);
        return negative ? -degrees : degrees;
    }

    public boolean hasFix() {
        return quality > 0;
    }
}
