package org.SEAR.protocol.rplidar;

/**
 * A request: {@code A5 20}, or with payload its length, its bytes and the exclusive or of all before: {@code A5 82 05 00 00 00 00 00 22}. Immutable.
 */
public final class RplidarRequestPacket {
    /** Begins each request. */
    public static final int START = 0xA5;
    private static final int WITH_PAYLOAD = 0x80;
    private static final int HEAD = 3;

    private final int code;
    private final byte[] payload;

    /** @param payload bytes; empty for requests without */
    public RplidarRequestPacket(int code, byte... payload) {
        this.code = code;
        this.payload = payload.clone();
    }

    /** Whether a payload belongs to a request of that code. */
    public static boolean hasPayload(int code) {
        return (code & WITH_PAYLOAD) != 0;
    }

    /** Which one, see {@link RplidarCommand}. */
    public int getCode() {
        return code;
    }

    /** Bytes of payload. */
    public int size() {
        return payload.length;
    }

    /** A byte of the payload, 0 to 255. */
    public int at(int index) {
        return payload[index] & 0xFF;
    }

    /** As it is sent. */
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
