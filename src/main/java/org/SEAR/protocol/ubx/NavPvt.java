// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.ubx;

/**
 * Fields of NAV-PVT, the navigation solution of one moment: offset and size in the 92 bytes. Source: the field tables
 * of gpsd and pyubx2, which agree.
 */
public enum NavPvt {
    /** Time of the GPS week, milliseconds. */
    TIME_OF_WEEK(0, 4, false),
    YEAR(4, 2, false),
    MONTH(6, 1, false),
    DAY(7, 1, false),
    HOUR(8, 1, false),
    MINUTE(9, 1, false),
    SECOND(10, 1, false),
    /** Bit mask: 1 valid date, 2 valid time of day, 4 fully resolved. */
    VALID(11, 1, false),
    /** Accuracy of the time, nanoseconds. */
    TIME_ACCURACY(12, 4, false),
    /** Fraction of the second, nanoseconds; may be negative. */
    NANO(16, 4, true),
    /** 0 no fix, 2 without height, 3 with height. */
    FIX_TYPE(20, 1, false),
    /** Bit mask: 1 valid fix. */
    FLAGS(21, 1, false),
    FLAGS_2(22, 1, false),
    SATELLITES(23, 1, false),
    /** Longitude, 1e-7 degrees, east positive. */
    LONGITUDE(24, 4, true),
    /** Latitude, 1e-7 degrees, north positive. */
    LATITUDE(28, 4, true),
    /** Height above the ellipsoid, millimetres. */
    HEIGHT(32, 4, true),
    /** Height above mean sea level, millimetres. */
    ALTITUDE(36, 4, true),
    /** Horizontal accuracy, millimetres. */
    HORIZONTAL_ACCURACY(40, 4, false),
    /** Vertical accuracy, millimetres. */
    VERTICAL_ACCURACY(44, 4, false),
    /** Velocity north, mm/s. */
    NORTHWARD(48, 4, true),
    /** Velocity east, mm/s. */
    EASTWARD(52, 4, true),
    /** Velocity down, mm/s. */
    DOWNWARD(56, 4, true),
    /** Speed over ground, mm/s. */
    SPEED(60, 4, true),
    /** Course, 1e-5 degrees clockwise from true north. */
    COURSE(64, 4, true),
    /** Accuracy of the speed, mm/s. */
    SPEED_ACCURACY(68, 4, false),
    /** Accuracy of the course, 1e-5 degrees. */
    COURSE_ACCURACY(72, 4, false),
    /** Position dilution of precision, hundredths. */
    PDOP(76, 2, false),
    /** Bit mask: 1 invalid position. */
    FLAGS_3(78, 2, false);

    /** Size of older receivers' payload (u-blox 7), bytes; it contains all fields here. */
    public static final int LEAST = 84;
    /** Size of the payload, bytes. */
    public static final int SIZE = 92;
    private static final int BITS = 8;
    private static final int BYTE = 0xFF;

    private final int offset;
    private final int size;
    private final boolean signed;

    NavPvt(int offset, int size, boolean signed) {
        this.offset = offset;
        this.size = size;
        this.signed = signed;
    }

    /** Reads the field from a payload of at least {@link #LEAST} bytes. */
    public long get(byte[] payload) {
        long value = signed ? payload[offset + size - 1] : payload[offset + size - 1] & BYTE;
        for (int i = offset + size - 2; i >= offset; i--) {
            value = value << BITS | payload[i] & BYTE;
        }
        return value;
    }

    /** Writes the field's low bytes into a payload of {@link #SIZE} bytes. */
    public void put(byte[] payload, long value) {
        for (int i = 0; i < size; i++) {
            payload[offset + i] = (byte) (value >> BITS * i);
        }
    }
}
