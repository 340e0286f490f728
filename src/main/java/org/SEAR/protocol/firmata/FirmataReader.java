// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

import java.util.Arrays;
import java.util.function.Consumer;

/**
 * Finds messages in a stream of bytes. Skips data without a command, unknown commands, a sysex with more than
 * {@code mostData} bytes, and a sysex interrupted by a command. One thread at a time.
 */
public final class FirmataReader {
    /** Maximum sysex data of an Arduino's buffer, bytes. */
    public static final int BOARD = 64;
    /** Maximum sysex data for a host, bytes; enough for any board. */
    public static final int HOST = 4096;
    private static final int FIRST_COMMAND = 0x80;
    private static final int LOW_HALF = 0x0F;

    private final Consumer<FirmataMessage> messages;
    private final int mostData;
    private final int[] data;
    private int command;
    private int expected;
    private int count;

    /** @param mostData maximum data of a sysex, {@link #BOARD} or {@link #HOST} */
    public FirmataReader(int mostData, Consumer<FirmataMessage> messages) {
        this.mostData = mostData;
        this.messages = messages;
        this.data = new int[mostData + 2];
    }

    /** @param value 0 to 255 */
    public void accept(int value) {
        if (value >= FIRST_COMMAND) {
            begin(value);
        } else if (command == FirmataMessage.START_SYSEX) {
            if (count <= mostData + 1) {
                data[count++] = value;
            }
        } else if (command != 0) {
            data[count++] = value;
            if (count == expected) {
                emit();
            }
        }
    }

    private void begin(int value) {
        if (value == FirmataMessage.END_SYSEX && command == FirmataMessage.START_SYSEX) {
            command = 0;
            if (count > 0 && count <= mostData + 1) {
                messages.accept(FirmataMessage.sysex(data[0], Arrays.copyOfRange(data, 1, count)));
            }
            return;
        }
        count = 0;
        expected = length(value);
        command = expected < 0 ? 0 : value;
        if (expected == 0 && value != FirmataMessage.START_SYSEX) {
            emit();
        }
    }

    private void emit() {
        int[] own = Arrays.copyOf(data, count);
        int done = command;
        command = 0;
        messages.accept(FirmataMessage.of(done, own));
    }

    /**
     * Number of data bytes after a command.
     *
     * @return -1 for an unknown command
     */
    private int length(int value) {
        switch (value < FirmataMessage.FIRST_WITHOUT_CHANNEL ? value & ~LOW_HALF : value) {
            case FirmataMessage.ANALOG:
            case FirmataMessage.DIGITAL:
            case FirmataMessage.PIN_MODE:
            case FirmataMessage.PIN_VALUE:
                return 2;
            case FirmataMessage.VERSION:
                return mostData == HOST ? 2 : 0;
            case FirmataMessage.REPORT_ANALOG:
            case FirmataMessage.REPORT_DIGITAL:
                return 1;
            case FirmataMessage.START_SYSEX:
            case FirmataMessage.RESET:
                return 0;
            default:
                return -1;
        }
    }

    /** Discards an incomplete message. */
    public void clear() {
        command = 0;
        count = 0;
    }
}
