package org.SEAR.devices.lms;

/**
 * A telegram of the LMS2xx: {@code 02 | address | length W | command | data | crc W}; words have their low byte first, the length counts command and
 * data. Example, a request for one scan: {@code 02 00 02 00 30 01 31 18}. Immutable but for the payload, which is not to be changed.
 * Source: SICK telegram listing 8007954, chapters 5, 6 and 9.
 */
public final class Telegram {
    /** First byte of each telegram. */
    public static final int STX = 0x02;
    /** Bare byte: request received. */
    public static final int ACK = 0x06;
    /** Bare byte: request not received whole. */
    public static final int NAK = 0x15;
    /** Bytes before the command. */
    public static final int HEADER_SIZE = 4;
    /** Bytes beside command and data. */
    public static final int FRAME_SIZE = HEADER_SIZE + 2;
    /** Longest command and data that a telegram of the listing has: 401 values with indices are 808; rounded up. */
    public static final int MAX_PAYLOAD = 1024;
    private static final int GENERATOR = 0x8005;

    private final int address;
    private final byte[] payload;

    /** @param address 0 to 255 @param payload command, data and, in replies, the status byte */
    public Telegram(int address, byte[] payload) {
        this.address = address;
        this.payload = payload;
    }

    /** Address byte; replies have bit 7 set. */
    public int getAddress() {
        return address;
    }

    /** The command byte, 0 to 255. */
    public int getCommand() {
        return payload[0] & 0xFF;
    }

    /** Number of bytes of command and data. */
    public int size() {
        return payload.length;
    }

    /** Byte of the payload, 0 to 255. @param index 0 is the command */
    public int at(int index) {
        return payload[index] & 0xFF;
    }

    /** Word of the payload, 0 to 65535. @param index of its low byte */
    public int wordAt(int index) {
        return at(index) | at(index + 1) << 8;
    }

    /** The telegram as it goes over the line. */
    public byte[] toBytes() {
        byte[] frame = new byte[payload.length + FRAME_SIZE];
        frame[0] = STX;
        frame[1] = (byte) address;
        frame[2] = (byte) payload.length;
        frame[3] = (byte) (payload.length >> 8);
        System.arraycopy(payload, 0, frame, HEADER_SIZE, payload.length);
        int crc = crc(frame, 0, frame.length - 2);
        frame[frame.length - 2] = (byte) crc;
        frame[frame.length - 1] = (byte) (crc >> 8);
        return frame;
    }

    /** SICK's checksum of {@code size} bytes: one shift a byte, generator 8005h, start 0. Example: {@code 02 00 01 00 31} gives 1215h. */
    public static int crc(byte[] bytes, int from, int size) {
        int crc = 0;
        int previous = 0;
        for (int i = from; i < from + size; i++) {
            int value = bytes[i] & 0xFF;
            crc = (crc & 0x8000) == 0 ? crc << 1 : (crc << 1 & 0xFFFF) ^ GENERATOR;
            crc ^= previous << 8 | value;
            previous = value;
        }
        return crc;
    }
}
