package org.SEAR.protocol.rplidar;

/** Whether a device is well, in 3 bytes: state, then a code. Immutable. */
public final class Health {
    /** Bytes. */
    public static final int SIZE = 3;
    /** All is well. */
    public static final int GOOD = 0;
    /** It may fail. */
    public static final int WARNING = 1;
    /** Motor and laser are stopped until RESET. */
    public static final int ERROR = 2;

    private final int state;
    private final int code;

    public Health(int state, int code) {
        this.state = state;
        this.code = code;
    }

    /** @param bytes 3 */
    public Health(byte[] bytes) {
        this(bytes[0] & 0xFF, bytes[1] & 0xFF | (bytes[2] & 0xFF) << 8);
    }

    /** As it is sent. */
    public byte[] toBytes() {
        return new byte[] {(byte) state, (byte) code, (byte) (code >> 8)};
    }

    /** {@link #GOOD}, {@link #WARNING} or {@link #ERROR}. */
    public int getState() {
        return state;
    }

    /** What is the matter. */
    public int getCode() {
        return code;
    }
}
