// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import java.nio.ByteBuffer;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import org.SEAR.geometry.Geoid;
import org.SEAR.protocol.ubx.NavPvt;
import org.SEAR.protocol.ubx.UbxFrame;
import org.SEAR.protocol.ubx.UbxMessage;
import org.SEAR.sensors.GpsFix;

/**
 * Solution of a u-blox receiver at one moment, as payloads of class NAV. Accuracies are from the data sheet. Simulation
 * thread.
 */
final class UbxSolution {
    /** GPS time minus UTC since 2017, seconds. */
    private static final int LEAP_SECONDS = 18;
    /** 1980-01-06 in milliseconds since 1970. */
    private static final long GPS_EPOCH = 315964800000L;
    private static final long WEEK = 604800000L;
    private static final long MILLIS = 1000;
    private static final long NANOS = 1000000;
    private static final double MILLIMETRES = 1000;
    private static final double CENTIMETRES = 100;
    private static final double DEGREES_1E7 = 1e7;
    private static final double DEGREES_1E5 = 1e5;
    private static final double HUNDREDTHS = 100;
    private static final double EQUATOR = 6378137;
    private static final double FLATTENING = 1 / 298.257223563;
    private static final long HORIZONTAL_MM = 2500;
    private static final long VERTICAL_MM = 4000;
    private static final long SPEED_MM = 50;
    private static final long COURSE_1E5 = 50000;
    private static final long UNKNOWN_COURSE_1E5 = 18000000;
    private static final long TIME_NS = 30;
    private static final long UNKNOWN = 0xFFFFFFFFL;
    private static final int UNKNOWN_DOP = 9999;
    private static final double GDOP = 2.13;
    private static final double TDOP = 1;
    private static final double NDOP = 0.75;
    private static final double EDOP = 0.69;
    private static final int THREE_D = 3;
    private static final int TIME_VALID = 7;
    private static final int GPS_TIME_KNOWN = 0x0C;
    /** Flags of NAV-SAT: code and carrier locked, used, healthy, orbit from the satellite's own ephemeris. */
    private static final int USED = 0x191F;

    private final GpsFix fix;
    private final long utc;
    private final boolean timeKnown;
    private final long firstFixAfter;
    private final long sinceStart;
    private final long gpsTime;

    /**
     * @param fix null for none
     * @param utc milliseconds since 1970
     * @param timeKnown whether satellites have supplied the time
     * @param firstFixAfter milliseconds from start to first fix, 0 if there was none
     * @param sinceStart milliseconds since its start
     */
    UbxSolution(GpsFix fix, long utc, boolean timeKnown, long firstFixAfter, long sinceStart) {
        this.fix = fix;
        this.utc = utc;
        this.timeKnown = timeKnown;
        this.firstFixAfter = firstFixAfter;
        this.sinceStart = sinceStart;
        this.gpsTime = utc - GPS_EPOCH + LEAP_SECONDS * MILLIS;
    }

    /** Returns the payload of a message of class NAV. */
    byte[] payload(UbxMessage message) {
        switch (message) {
            case NAV_POSECEF:
                return ecef(start(20), place(), HORIZONTAL_MM / 10).array();
            case NAV_VELECEF:
                return ecef(start(20), velocity(), SPEED_MM / 10).array();
            case NAV_POSLLH:
                return position(start(28)).array();
            case NAV_STATUS:
                return start(16).put((byte) fixType()).put((byte) flags()).put((byte) 0).put((byte) 8)
                    .putInt((int) firstFixAfter).putInt((int) sinceStart).array();
            case NAV_DOP:
                return dops();
            case NAV_SOL:
                return solution();
            case NAV_PVT:
                return pvt();
            case NAV_VELNED:
                return velocityNed();
            case NAV_TIMEGPS:
                return start(16).putInt(0).putShort(week()).put((byte) LEAP_SECONDS)
                    .put((byte) (timeKnown ? TIME_VALID : 0)).putInt(timeAccuracy()).array();
            case NAV_CLOCK:
                return start(20).putInt(0).putInt(0).putInt(timeAccuracy()).putInt(timeAccuracy()).array();
            case NAV_SAT:
                return satellites();
            default:
                return start(4).array();
        }
    }

    private ByteBuffer start(int size) {
        return UbxFrame.room(size).putInt((int) (gpsTime % WEEK));
    }

    private short week() {
        return (short) (gpsTime / WEEK);
    }

    private int timeAccuracy() {
        return (int) (timeKnown ? TIME_NS : UNKNOWN);
    }

    private int fixType() {
        return fix == null ? 0 : THREE_D;
    }

    private int flags() {
        return (fix == null ? 0 : 1) | (timeKnown ? GPS_TIME_KNOWN : 0);
    }

    private int accuracy(long known) {
        return (int) (fix == null ? UNKNOWN : known);
    }

    private static int scaled(double value, double scale) {
        return (int) Math.round(value * scale);
    }

    private int dop(double value) {
        return fix == null ? UNKNOWN_DOP : scaled(value, HUNDREDTHS);
    }

    /** Height above the ellipsoid, metres. */
    private double height() {
        return fix.getAltitude() + Geoid.separation(fix.getLatitude(), fix.getLongitude());
    }

    private double north() {
        return fix.getSpeed() * Math.cos(Math.toRadians(fix.getCourse()));
    }

    private double east() {
        return fix.getSpeed() * Math.sin(Math.toRadians(fix.getCourse()));
    }

    /**
     * Position in ECEF, metres: x towards the equator and Greenwich, y towards the equator and 90 degrees east, z
     * towards the north pole; zeros without a fix.
     */
    private double[] place() {
        if (fix == null) {
            return new double[3];
        }
        double latitude = Math.toRadians(fix.getLatitude());
        double longitude = Math.toRadians(fix.getLongitude());
        double square = FLATTENING * (2 - FLATTENING);
        double curve = EQUATOR / Math.sqrt(1 - square * Math.sin(latitude) * Math.sin(latitude));
        double out = (curve + height()) * Math.cos(latitude);
        return new double[] {out * Math.cos(longitude), out * Math.sin(longitude),
            (curve * (1 - square) + height()) * Math.sin(latitude)};
    }

    /** Velocity in ECEF, m/s, axes as in {@link #place}. */
    private double[] velocity() {
        if (fix == null) {
            return new double[3];
        }
        double latitude = Math.toRadians(fix.getLatitude());
        double longitude = Math.toRadians(fix.getLongitude());
        double out = fix.getClimb() * Math.cos(latitude) - north() * Math.sin(latitude);
        return new double[] {out * Math.cos(longitude) - east() * Math.sin(longitude), out * Math.sin(longitude)
            + east() * Math.cos(longitude), fix.getClimb() * Math.sin(latitude) + north() * Math.cos(latitude)};
    }

    private ByteBuffer ecef(ByteBuffer to, double[] vector, long accuracy) {
        for (double each : vector) {
            to.putInt(scaled(each, CENTIMETRES));
        }
        return to.putInt(accuracy(accuracy));
    }

    /** Appends longitude, latitude, both heights and their accuracies. */
    private ByteBuffer position(ByteBuffer to) {
        boolean known = fix != null;
        to.putInt(known ? scaled(fix.getLongitude(), DEGREES_1E7) : 0)
            .putInt(known ? scaled(fix.getLatitude(), DEGREES_1E7) : 0);
        to.putInt(known ? scaled(height(), MILLIMETRES) : 0).putInt(known ? scaled(fix.getAltitude(), MILLIMETRES) : 0);
        return to.putInt(accuracy(HORIZONTAL_MM)).putInt(accuracy(VERTICAL_MM));
    }

    private byte[] dops() {
        ByteBuffer to = start(18);
        for (double each : new double[] {GDOP, Constellation.PDOP, TDOP, Constellation.VDOP, Constellation.HDOP,
            NDOP, EDOP}) {
            to.putShort((short) dop(each));
        }
        return to.array();
    }

    private byte[] solution() {
        ByteBuffer to = start(52).putInt(0).putShort(week()).put((byte) fixType()).put((byte) flags());
        ecef(to, place(), HORIZONTAL_MM / 10);
        ecef(to, velocity(), SPEED_MM / 10);
        return to.putShort((short) dop(Constellation.PDOP)).put((byte) 0).put((byte) used()).array();
    }

    private int used() {
        return fix == null ? 0 : SentenceStyle.UBLOX.satellites();
    }

    private byte[] velocityNed() {
        ByteBuffer to = start(36);
        boolean known = fix != null;
        to.putInt(known ? scaled(north(), CENTIMETRES) : 0).putInt(known ? scaled(east(), CENTIMETRES) : 0);
        to.putInt(known ? scaled(-fix.getClimb(), CENTIMETRES) : 0);
        to.putInt(known ? scaled(Math.hypot(fix.getSpeed(), fix.getClimb()), CENTIMETRES) : 0);
        to.putInt(known ? scaled(fix.getSpeed(), CENTIMETRES) : 0)
            .putInt(known ? scaled(fix.getCourse(), DEGREES_1E5) : 0);
        return to.putInt(accuracy(SPEED_MM / 10)).putInt(courseAccuracy()).array();
    }

    private int courseAccuracy() {
        return (int) (fix == null ? UNKNOWN_COURSE_1E5 : COURSE_1E5);
    }

    private byte[] pvt() {
        byte[] to = new byte[NavPvt.SIZE];
        ByteBuffer position = position(start(28));
        System.arraycopy(position.array(), 0, to, 0, 4);
        ZonedDateTime time = Instant.ofEpochMilli(utc).atZone(ZoneOffset.UTC);
        NavPvt.YEAR.put(to, time.getYear());
        NavPvt.MONTH.put(to, time.getMonthValue());
        NavPvt.DAY.put(to, time.getDayOfMonth());
        NavPvt.HOUR.put(to, time.getHour());
        NavPvt.MINUTE.put(to, time.getMinute());
        NavPvt.SECOND.put(to, time.getSecond());
        NavPvt.VALID.put(to, timeKnown ? TIME_VALID : 0);
        NavPvt.TIME_ACCURACY.put(to, timeAccuracy());
        NavPvt.NANO.put(to, utc % MILLIS * NANOS);
        NavPvt.FIX_TYPE.put(to, fixType());
        NavPvt.FLAGS.put(to, fix == null ? 0 : 1);
        NavPvt.SATELLITES.put(to, used());
        System.arraycopy(position.array(), 4, to, 24, 24);
        NavPvt.SPEED_ACCURACY.put(to, accuracy(SPEED_MM));
        NavPvt.COURSE_ACCURACY.put(to, courseAccuracy());
        NavPvt.PDOP.put(to, dop(Constellation.PDOP));
        NavPvt.FLAGS_3.put(to, fix == null ? 1 : 0);
        if (fix != null) {
            NavPvt.NORTHWARD.put(to, scaled(north(), MILLIMETRES));
            NavPvt.EASTWARD.put(to, scaled(east(), MILLIMETRES));
            NavPvt.DOWNWARD.put(to, scaled(-fix.getClimb(), MILLIMETRES));
            NavPvt.SPEED.put(to, scaled(fix.getSpeed(), MILLIMETRES));
            NavPvt.COURSE.put(to, scaled(fix.getCourse(), DEGREES_1E5));
        }
        return to;
    }

    /** NAV-SAT with all satellites in view; none without a fix. */
    private byte[] satellites() {
        ByteBuffer to = start(8 + 12 * used()).put((byte) 1).put((byte) used()).putShort((short) 0);
        if (fix != null) {
            for (Constellation each : SentenceStyle.UBLOX.sky) {
                for (int i = 0; i < each.size(); i++) {
                    to.put((byte) each.getUbxId()).put((byte) each.number(i)).put((byte) each.signal(i))
                        .put((byte) each.elevation(i));
                    to.putShort((short) each.azimuth(i)).putShort((short) 0).putInt(USED);
                }
            }
        }
        return to.array();
    }
}
