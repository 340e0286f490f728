// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

/**
 * A request: {@code A5 20}. With a payload, its length, its bytes and the exclusive or of all bytes before follow:
 * {@code A5 82 05 00 00 00 00 00 22}. Immutable.
 */
public final class RplidarRequestPacket {
    /** First byte of each request. */
    public static final int START = 0xA5;
    private static final int WITH_PAYLOAD = 0x80;
    private static final int HEAD = 3;

    private final int code;
    private final byte[] payload;

    /** @param payload empty for requests without payload */
    public RplidarRequestPacket(int code, byte... payload) {
        this.code = code;
        this.payload = payload.clone();
    }

    /** Whether a request of a code has a payload. */
    public static boolean hasPayload(int code) {
        return (code & WITH_PAYLOAD) != 0;
    }

    /** Code of the request, see {@link RplidarCommand}. */
    public int getCode() {
        return code;
    }

    /** Size of the payload, bytes. */
    public int size() {
        return payload.length;
    }

    /** Returns a byte of the payload, 0 to 255. */
    public int at(int index) {
        return payload[index] & 0xFF;
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        if (!hasPayload(code)) {
            return new byte[] {(byte) START, (byte) code};
        }
        byte[] bytes = new byte[HEAD + payload.length + 1];
        bytes[0] = (byte) START;
        bytes[1] = (byte) code;
        bytes[2] = (byte) payload.length;
        System.arraycopy(payload, 0, bytes, HEAD, payload.length);
        int sum = 0;
        for (byte each : bytes) {
            sum ^= each;
        }
        bytes[bytes.length - 1] = (byte) sum;
        return bytes;
    }
}
