// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.lms;

import java.util.Arrays;

/** The 34 bytes of telegrams 77h, F4h and F7h (SICK telegram listing, table 7-122). Immutable. */
public final class Configuration {
    /** Number of bytes. */
    public static final int SIZE = 34;
    /** Number of bytes that drivers for the older LMS2xx write: all except the last word. */
    public static final int OLD_SIZE = 32;
    private static final int STOP_THRESHOLD = 2;
    private static final int AVAILABILITY = 4;
    private static final int MEASURING_MODE = 5;
    private static final int UNIT = 6;
    private static final int MULTIPLE_EVALUATION = 9;
    private static final int RESTART = 10;
    private static final int DAZZLE_EVALUATION = 32;
    private static final int SENSITIVITY_DEFAULT = 0x70;
    private static final int SEND_INDICES = 2;
    private static final int UNIT_CM = 0;
    private static final int UNIT_MM = 1;
    private static final int MM_PER_METRE = 1000;
    private static final int CM_PER_METRE = 100;

    private final byte[] bytes;

    private Configuration(byte[] bytes) {
        this.bytes = bytes;
    }

    /** Factory configuration of an indoor device: millimetres, mode 0 (8 m). */
    public static Configuration ofFactory() {
        byte[] bytes = new byte[SIZE];
        bytes[STOP_THRESHOLD] = SENSITIVITY_DEFAULT;
        bytes[UNIT] = UNIT_MM;
        bytes[MULTIPLE_EVALUATION] = 2;
        bytes[RESTART] = 2;
        bytes[DAZZLE_EVALUATION] = 2;
        return new Configuration(bytes);
    }

    /**
     * Reads the configuration of a telegram, legal or not.
     *
     * @param from index of its first byte in the payload
     * @throws IllegalArgumentException if the telegram is too short
     */
    public static Configuration of(Telegram telegram, int from) {
        if (telegram.size() < from + SIZE) {
            throw new IllegalArgumentException("configuration has only " + (telegram.size() - from) + " bytes");
        }
        return new Configuration(telegram.copy(from, from + SIZE));
    }

    /**
     * Returns this configuration changed by a 77h request. The request has all 34 bytes or, from drivers for the older
     * LMS2xx, the first 32; missing bytes stay. Example of 32, millimetres:
     * {@code 02 00 21 00 77 00 00 00 00 00 00 01 00 00 02 02 + 21 x 00 + FC 7E}.
     *
     * @return null if the request has another length
     */
    public Configuration with(Telegram request) {
        int carried = request.size() - 1;
        if (carried != SIZE && carried != OLD_SIZE) {
            return null;
        }
        byte[] changed = bytes.clone();
        System.arraycopy(request.copy(1, request.size()), 0, changed, 0, carried);
        return new Configuration(changed);
    }

    /** Whether an LMS200 supports the measuring mode and the unit. */
    public boolean isLegal() {
        return getMode() != null && (bytes[UNIT] == UNIT_CM || bytes[UNIT] == UNIT_MM);
    }

    /** Coding of distances; null for a mode that the listing does not contain. */
    public MeasuringMode getMode() {
        return MeasuringMode.of(bytes[MEASURING_MODE]);
    }

    /** 0 = centimetres, 1 = millimetres. */
    public int getUnit() {
        return bytes[UNIT];
    }

    /** Whether distances are in millimetres. */
    public boolean isMillimetres() {
        return bytes[UNIT] == UNIT_MM;
    }

    /** Units per metre. */
    public int getUnitsPerMetre() {
        return isMillimetres() ? MM_PER_METRE : CM_PER_METRE;
    }

    /** Whether each scan ends with scan index and telegram index. */
    public boolean isSendingIndices() {
        return (bytes[AVAILABILITY] & SEND_INDICES) != 0;
    }

    /** Returns the same configuration with another unit. */
    public Configuration withMillimetres(boolean millimetres) {
        byte[] changed = bytes.clone();
        changed[UNIT] = (byte) (millimetres ? UNIT_MM : UNIT_CM);
        return new Configuration(changed);
    }

    /** Returns a copy of the 34 bytes. */
    public byte[] toBytes() {
        return Arrays.copyOf(bytes, SIZE);
    }
}
