// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.gps;

import java.time.LocalDate;
import java.time.LocalDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.ubx.NavPvt;

/** Converts a u-blox NAV-PVT message to the GGA sentence of the same fix, so that scripts read both alike. */
public final class PvtFix {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HHmmss.SS", Locale.ROOT);
    private static final DateTimeFormatter MOMENT = DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SS'Z'",
        Locale.ROOT);
    private static final int DATE_KNOWN = 1;
    private static final double DEGREES = 1e7;
    private static final double METRES = 1000;
    private static final int MINUTE_DECIMALS = 7;
    private static final int TIME_OF_DAY_KNOWN = 2;
    /** Fix type of a receiver for time only, which reports its surveyed position. */
    private static final int SURVEYED = 5;
    private static final int MANUAL = 7;
    private static final int DEAD_RECKONING = 6;
    private static final int DIFFERENTIAL = 2;
    /** Fix type without height: the receiver repeats an old one. */
    private static final int FLAT = 2;
    /** Half the last digit of the time, nanoseconds. */
    private static final long HALF = 5000000;

    private PvtFix() {
    }

    /**
     * Returns the fix. HDOP stays empty because NAV-PVT doesn't contain it, and altitude without a height.
     *
     * @param payload payload of NAV-PVT
     * @throws IllegalArgumentException if the payload is too short or its time is invalid
     */
    public static Fix of(byte[] payload) {
        if (payload.length < NavPvt.LEAST) {
            throw new IllegalArgumentException("NAV-PVT has " + payload.length + " bytes, legal: " + NavPvt.LEAST
                + " or more");
        }
        String where = position(NavPvt.LATITUDE.get(payload) / DEGREES, Nmea.LATITUDE_DIGITS, "N", "S") + ","
            + position(NavPvt.LONGITUDE.get(payload) / DEGREES, Nmea.LONGITUDE_DIGITS, "E", "W");
        double altitude = NavPvt.ALTITUDE.get(payload) / METRES;
        double separation = NavPvt.HEIGHT.get(payload) / METRES - altitude;
        int quality = quality(payload);
        boolean high = quality > 0 && NavPvt.FIX_TYPE.get(payload) != FLAT;
        return FixSentences.converted("NAV-PVT",
            Nmea.sentence("GNGGA," + time(payload) + "," + (quality == 0 ? ",,," : where) + "," + quality + ","
            + String.format(Locale.ROOT, "%02d", NavPvt.SATELLITES.get(payload)) + ",,"
            + (high ? Nmea.number(altitude, 3) + ",M," + Nmea.number(separation, 3) : ",,") + ",M,,").trim());
    }

    private static String position(double degrees, int width, String positive, String negative) {
        return Nmea.degrees(degrees, width, MINUTE_DECIMALS) + "," + (degrees < 0 ? negative : positive);
    }

    private static String time(byte[] payload) {
        return isKnown(payload, TIME_OF_DAY_KNOWN) ? TIME.format(moment(payload)) : "";
    }

    /** Returns the UTC as in {@link Reception#getTime}; null if the receiver does not know it. */
    static String utc(byte[] payload) {
        return isKnown(payload, DATE_KNOWN | TIME_OF_DAY_KNOWN) ? MOMENT.format(moment(payload)) : null;
    }

    private static boolean isKnown(byte[] payload, int mask) {
        return (NavPvt.VALID.get(payload) & mask) == mask;
    }

    /** Returns the UTC, rounded to hundredths by the formats. The field of nanoseconds may be negative. */
    private static LocalDateTime moment(byte[] payload) {
        return LocalDate.of((int) NavPvt.YEAR.get(payload), 1, 1).plusMonths(NavPvt.MONTH.get(payload) - 1)
            .plusDays(NavPvt.DAY.get(payload) - 1)
            .atStartOfDay().plusHours(NavPvt.HOUR.get(payload)).plusMinutes(NavPvt.MINUTE.get(payload))
            .plusSeconds(NavPvt.SECOND.get(payload)).plusNanos(NavPvt.NANO.get(payload) + HALF);
    }

    private static int quality(byte[] payload) {
        long flags = NavPvt.FLAGS.get(payload);
        long type = NavPvt.FIX_TYPE.get(payload);
        if ((flags & 1) == 0 || type < 1 || type > SURVEYED) {
            return 0;
        }
        if (type == SURVEYED) {
            return MANUAL;
        }
        return type == 1 ? DEAD_RECKONING : (flags & DIFFERENTIAL) != 0 ? 2 : 1;
    }
}
