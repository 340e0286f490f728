package org.SEAR.devices.gps;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.Locale;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.sensors.GpsFix;

/**
 * The sentences of one fix, without their frame. Fields as in recordings of an MT3301, for example
 * {@code GPGGA,081436.000,5212.982135,N,00653.101394,E,1,3,2.88,102.907,M,47.093,M,,}.
 */
final class Sentences {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("HHmmss.SSS", Locale.ROOT);
    private static final DateTimeFormatter DATE = DateTimeFormatter.ofPattern("ddMMyy", Locale.ROOT);
    private static final DateTimeFormatter ZDA_DATE = DateTimeFormatter.ofPattern("dd,MM,yyyy", Locale.ROOT);
    private static final double KNOTS = 3600 / 1852.0;
    private static final double KILOMETRES_PER_HOUR = 3.6;
    /** The simulated world's sea level is the ellipsoid. */
    private static final double GEOID_SEPARATION = 0;

    private final GpsModel model;
    private final GpsFix fix;
    private final ZonedDateTime time;

    /**
     * @param fix null for none
     * @param millis UTC since 1970
     */
    Sentences(GpsModel model, GpsFix fix, long millis) {
        this.model = model;
        this.fix = fix;
        this.time = Instant.ofEpochMilli(millis).atZone(ZoneOffset.UTC);
    }

    String gga() {
        return fix == null ? ggaNoFix() : gga(Satellites.size(), Satellites.HDOP, GEOID_SEPARATION);
    }

    String gga(int satellites, String hdop, double separation) {
        int decimals = model.getAltitudeDecimals();
        return "GPGGA," + TIME.format(time) + "," + position() + ",1," + satellites + "," + hdop + "," + Nmea.number(fix.getAltitude(), decimals)
            + ",M," + Nmea.number(separation, decimals) + ",M,,";
    }

    private String ggaNoFix() {
        return "GPGGA," + TIME.format(time) + "," + model.getNoPosition() + ",0,0,," + model.getNoAltitude() + ",,";
    }

    String rmc() {
        String where = fix == null ? ",V,,,,,,," : ",A," + position() + "," + knots() + "," + course() + ",";
        return "GPRMC," + TIME.format(time) + where + DATE.format(time) + ",,," + (fix == null ? "N" : "A");
    }

    String vtg() {
        if (fix == null) {
            return "GPVTG,,T,,M,,N,,K,N";
        }
        return "GPVTG," + course() + ",T,,M," + knots() + ",N," + Nmea.number(fix.getSpeed() * KILOMETRES_PER_HOUR, 3) + ",K,A";
    }

    String gll() {
        return "GPGLL," + (fix == null ? ",,," : position()) + "," + TIME.format(time) + (fix == null ? ",V,N" : ",A,A");
    }

    String zda() {
        return "GPZDA," + TIME.format(time) + "," + ZDA_DATE.format(time) + ",00,00";
    }

    private String position() {
        int decimals = model.getMinuteDecimals();
        return Nmea.degrees(fix.getLatitude(), Nmea.LATITUDE_DIGITS, decimals) + (fix.getLatitude() < 0 ? ",S," : ",N,")
            + Nmea.degrees(fix.getLongitude(), Nmea.LONGITUDE_DIGITS, decimals) + (fix.getLongitude() < 0 ? ",W" : ",E");
    }

    private String knots() {
        return Nmea.number(fix.getSpeed() * KNOTS, 3);
    }

    private String course() {
        return Nmea.number(fix.getCourse() % 360, 2);
    }
}
