// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.rplidar;

import java.util.Arrays;

/**
 * Finds the answer to a request in a device's output: its descriptor, then its packets. Skips bytes before the
 * descriptor, such as the rest of a scan, and invalid packets within a scan. One thread at a time.
 */
public final class AnswerReader {
    /** Receives descriptors and packets. */
    public interface Listener {
        /** The descriptor of an answer. */
        void onDescriptor(RplidarCommand command);

        /** @param bytes a complete packet */
        void onPacket(RplidarCommand command, byte[] bytes);
    }

    private final Listener listener;
    private RplidarCommand command;
    private byte[] wanted = new byte[0];
    private byte[] window = new byte[0];
    private int filled;
    private boolean described;

    public AnswerReader(Listener listener) {
        this.listener = listener;
    }

    /** Starts the search for the answer to a request; earlier answers are dropped. */
    public void expect(RplidarCommand request) {
        command = request.getDescriptor() == null ? null : request;
        described = false;
        filled = 0;
        if (command != null) {
            wanted = request.getDescriptor().toBytes();
            window = new byte[wanted.length];
        }
    }

    /** Takes bytes from the device. */
    public void accept(byte[] bytes) {
        for (int i = 0; i < bytes.length && command != null; i++) {
            window[filled++] = bytes[i];
            if (filled == window.length) {
                take();
            }
        }
    }

    private void take() {
        if (!described) {
            if (Arrays.equals(window, wanted)) {
                described = true;
                filled = 0;
                window = new byte[command.getDescriptor().getLength()];
                listener.onDescriptor(command);
            } else {
                shift();
            }
        } else if (!makesSense()) {
            shift();
        } else {
            RplidarCommand answered = command;
            filled = 0;
            if (!answered.getDescriptor().isMultiple()) {
                command = null;
            }
            listener.onPacket(answered, window.clone());
        }
    }

    private boolean makesSense() {
        switch (command) {
            case SCAN:
            case FORCE_SCAN:
                return Node.of(window) != null;
            case EXPRESS_SCAN:
                return Capsule.of(window) != null;
            default:
                return true;
        }
    }

    private void shift() {
        System.arraycopy(window, 1, window, 0, window.length - 1);
        filled--;
    }
}
