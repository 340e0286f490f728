// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A telegram of the LMS2xx: {@code 02 | address | length W | command | data | crc W}. Words have their low byte first;
 * the length counts command and data. Example, a request for one scan: {@code 02 00 02 00 30 01 31 18}. Immutable; its
 * payload must not be changed. Source: SICK telegram listing 8007954, chapters 5, 6 and 9.
 */
public final class Telegram {
    /** First byte of each telegram. */
    public static final int STX = 0x02;
    /** Bare byte: request received. */
    public static final int ACK = 0x06;
    /** Bare byte: request not received completely. */
    public static final int NAK = 0x15;
    /** Bytes before the command. */
    public static final int HEADER_SIZE = 4;
    /** Bytes of the checksum. */
    public static final int CRC_SIZE = 2;
    /** Bytes besides command and data. */
    public static final int FRAME_SIZE = HEADER_SIZE + CRC_SIZE;
    /** Maximum size of command and data; the listing's largest, 401 values with indices, has 808 bytes. */
    public static final int MAX_PAYLOAD = 1024;
    /** Bit of the address byte that marks a device's telegrams. */
    public static final int FROM_DEVICE = 0x80;
    private static final int BROADCAST = 0;
    private static final int GENERATOR = 0x8005;

    private final int address;
    private final byte[] payload;

    /**
     * Creates a telegram; {@link #toBytes} adds its checksum.
     *
     * @param address 0 to 255
     * @param payload command, data and, in replies, the status byte; at least the command
     */
    public Telegram(int address, byte[] payload) {
        this.address = address;
        this.payload = payload;
    }

    /** Creates a broadcast request, which any device on the line answers. */
    public static Telegram request(LmsPayload payload) {
        return new Telegram(BROADCAST, payload.toBytes());
    }

    /** Address byte; replies have {@link #FROM_DEVICE} set. */
    public int getAddress() {
        return address;
    }

    /** Whether a device sent it. */
    public boolean isFromDevice() {
        return (address & FROM_DEVICE) != 0;
    }

    /** The command byte, 0 to 255. */
    public int getCommand() {
        return payload[0] & 0xFF;
    }

    /** Number of bytes of command and data. */
    public int size() {
        return payload.length;
    }

    /**
     * Returns a byte of the payload, 0 to 255.
     *
     * @param index 0 is the command
     * @throws IndexOutOfBoundsException if the payload is shorter
     */
    public int at(int index) {
        return payload[index] & 0xFF;
    }

    /**
     * Returns a word of the payload, 0 to 65535.
     *
     * @param index of its low byte
     * @throws IndexOutOfBoundsException if the payload is shorter
     */
    public int wordAt(int index) {
        return at(index) | at(index + 1) << 8;
    }

    /** Last byte of the payload: the status byte of a reply. */
    public int last() {
        return at(payload.length - 1);
    }

    /**
     * Returns text within the payload.
     *
     * @param from index of its first byte
     * @param to index after its last byte
     */
    public String text(int from, int to) {
        return to <= from ? "" : new String(payload, from, to - from, StandardCharsets.US_ASCII);
    }

    /** Returns a copy of a part of the payload; zeros beyond its end. */
    public byte[] copy(int from, int to) {
        return Arrays.copyOfRange(payload, from, to);
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        byte[] frame = new byte[payload.length + FRAME_SIZE];
        frame[0] = STX;
        frame[1] = (byte) address;
        frame[2] = (byte) payload.length;
        frame[3] = (byte) (payload.length >> 8);
        System.arraycopy(payload, 0, frame, HEADER_SIZE, payload.length);
        int crc = crc(frame, 0, frame.length - 2);
        frame[frame.length - 2] = (byte) crc;
        frame[frame.length - 1] = (byte) (crc >> 8);
        return frame;
    }

    /**
     * SICK's checksum of {@code size} bytes: one shift per byte, generator 8005h, start 0. Example:
     * {@code 02 00 01 00 31} gives 1215h.
     */
    public static int crc(byte[] bytes, int from, int size) {
        int crc = 0;
        int previous = 0;
        for (int i = from; i < from + size; i++) {
            int value = bytes[i] & 0xFF;
            crc = (crc & 0x8000) == 0 ? crc << 1 : (crc << 1 & 0xFFFF) ^ GENERATOR;
            crc ^= previous << 8 | value;
            previous = value;
        }
        return crc;
    }
}
