// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.time.Instant;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Geoid;
import org.SEAR.protocol.nmea.Nmea;
import org.SEAR.sensors.GpsFix;

/**
 * Sentences of one fix, without their frame. Fields as in recordings of an MT3301, for example {@code
 * GPGGA,081436.000,5212.982135,N,00653.101394,E,1,3,2.88,102.907,M,47.093,M,,}.
 */
final class Sentences {
    private static final DateTimeFormatter DATE = DateTimeFormatter.ofPattern("ddMMyy", Locale.ROOT);
    private static final DateTimeFormatter ZDA_DATE = DateTimeFormatter.ofPattern("dd,MM,yyyy", Locale.ROOT);
    private static final double KNOTS = 3600 / 1852.0;
    private static final double KILOMETRES_PER_HOUR = 3.6;
    /** Speed below which the receiver stands, m/s. */
    private static final double STANDING = 0.1;

    private final SentenceStyle style;
    private final GpsFix fix;
    private final ZonedDateTime when;
    private final String time;

    /**
     * @param fix null for none
     * @param millis UTC since 1970; null if unknown
     */
    Sentences(SentenceStyle style, GpsFix fix, Long millis) {
        this.style = style;
        this.fix = fix;
        this.when = millis == null ? null : Instant.ofEpochMilli(millis).atZone(ZoneOffset.UTC);
        this.time = when == null ? "" : style.time.format(when);
    }

    String gga() {
        return fix == null ? ggaNoFix() : gga(style.satellites(), dop(Constellation.HDOP),
            Geoid.separation(fix.getLatitude(), fix.getLongitude()));
    }

    String gga(int satellites, String hdop, double separation) {
        int decimals = style.altitudeDecimals;
        return style.talker + "GGA," + time + "," + position() + ",1," + count(satellites) + "," + hdop + ","
            + Nmea.number(fix.getAltitude(), decimals) + ",M," + Nmea.number(separation, decimals) + ",M,,";
    }

    private String ggaNoFix() {
        return style.talker + "GGA," + time + "," + style.noPosition + ",0," + count(0) + "," + style.noDop + ","
            + style.noAltitude + ",,";
    }

    private String count(int satellites) {
        return String.format(Locale.ROOT, style.satelliteFormat, satellites);
    }

    String rmc() {
        String where = fix == null ? ",V,,,,,,," : ",A," + position() + "," + knots() + "," + course() + ",";
        return style.talker + "RMC," + time + where + (when == null ? "" : DATE.format(when)) + ",,,"
            + (fix == null ? "N" : "A");
    }

    String vtg() {
        if (fix == null) {
            return style.talker + "VTG," + style.noCourse + ",N";
        }
        return style.talker + "VTG," + course() + ",T,,M," + knots() + ",N,"
            + Nmea.number(fix.getSpeed() * KILOMETRES_PER_HOUR, 3) + ",K,A";
    }

    String gll() {
        return style.talker + "GLL," + (fix == null ? ",,," : position()) + "," + time
            + (fix == null ? ",V,N" : ",A,A");
    }

    String zda() {
        return style.talker + "ZDA," + time + "," + (when == null ? ",," : ZDA_DATE.format(when)) + ",00,00";
    }

    /** One body for each constellation: {@code GPGSA,A,3,21,28,...,1.88,1.02,1.58}. */
    List<String> gsa() {
        List<String> bodies = new ArrayList<>();
        for (Constellation each : style.sky) {
            bodies.add(style.talker + "GSA,A," + (fix == null ? 1 : 3) + each.used(fix != null) + ","
                + dop(Constellation.PDOP) + "," + dop(Constellation.HDOP) + "," + dop(Constellation.VDOP));
        }
        return bodies;
    }

    /** Several bodies for each constellation. */
    List<String> gsv(boolean seen) {
        List<String> bodies = new ArrayList<>();
        style.sky.forEach(each -> bodies.addAll(each.gsv(seen)));
        return bodies;
    }

    private String dop(double value) {
        return fix == null ? style.noDop : Nmea.number(value, 2);
    }

    private String position() {
        int decimals = style.minuteDecimals;
        return Nmea.degrees(fix.getLatitude(), Nmea.LATITUDE_DIGITS, decimals) + (fix.getLatitude() < 0 ? ",S," : ",N,")
            + Nmea.degrees(fix.getLongitude(), Nmea.LONGITUDE_DIGITS, decimals)
            + (fix.getLongitude() < 0 ? ",W" : ",E");
    }

    private String knots() {
        return Nmea.number(fix.getSpeed() * KNOTS, 3);
    }

    private String course() {
        return style.courseWhileStanding || fix.getSpeed() >= STANDING ? Nmea.number(fix.getCourse() % 360, 2) : "";
    }
}
