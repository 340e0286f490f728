package org.myrobotlab.service.lidar;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The telegrams to an LMS2xx, and the codes of its answers (SICK telegram listing 8007954, chapter 7). Multi-byte values are little-endian.
 */
final class LmsTelegram {
    static final int MODE = 0x20;
    static final int SCAN = 0x30;
    static final int STATUS = 0x31;
    static final int TYPE = 0x3A;
    static final int VARIANT = 0x3B;
    static final int GET_CONFIGURATION = 0x74;
    static final int SET_CONFIGURATION = 0x77;

    static final int MODE_REPLY = 0xA0;
    static final int SCAN_REPLY = 0xB0;
    static final int STATUS_REPLY = 0xB1;
    static final int TYPE_REPLY = 0xBA;
    static final int VARIANT_REPLY = 0xBB;
    static final int CONFIGURATION_REPLY = 0xF4;
    static final int SET_CONFIGURATION_REPLY = 0xF7;
    static final int NOT_PERMITTED = 0x92;
    static final int POWER_ON = 0x90;

    static final int STREAM_ALL = 0x24;
    static final int ON_REQUEST = 0x25;

    /** Bytes of the configuration block in F4h, F7h and 77h. */
    static final int CONFIGURATION_LENGTH = 34;
    /** Where the block has the measuring mode. */
    static final int CONFIGURATION_MODE = 5;
    /** Where the block has the unit: 0 centimetres, 1 millimetres. */
    static final int CONFIGURATION_UNIT = 6;

    /** Bytes of a B1h telegram's body (telegram listing, table 7-33). */
    static final int STATUS_LENGTH = 154;
    /** Where it has the operating mode. */
    static final int STATUS_MODE = 8;
    /** Where it has the angle of the fan, degrees. */
    static final int STATUS_SPREAD = 107;
    /** Where it has the angle between beams, hundredths of a degree. */
    static final int STATUS_RESOLUTION = 109;

    private static final int FIRST_MEASURING_MODE = 0x20;
    private static final int LAST_MEASURING_MODE = 0x2F;
    private static final int POLYNOMIAL = 0x8005;
    private static final String PASSWORD = "SICK_LMS";

    private LmsTelegram() {
    }

    /** A whole telegram around a command and its data: {@code 30 01} becomes {@code 02 00 02 00 30 01 31 18}. */
    static byte[] frame(byte[] body) {
        byte[] telegram = new byte[LmsFramer.HEADER + body.length + LmsFramer.CRC];
        telegram[0] = LmsFramer.STX;
        telegram[2] = (byte) body.length;
        telegram[3] = (byte) (body.length >> 8);
        System.arraycopy(body, 0, telegram, LmsFramer.HEADER, body.length);
        int end = LmsFramer.HEADER + body.length;
        int crc = crc(telegram, end);
        telegram[end] = (byte) crc;
        telegram[end + 1] = (byte) (crc >> 8);
        return telegram;
    }

    /** SICK's check sum over the first bytes: one shift a byte (telegram listing, chapter 9). */
    static int crc(byte[] bytes, int length) {
        int crc = 0;
        int previous = 0;
        for (int i = 0; i < length; i++) {
            int b = bytes[i] & 0xFF;
            boolean top = (crc & 0x8000) != 0;
            crc = crc << 1 & 0xFFFF;
            if (top) {
                crc ^= POLYNOMIAL;
            }
            crc ^= previous << 8 | b;
            previous = b;
        }
        return crc;
    }

    static byte[] of(int... values) {
        byte[] body = new byte[values.length];
        for (int i = 0; i < values.length; i++) {
            body[i] = (byte) values[i];
        }
        return body;
    }

    /** {@code 3B angle resolution}: degrees, hundredths of a degree. */
    static byte[] variant(int spread, int hundredths) {
        return of(VARIANT, spread, spread >> 8, hundredths, hundredths >> 8);
    }

    /** {@code 20 00 "SICK_LMS"}: permits changes of the configuration. */
    static byte[] installationMode() {
        byte[] password = PASSWORD.getBytes(StandardCharsets.US_ASCII);
        byte[] body = Arrays.copyOf(of(MODE, 0), 2 + password.length);
        System.arraycopy(password, 0, body, 2, password.length);
        return body;
    }

    /** {@code 77 configuration}. */
    static byte[] setConfiguration(byte[] configuration) {
        byte[] body = new byte[1 + configuration.length];
        body[0] = SET_CONFIGURATION;
        System.arraycopy(configuration, 0, body, 1, configuration.length);
        return body;
    }

    /** Whether a device in that operating mode sends by itself. */
    static boolean isStream(int mode) {
        return mode >= FIRST_MEASURING_MODE && mode <= LAST_MEASURING_MODE && mode != ON_REQUEST;
    }

    static int word(byte[] body, int at) {
        return body[at] & 0xFF | (body[at + 1] & 0xFF) << 8;
    }
}
