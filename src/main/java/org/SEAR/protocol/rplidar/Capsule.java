// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

import java.util.Arrays;

/**
 * 32 samples of an express scan in 84 bytes. First a checksum in two halves, after the marks {@code A} and {@code 5}.
 * Then the start angle in 64ths of a degree, with a bit for the first capsule. Then 16 cabins of 5 bytes: two distances
 * in whole millimetres with 2 bits of angle each, and 4 more bits of each angle. Immutable.
 */
public final class Capsule {
    /** Size, bytes. */
    public static final int SIZE = 84;
    /** Number of samples. */
    public static final int SAMPLES = 32;
    /** The largest distance, millimetres. */
    public static final int MAX_DISTANCE = 0x3FFF;
    private static final int FIRST_MARK = 0xA;
    private static final int SECOND_MARK = 0x5;
    private static final int CABINS_AT = 4;
    private static final int CABIN = 5;
    private static final int NEW = 0x8000;
    private static final double ANGLE_UNITS = 64;
    /** Units per degree of a sample's angular shift. */
    private static final double SHIFT_UNITS = 8;
    private static final int SHIFT_SIGN = 0x20;

    private final boolean first;
    private final int start;
    private final int[] distances;
    private final int[] shifts;

    private Capsule(boolean first, int start, int[] distances, int[] shifts) {
        this.first = first;
        this.start = start;
        this.distances = distances;
        this.shifts = shifts;
    }

    /**
     * @param first whether it is the first capsule after the request
     * @param degrees 0 to below 360, clockwise
     * @param distances 32, whole millimetres up to 16383; 0 for none
     */
    public static Capsule of(boolean first, double degrees, int[] distances) {
        int units = (int) (360 * ANGLE_UNITS);
        return new Capsule(first, Math.floorMod((int) Math.round(degrees * ANGLE_UNITS), units),
            Arrays.copyOf(distances, SAMPLES), new int[SAMPLES]);
    }

    /** Reads a capsule from 84 bytes; null if marks or checksum are wrong. */
    public static Capsule of(byte[] bytes) {
        boolean marked = (bytes[0] & 0xF0) >> 4 == FIRST_MARK && (bytes[1] & 0xF0) >> 4 == SECOND_MARK;
        if (!marked || sum(bytes) != ((bytes[0] & 0xF) | (bytes[1] & 0xF) << 4)) {
            return null;
        }
        int start = word(bytes, 2);
        int[] distances = new int[SAMPLES];
        int[] shifts = new int[SAMPLES];
        for (int i = 0; i < SAMPLES; i++) {
            int cabin = CABINS_AT + i / 2 * CABIN;
            int word = word(bytes, cabin + i % 2 * 2);
            distances[i] = word >> 2;
            shifts[i] = (word & 3) << 4 | bytes[cabin + 4] >> i % 2 * 4 & 0xF;
        }
        return new Capsule((start & NEW) != 0, start & ~NEW, distances, shifts);
    }

    private static int word(byte[] bytes, int at) {
        return bytes[at] & 0xFF | (bytes[at + 1] & 0xFF) << 8;
    }

    private static int sum(byte[] bytes) {
        int sum = 0;
        for (int i = 2; i < SIZE; i++) {
            sum ^= bytes[i];
        }
        return sum & 0xFF;
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        byte[] bytes = new byte[SIZE];
        int angle = start | (first ? NEW : 0);
        bytes[2] = (byte) angle;
        bytes[3] = (byte) (angle >> 8);
        for (int i = 0; i < SAMPLES; i++) {
            int cabin = CABINS_AT + i / 2 * CABIN;
            int word = Math.min(MAX_DISTANCE, distances[i]) << 2 | shifts[i] >> 4;
            bytes[cabin + i % 2 * 2] = (byte) word;
            bytes[cabin + i % 2 * 2 + 1] = (byte) (word >> 8);
            bytes[cabin + 4] |= (byte) ((shifts[i] & 0xF) << i % 2 * 4);
        }
        int sum = sum(bytes);
        bytes[0] = (byte) (FIRST_MARK << 4 | sum & 0xF);
        bytes[1] = (byte) (SECOND_MARK << 4 | sum >> 4);
        return bytes;
    }

    /** Whether it is the first capsule after the request. */
    public boolean isFirst() {
        return first;
    }

    /** Start angle, degrees, clockwise seen from above, 0 ahead. */
    public double getStart() {
        return start / ANGLE_UNITS;
    }

    /** Distance of a sample, millimetres; 0 for none. */
    public int getDistance(int sample) {
        return distances[sample];
    }

    /**
     * Angle, degrees, by which a sample lies before its place in an even division between this capsule's start and the
     * next one's.
     */
    public double getShift(int sample) {
        int magnitude = shifts[sample] & ~SHIFT_SIGN;
        return ((shifts[sample] & SHIFT_SIGN) != 0 ? -magnitude : magnitude) / SHIFT_UNITS;
    }
}
