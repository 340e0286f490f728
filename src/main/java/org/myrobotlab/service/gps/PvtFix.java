package org.myrobotlab.service.gps;

import java.time.LocalTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.protocol.ubx.NavPvt;

/** Converts a u-blox NAV-PVT message to the GGA sentence of the same fix, so that scripts read both alike. */
public final class PvtFix {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HHmmss.SS", Locale.ROOT);
    private static final double DEGREES = 1e7;
    private static final double METRES = 1000;
    private static final int MINUTE_DECIMALS = 7;
    private static final int TIME_OF_DAY_KNOWN = 2;
    private static final int DEAD_RECKONING = 6;
    private static final int DIFFERENTIAL = 2;
    private static final long DAY = 86400000000000L;
    private static final long SECOND = 1000000000L;
    /** Half the last digit of the time, nanoseconds. */
    private static final long HALF = 5000000;

    private PvtFix() {
    }

    /**
     * Returns the fix. HDOP stays empty because NAV-PVT doesn't contain it.
     *
     * @param payload payload of NAV-PVT
     * @throws IllegalArgumentException if the payload is too short or its time is invalid
     */
    public static GgaFix of(byte[] payload) {
        if (payload.length < NavPvt.LEAST) {
            throw new IllegalArgumentException("NAV-PVT has " + payload.length + " bytes, legal: " + NavPvt.LEAST + " or more");
        }
        String where = position(NavPvt.LATITUDE.get(payload) / DEGREES, Nmea.LATITUDE_DIGITS, "N", "S") + ","
            + position(NavPvt.LONGITUDE.get(payload) / DEGREES, Nmea.LONGITUDE_DIGITS, "E", "W");
        double altitude = NavPvt.ALTITUDE.get(payload) / METRES;
        double separation = NavPvt.HEIGHT.get(payload) / METRES - altitude;
        int quality = quality(payload);
        return new GgaFix(Nmea.sentence("GNGGA," + time(payload) + "," + (quality == 0 ? ",,," : where) + "," + quality + ","
            + String.format(Locale.ROOT, "%02d", NavPvt.SATELLITES.get(payload)) + ",,"
            + (quality == 0 ? ",," : Nmea.number(altitude, 3) + ",M," + Nmea.number(separation, 3)) + ",M,,").trim());
    }

    private static String position(double degrees, int width, String positive, String negative) {
        return Nmea.degrees(degrees, width, MINUTE_DECIMALS) + "," + (degrees < 0 ? negative : positive);
    }

    /** Returns hhmmss.ss. The field of nanoseconds may be negative. */
    private static String time(byte[] payload) {
        if ((NavPvt.VALID.get(payload) & TIME_OF_DAY_KNOWN) == 0) {
            return "";
        }
        long seconds = (NavPvt.HOUR.get(payload) * 60 + NavPvt.MINUTE.get(payload)) * 60 + NavPvt.SECOND.get(payload);
        return TIME.format(LocalTime.ofNanoOfDay(Math.floorMod(seconds * SECOND + NavPvt.NANO.get(payload) + HALF, DAY)));
    }

    private static int quality(byte[] payload) {
        long flags = NavPvt.FLAGS.get(payload);
        long type = NavPvt.FIX_TYPE.get(payload);
        if ((flags & 1) == 0 || type < 1 || type > 4) {
            return 0;
        }
        return type == 1 ? DEAD_RECKONING : (flags & DIFFERENTIAL) != 0 ? 2 : 1;
    }
}
