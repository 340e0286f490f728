// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

/**
 * Number of distance bits of a value; the other bits are flags of fields and reflectors, which the simulated device
 * never sets. The largest numbers are codes: no hit, dazzled, beyond the range. Source: SICK telegram listing, tables
 * 7-31 and 10-13 to 10-15.
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

    /** Number of codes below the largest number: xFF7 to xFFF are no distances. */
    private static final int OVERFLOWS = 8;

    private final int code;
    private final int bits;

    MeasuringMode(int code, int bits) {
        this.code = code;
        this.bits = bits;
    }

    /** Finds the mode of block D of the configuration; null if an LMS200 does not have it. */
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

    /** Returns a value without its flags. */
    public int getDistance(int value) {
        return value & getNothingHit();
    }

    /** Code for no hit: 8191, 16383 or 32767. */
    public int getNothingHit() {
        return (1 << bits) - 1;
    }

    /** Code for a hit beyond the measuring range, and smallest value that is not a distance: 8183, 16375 or 32759. */
    public int getBeyondRange() {
        return getNothingHit() - OVERFLOWS;
    }

    /**
     * Encodes a distance.
     *
     * @param metres +infinity for no hit
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
