// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

import java.util.Arrays;

/**
 * A message in either direction: a command with channel and data, for example {@code 91 04 00} (digital port 1), or a
 * sysex with identifier and data, {@code F0 79 F7}. Immutable.
 */
public final class FirmataMessage {
    /** Analog value of a channel; towards the board, of a pin. */
    public static final int ANALOG = 0xE0;
    /** Levels of eight pins. */
    public static final int DIGITAL = 0x90;
    /** Switches the report of an analog channel. */
    public static final int REPORT_ANALOG = 0xC0;
    /** Switches the report of a port of eight pins. */
    public static final int REPORT_DIGITAL = 0xD0;
    /** Mode of a pin. */
    public static final int PIN_MODE = 0xF4;
    /** Level of a pin. */
    public static final int PIN_VALUE = 0xF5;
    /** Protocol version, or the query for it. */
    public static final int VERSION = 0xF9;
    /** Resets the board's state. */
    public static final int RESET = 0xFF;
    /** First byte of a sysex. */
    public static final int START_SYSEX = 0xF0;
    /** Last byte of a sysex. */
    public static final int END_SYSEX = 0xF7;
    /** First command without a channel; lower ones have a channel in their low half. */
    static final int FIRST_WITHOUT_CHANNEL = 0xF0;
    private static final int LOW_HALF = 0x0F;
    private static final int SEVEN_BITS = 0x7F;
    private static final int BITS = 7;

    private final int command;
    private final int id;
    private final byte[] data;

    private FirmataMessage(int command, int id, byte[] data) {
        this.command = command;
        this.id = id;
        this.data = data;
    }

    /**
     * Creates a command with its data.
     *
     * @param command with the channel in its low half, if it has one
     * @param data 0 to 127 each
     */
    public static FirmataMessage of(int command, int... data) {
        return new FirmataMessage(command, 0, sevenBits(data));
    }

    /**
     * Creates a sysex.
     *
     * @param id of the feature
     * @param data 0 to 127 each
     */
    public static FirmataMessage sysex(int id, int... data) {
        return new FirmataMessage(START_SYSEX, id, sevenBits(data));
    }

    /** Creates a message with a 14-bit number for a channel, port or pin: {@code E3 2A 03}. */
    public static FirmataMessage number(int command, int channel, int value) {
        return of(command | channel, value & SEVEN_BITS, value >> BITS & SEVEN_BITS);
    }

    /**
     * Creates a text message; each character is two bytes.
     *
     * @param before data between the identifier and the text
     */
    public static FirmataMessage text(int id, int[] before, String text) {
        int[] data = Arrays.copyOf(before, before.length + 2 * text.length());
        for (int i = 0; i < text.length(); i++) {
            data[before.length + 2 * i] = text.charAt(i) & SEVEN_BITS;
            data[before.length + 2 * i + 1] = text.charAt(i) >> BITS & 1;
        }
        return sysex(id, data);
    }

    private static byte[] sevenBits(int... data) {
        byte[] bytes = new byte[data.length];
        for (int i = 0; i < data.length; i++) {
            bytes[i] = (byte) (data[i] & SEVEN_BITS);
        }
        return bytes;
    }

    public boolean isSysex() {
        return command == START_SYSEX;
    }

    /** The command without its channel; {@link #START_SYSEX} for a sysex. */
    public int getCommand() {
        return command < FIRST_WITHOUT_CHANNEL ? command & ~LOW_HALF : command;
    }

    /** Channel, port or pin in the command's low half; 0 if it has none. */
    public int getChannel() {
        return command < FIRST_WITHOUT_CHANNEL ? command & LOW_HALF : 0;
    }

    /** Identifier of a sysex; 0 for other messages. */
    public int getId() {
        return id;
    }

    /** Number of data bytes. */
    public int size() {
        return data.length;
    }

    /** Returns a data byte, 0 to 127; 0 beyond the end. */
    public int get(int index) {
        return index < data.length ? data[index] : 0;
    }

    /** Returns two data bytes as a 14-bit number. */
    public int getNumber(int index) {
        return get(index) | get(index + 1) << BITS;
    }

    /** Returns the text from a data byte on. */
    public String getText(int from) {
        StringBuilder text = new StringBuilder();
        for (int i = from; i + 1 < data.length; i += 2) {
            text.append((char) getNumber(i));
        }
        return text.toString();
    }

    /** Returns the bytes on the line. */
    public byte[] toBytes() {
        if (!isSysex()) {
            byte[] bytes = new byte[1 + data.length];
            bytes[0] = (byte) command;
            System.arraycopy(data, 0, bytes, 1, data.length);
            return bytes;
        }
        byte[] bytes = new byte[2 + data.length + 1];
        bytes[0] = (byte) START_SYSEX;
        bytes[1] = (byte) id;
        System.arraycopy(data, 0, bytes, 2, data.length);
        bytes[bytes.length - 1] = (byte) END_SYSEX;
        return bytes;
    }
}
