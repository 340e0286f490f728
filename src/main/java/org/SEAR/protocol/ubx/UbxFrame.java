// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.ubx;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/**
 * A message of a u-blox receiver with its frame:
 * {@code B5 62, class, id, length (2 bytes), payload, checksum (2 bytes)}. Numbers have their low byte first.
 * Immutable.
 */
public final class UbxFrame {
    /** The first byte of each frame. */
    public static final int SYNC_1 = 0xB5;
    /** The second byte of each frame. */
    public static final int SYNC_2 = 0x62;
    /** Bytes before the payload. */
    public static final int HEADER = 6;
    /** Bytes of a frame without the payload. */
    public static final int OVERHEAD = 8;
    /** Maximum size of a payload, bytes; longer ones are noise. */
    public static final int MOST = 1024;
    /** Baud rates, bits per second. */
    public static final List<Integer> BAUDS =
        Collections.unmodifiableList(Arrays.asList(4800, 9600, 19200, 38400, 57600, 115200, 230400, 460800, 921600));
    private static final int BYTE = 0xFF;
    private static final int BITS = 8;

    private final int group;
    private final int id;
    private final byte[] payload;

    /**
     * @param group class of the message, 0 to 255
     * @param id number in the class, 0 to 255
     */
    public UbxFrame(int group, int id, byte... payload) {
        this.group = group;
        this.id = id;
        this.payload = payload.clone();
    }

    /** Creates a frame of a known message. */
    public UbxFrame(UbxMessage message, byte... payload) {
        this(message.getGroup(), message.getId(), payload);
    }

    /** Allocates a little-endian buffer for a payload. */
    public static ByteBuffer room(int size) {
        return ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Class of the message. */
    public int getGroup() {
        return group;
    }

    /** Number of the message within its class. */
    public int getId() {
        return id;
    }

    /** Size of the payload, bytes. */
    public int getLength() {
        return payload.length;
    }

    /** Its message; null if unknown. */
    public UbxMessage getMessage() {
        return UbxMessage.of(group, id);
    }

    /** The payload as a read-only, little-endian buffer. */
    public ByteBuffer read() {
        return ByteBuffer.wrap(payload).asReadOnlyBuffer().order(ByteOrder.LITTLE_ENDIAN);
    }

    /** Returns a copy of the payload. */
    public byte[] getPayload() {
        return payload.clone();
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        ByteBuffer bytes = room(OVERHEAD + payload.length);
        bytes.put((byte) SYNC_1).put((byte) SYNC_2).put((byte) group).put((byte) id).putShort((short) payload.length)
            .put(payload);
        return bytes.putShort((short) checksum(bytes.array(), 2, HEADER - 2 + payload.length)).array();
    }

    /** Two sums of 8 bits: of the bytes (low byte of the result), and of the first sum after each byte (high byte). */
    static int checksum(byte[] bytes, int from, int count) {
        int a = 0;
        int b = 0;
        for (int i = from; i < from + count; i++) {
            a = a + bytes[i] & BYTE;
            b = b + a & BYTE;
        }
        return b << BITS | a;
    }
}
