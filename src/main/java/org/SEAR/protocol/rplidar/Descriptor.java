// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

/**
 * Header of an answer: {@code A5 5A | packet length in 30 bits, then 2 bits, 1 for endless packets | type}. For a scan:
 * {@code A5 5A 05 00 00 40 81}. Immutable.
 */
public final class Descriptor {
    /** Size, bytes. */
    public static final int SIZE = 7;
    private static final int FIRST = 0xA5;
    private static final int SECOND = 0x5A;
    private static final int MULTIPLE = 0x40;
    private static final int BYTES_OF_LENGTH = 4;

    private final int length;
    private final boolean multiple;
    private final int type;

    /**
     * @param length of a packet, bytes, below 2^24
     * @param multiple whether packets continue until another request
     * @param type of the data
     */
    public Descriptor(int length, boolean multiple, int type) {
        this.length = length;
        this.multiple = multiple;
        this.type = type;
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        byte[] bytes = new byte[SIZE];
        bytes[0] = (byte) FIRST;
        bytes[1] = (byte) SECOND;
        for (int i = 0; i < BYTES_OF_LENGTH - 1; i++) {
            bytes[2 + i] = (byte) (length >> 8 * i);
        }
        bytes[BYTES_OF_LENGTH + 1] = (byte) (multiple ? MULTIPLE : 0);
        bytes[SIZE - 1] = (byte) type;
        return bytes;
    }

    /** Length of a packet, bytes. */
    public int getLength() {
        return length;
    }

    /** Whether packets continue until another request. */
    public boolean isMultiple() {
        return multiple;
    }
}
