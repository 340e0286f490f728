package org.SEAR.protocol.lms;

import java.util.Arrays;

/**
 * The 34 bytes of telegrams 77h, F4h and F7h (SICK telegram listing, table 7-122). Immutable.
 */
public final class Configuration {
    /** Number of bytes. */
    public static final int SIZE = 34;
    /** Number of bytes that drivers for the older LMS2xx write: all but the last word. */
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

    /** An indoor device as delivered: millimetres, mode 0 (8 m). */
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
     * What a telegram carries, legal or not.
     *
     * @param from where in the payload it begins
     * @throws IllegalArgumentException if the telegram is too short
     */
    public static Configuration of(Telegram telegram, int from) {
        if (telegram.size() < from + SIZE) {
            throw new IllegalArgumentException("configuration of " + (telegram.size() - from) + " bytes");
        }
        return new Configuration(telegram.copy(from, from + SIZE));
    }

    /**
     * What a 77h request makes of this one: it carries all 34 bytes, or, as drivers for the older LMS2xx send it, the first 32; what it does not
     * carry stays as it is. Example of 32, millimetres: {@code 02 00 21 00 77 00 00 00 00 00 00 01 00 00 02 02 + 21 x 00 + FC 7E}.
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

    /** Whether an LMS200 can do it: it knows the measuring mode and the unit. */
    public boolean isLegal() {
        return getMode() != null && (bytes[UNIT] == UNIT_CM || bytes[UNIT] == UNIT_MM);
    }

    /** How distances are coded; null for a mode that the listing doesn't have. */
    public MeasuringMode getMode() {
        return MeasuringMode.of(bytes[MEASURING_MODE]);
    }

    /** 0 = centimetres, 1 = millimetres. */
    public int getUnit() {
        return bytes[UNIT];
    }

    /** Whether distances are told in millimetres. */
    public boolean isMillimetres() {
        return bytes[UNIT] == UNIT_MM;
    }

    /** Units in a metre. */
    public int getUnitsPerMetre() {
        return isMillimetres() ? MM_PER_METRE : CM_PER_METRE;
    }

    /** Whether each scan ends with scan index and telegram index. */
    public boolean isSendingIndices() {
        return (bytes[AVAILABILITY] & SEND_INDICES) != 0;
    }

    /** The same but for its unit. */
    public Configuration withMillimetres(boolean millimetres) {
        byte[] changed = bytes.clone();
        changed[UNIT] = (byte) (millimetres ? UNIT_MM : UNIT_CM);
        return new Configuration(changed);
    }

    /** The 34 bytes, a copy. */
    public byte[] toBytes() {
        return Arrays.copyOf(bytes, SIZE);
    }
}
