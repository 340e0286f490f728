// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol.firmata;

/** Messages of the encoder feature: up to {@link #ENCODERS} encoders, positions of 28 bits and a sign. */
public final class EncoderMessage {
    /** Maximum number of encoders. */
    public static final int ENCODERS = 5;
    /** Attach an encoder; its pins follow. This and the next constants are the first data byte of a request. */
    public static final int ATTACH = 0;
    /** Report one encoder. */
    public static final int REPORT = 1;
    /** Report all encoders. */
    public static final int REPORT_ALL = 2;
    /** Set the position of an encoder to 0. */
    public static final int RESET = 3;
    /** Report all encoders at each sample, or stop that. */
    public static final int AUTOMATIC = 4;
    /** Detach an encoder. */
    public static final int DETACH = 5;
    private static final int SIZE = 5;
    private static final int NEGATIVE = 0x40;
    private static final int BITS = 7;

    private EncoderMessage() {
    }

    /**
     * Creates a report of positions, {@code F0 61 (number, position)... F7}.
     *
     * @param numbers of the encoders
     * @param positions in the order of the numbers
     */
    public static FirmataMessage positions(int[] numbers, long[] positions) {
        int[] data = new int[SIZE * numbers.length];
        for (int i = 0; i < numbers.length; i++) {
            long size = Math.abs(positions[i]);
            data[SIZE * i] = numbers[i] | (positions[i] < 0 ? NEGATIVE : 0);
            for (int k = 0; k < SIZE - 1; k++) {
                data[SIZE * i + 1 + k] = (int) (size >> BITS * k);
            }
        }
        return FirmataMessage.sysex(Feature.ENCODER, data);
    }
}
