// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

/** Health of a device in 3 bytes: state, then an error code. Immutable. */
public final class Health {
    /** Size, bytes. */
    public static final int SIZE = 3;
    /** No error. */
    public static final int GOOD = 0;
    /** The device may fail. */
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

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        return new byte[] {(byte) state, (byte) code, (byte) (code >> 8)};
    }

    /** {@link #GOOD}, {@link #WARNING} or {@link #ERROR}. */
    public int getState() {
        return state;
    }

    /** Error code. */
    public int getCode() {
        return code;
    }
}
