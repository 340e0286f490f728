// SPDX-License-Identifier: Apache-2.0
package org.SEAR.protocol;

/**
 * Transmission times on a serial line with 8 data bits, no parity and one stop bit, the format of all devices of the
 * project.
 */
public final class Uart {
    /** Bits per byte on the line: start, eight data bits, stop. */
    public static final double BITS_PER_BYTE = 10;

    private Uart() {
    }

    /**
     * Duration of some bytes, seconds.
     *
     * @param baud bits per second, above 0
     */
    public static double seconds(int bytes, double baud) {
        return bytes * BITS_PER_BYTE / baud;
    }

    /**
     * Number of bytes that fit through the line in a time.
     *
     * @param seconds 0 or more
     * @param baud bits per second, above 0
     */
    public static double bytes(double seconds, double baud) {
        return baud / BITS_PER_BYTE * seconds;
    }
}
