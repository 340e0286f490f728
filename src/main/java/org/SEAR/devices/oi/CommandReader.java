// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

/**
 * Assembles bytes to commands; an incomplete command waits for its argument bytes. Holds at most one command. One
 * thread.
 */
final class CommandReader {
    /** Receives complete commands. */
    interface Listener {
        /** @param arguments bytes 0 to 255; valid only during the call */
        void onCommand(Opcode opcode, int[] arguments, int count, double time);

        void onUnknown(int code);
    }

    /** Length of a song of 255 notes, the longest possible argument list. */
    private static final int MAX_ARGUMENTS = 2 + 2 * 255;

    private final OiModel model;
    private final Listener listener;
    private final int[] arguments = new int[MAX_ARGUMENTS];
    private Opcode opcode;
    private int count;

    CommandReader(OiModel model, Listener listener) {
        this.model = model;
        this.listener = listener;
    }

    void accept(int value, double time) {
        if (opcode == null) {
            opcode = Opcode.of(value, model);
            count = 0;
            if (opcode == null) {
                listener.onUnknown(value);
                return;
            }
        } else {
            arguments[count++] = value;
        }
        if (opcode.argumentCount(arguments, count) == count) {
            Opcode whole = opcode;
            opcode = null;
            listener.onCommand(whole, arguments, count, time);
        }
    }

    void clear() {
        opcode = null;
    }
}
