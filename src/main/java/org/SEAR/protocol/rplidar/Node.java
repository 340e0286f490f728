// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

/**
 * One sample of a scan in 5 bytes. Byte 0: start of a turn (bit 0), its complement (bit 1), 6 bits of quality. Then a
 * check bit 1 and 15 bits of angle in 64ths of a degree, clockwise from ahead. Then 16 bits of distance in quarters of
 * a millimetre, 0 for none. 1 m at 1 degree, quality 15: {@code 3E 81 00 A0 0F}. Immutable.
 */
public final class Node {
    /** Size, bytes. */
    public static final int SIZE = 5;
    /** The largest quality. */
    public static final int MAX_QUALITY = 63;
    private static final double ANGLE_UNITS = 64;
    private static final double DISTANCE_UNITS = 4;
    private static final int MAX_ANGLE = 0x7FFF;
    private static final int MAX_DISTANCE = 0xFFFF;

    private final boolean first;
    private final int quality;
    private final int angle;
    private final int distance;

    private Node(boolean first, int quality, int angle, int distance) {
        this.first = first;
        this.quality = quality;
        this.angle = angle;
        this.distance = distance;
    }

    /**
     * @param first whether it is the first of a turn
     * @param quality 0 to 63
     * @param degrees 0 to 360, clockwise
     * @param millimetres up to 16383; 0 for none
     */
    public static Node of(boolean first, int quality, double degrees, double millimetres) {
        return new Node(first, quality, (int) Math.min(MAX_ANGLE, Math.round(degrees * ANGLE_UNITS)),
            (int) Math.min(MAX_DISTANCE, Math.round(millimetres * DISTANCE_UNITS)));
    }

    /** Reads a node from 5 bytes; null if its check bits are wrong. */
    public static Node of(byte[] bytes) {
        int head = bytes[0] & 0xFF;
        if ((head & 1) == (head >> 1 & 1) || (bytes[1] & 1) == 0) {
            return null;
        }
        return new Node((head & 1) == 1, head >> 2, (bytes[1] & 0xFF | (bytes[2] & 0xFF) << 8) >> 1, bytes[3] & 0xFF
            | (bytes[4] & 0xFF) << 8);
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        int coded = angle << 1 | 1;
        return new byte[] {(byte) (quality << 2 | (first ? 1 : 2)), (byte) coded, (byte) (coded >> 8), (byte) distance,
            (byte) (distance >> 8)};
    }

    /** Whether it is the first of a turn. */
    public boolean isFirst() {
        return first;
    }

    /** Quality, 0 to 63. */
    public int getQuality() {
        return quality;
    }

    /** Angle, degrees, clockwise seen from above, 0 ahead. */
    public double getAngle() {
        return angle / ANGLE_UNITS;
    }

    /** Distance, millimetres; 0 for none. */
    public double getDistance() {
        return distance / DISTANCE_UNITS;
    }
}
