package org.SEAR.protocol.ubx;

/**
 * The fields of NAV-PVT, the solution of one moment: where each lies in the 92 bytes, and how long it is. Source: the field tables of gpsd and
 * pyubx2, which agree.
 */
public enum NavPvt {
    /** Milliseconds of the GPS week. */
    TIME_OF_WEEK(0, 4, false),
    YEAR(4, 2, false),
    MONTH(6, 1, false),
    DAY(7, 1, false),
    HOUR(8, 1, false),
    MINUTE(9, 1, false),
    SECOND(10, 1, false),
    /** 1 date, 2 time of day, 4 no doubt about either. */
    VALID(11, 1, false),
    /** Nanoseconds. */
    TIME_ACCURACY(12, 4, false),
    /** Nanoseconds on top of the second, may be negative. */
    NANO(16, 4, true),
    /** 0 none, 2 without, 3 with height. */
    FIX_TYPE(20, 1, false),
    /** 1 the fix is good. */
    FLAGS(21, 1, false),
    FLAGS_2(22, 1, false),
    SATELLITES(23, 1, false),
    /** 1e-7 degrees, east positive. */
    LONGITUDE(24, 4, true),
    /** 1e-7 degrees, north positive. */
    LATITUDE(28, 4, true),
    /** Above the ellipsoid, millimetres. */
    HEIGHT(32, 4, true),
    /** Above mean sea level, millimetres. */
    ALTITUDE(36, 4, true),
    /** Millimetres. */
    HORIZONTAL_ACCURACY(40, 4, false),
    /** Millimetres. */
    VERTICAL_ACCURACY(44, 4, false),
    /** Millimetres a second. */
    NORTHWARD(48, 4, true),
    /** Millimetres a second. */
    EASTWARD(52, 4, true),
    /** Millimetres a second. */
    DOWNWARD(56, 4, true),
    /** Over ground, millimetres a second. */
    SPEED(60, 4, true),
    /** 1e-5 degrees clockwise from true north. */
    COURSE(64, 4, true),
    /** Millimetres a second. */
    SPEED_ACCURACY(68, 4, false),
    /** 1e-5 degrees. */
    COURSE_ACCURACY(72, 4, false),
    /** Hundredths. */
    PDOP(76, 2, false),
    /** 1 the place is not valid. */
    FLAGS_3(78, 2, false);

    /** Bytes of the payload of older receivers, u-blox 7, which lacks nothing that is here. */
    public static final int LEAST = 84;
    /** Bytes of the payload. */
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

    /** Reads the field of a payload of {@link #LEAST} bytes or more. */
    public long get(byte[] payload) {
        long value = signed ? payload[offset + size - 1] : payload[offset + size - 1] & BYTE;
        for (int i = offset + size - 2; i >= offset; i--) {
            value = value << BITS | payload[i] & BYTE;
        }
        return value;
    }

    /** Writes the field's lowest bytes into a payload of {@link #SIZE} bytes. */
    public void put(byte[] payload, long value) {
        for (int i = 0; i < size; i++) {
            payload[offset + i] = (byte) (value >> BITS * i);
        }
    }
}
