package org.SEAR.protocol.lms;

/**
 * How many bits of a value are the distance; the others are flags of fields and reflectors, which the simulated device never raises. The greatest
 * numbers are codes: nothing hit, dazzled, beyond the range. Source: SICK telegram listing, tables 7-31 and 10-13 to 10-15.
 */
public enum MeasuringMode {
    FIELDS_A_B_DAZZLE(0x00, 13),
    REFLECTOR_8(0x01, 13),
    FIELDS_A_B_C(0x02, 13),
    REFLECTOR_16(0x03, 14),
    FIELDS_16_A_B(0x04, 14),
    REFLECTOR_32(0x05, 15),
    FIELD_32_A(0x06, 15),
    IMMEDIATE_32(0x0F, 15);

    /** From here below the greatest number on, a value is no distance: xFF7 to xFFF. */
    private static final int OVERFLOWS = 8;

    private final int code;
    private final int bits;

    MeasuringMode(int code, int bits) {
        this.code = code;
        this.bits = bits;
    }

    /** The mode of block D of the configuration; null if an LMS200 has none such. */
    public static MeasuringMode of(int code) {
        for (MeasuringMode mode : values()) {
            if (mode.code == code) {
                return mode;
            }
        }
        return null;
    }

    /** Block D of the configuration. */
    public int getCode() {
        return code;
    }

    /** The distance bits of a value, without its flags. */
    public int getDistance(int value) {
        return value & getNothingHit();
    }

    /** The value where nothing was hit: 8191, 16383 or 32767. */
    public int getNothingHit() {
        return (1 << bits) - 1;
    }

    /** The value where something is beyond the measuring range: 8183, 16375 or 32759. From here on a value is no distance. */
    public int getBeyondRange() {
        return getNothingHit() - OVERFLOWS;
    }

    /**
     * The value for a distance.
     *
     * @param metres +infinity where nothing was hit
     * @param unitsPerMetre 1000 or 100
     */
    public int encode(double metres, int unitsPerMetre) {
        if (Double.isInfinite(metres) || Double.isNaN(metres)) {
            return getNothingHit();
        }
        long units = Math.round(metres * unitsPerMetre);
        return (int) Math.max(0, Math.min(units, getBeyondRange()));
    }
}
