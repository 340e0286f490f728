// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

import java.util.Locale;

/**
 * Identity of a device in 20 bytes: model, firmware minor and major version, hardware, 16 of serial number. Immutable.
 */
public final class Info {
    /** Size, bytes. */
    public static final int SIZE = 20;
    /** Model byte of the A1M8. */
    public static final int A1M8 = 0x18;
    private static final int SERIAL_AT = 4;

    private final byte[] bytes;

    /**
     * @param model byte
     * @param serial 16 bytes
     */
    public Info(int model, int firmwareMajor, int firmwareMinor, int hardware, byte[] serial) {
        bytes = new byte[SIZE];
        bytes[0] = (byte) model;
        bytes[1] = (byte) firmwareMinor;
        bytes[2] = (byte) firmwareMajor;
        bytes[3] = (byte) hardware;
        System.arraycopy(serial, 0, bytes, SERIAL_AT, SIZE - SERIAL_AT);
    }

    /** @param bytes 20 */
    public Info(byte[] bytes) {
        this.bytes = bytes.clone();
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        return bytes.clone();
    }

    public int getModel() {
        return bytes[0] & 0xFF;
    }

    /** Returns the text for users: {@code model 24, firmware 1.20, hardware 0}. */
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "model %d, firmware %d.%d, hardware %d", getModel(), bytes[2] & 0xFF,
            bytes[1] & 0xFF, bytes[3] & 0xFF);
    }
}
