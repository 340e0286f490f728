package org.SEAR.devices.lms;

/**
 * The 34 bytes of telegrams 77h, F4h and F7h (SICK telegram listing, table 7-122). Immutable.
 */
public final class Configuration {
    /** Number of bytes. */
    public static final int SIZE = 34;
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

    private final byte[] bytes;

    private Configuration(byte[] bytes) {
        this.bytes = bytes;
    }

    /** A device as delivered: millimetres, mode 0 (8 m). */
    public static Configuration ofFactory() {
        byte[] bytes = new byte[SIZE];
        bytes[STOP_THRESHOLD] = SENSITIVITY_DEFAULT;
        bytes[UNIT] = UNIT_MM;
        bytes[MULTIPLE_EVALUATION] = 2;
        bytes[RESTART] = 2;
        bytes[DAZZLE_EVALUATION] = 2;
        return new Configuration(bytes);
    }

    /** What a 77h request asks for; null if an LMS200 can't do it (unknown mode or unit, wrong length). */
    public static Configuration of(Telegram request) {
        if (request.size() != SIZE + 1) {
            return null;
        }
        byte[] bytes = new byte[SIZE];
        for (int i = 0; i < SIZE; i++) {
            bytes[i] = (byte) request.at(i + 1);
        }
        boolean legal = MeasuringMode.of(bytes[MEASURING_MODE]) != null && (bytes[UNIT] == UNIT_CM || bytes[UNIT] == UNIT_MM);
        return legal ? new Configuration(bytes) : null;
    }

    /** How distances are coded. */
    public MeasuringMode getMode() {
        return MeasuringMode.of(bytes[MEASURING_MODE]);
    }

    /** 0 = centimetres, 1 = millimetres. */
    public int getUnit() {
        return bytes[UNIT];
    }

    /** Units in a metre. */
    public int getUnitsPerMetre() {
        return bytes[UNIT] == UNIT_MM ? 1000 : 100;
    }

    /** Whether each scan ends with scan index and telegram index. */
    public boolean isSendingIndices() {
        return (bytes[AVAILABILITY] & SEND_INDICES) != 0;
    }

    /** Appends the 34 bytes. */
    void writeTo(Payload payload) {
        payload.bytes(bytes);
    }
}
