// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import org.SEAR.protocol.Uart;

/**
 * Durations of an LMS200 in seconds. Sources: SICK telegram listing, chapter 4 and table 10-17, and experience of
 * drivers within its limits.
 */
final class Timing {
    /** Request to ACK or NAK; the listing permits 60 ms. */
    static final double ACKNOWLEDGE = 0.005;
    /** ACK to the answer of a simple request; the listing permits 60 ms. */
    static final double ANSWER = 0.010;
    /** ACK to the answer of a change of mode, baud rate or variant; the listing permits 3 s. */
    static final double CHANGE = 0.1;
    /**
     * ACK to the answer of a written configuration. Real devices take up to 7 s, but MRPT's driver waits only 0.6 s.
     */
    static final double WRITE = 0.2;
    /** ACK to the reset. */
    static final double RESET = 0.010;
    /** Reset to the power-on telegram; the listing permits 60 s. */
    static final double BOOT = 5;
    /** Longest pause between two bytes of a request. */
    static final double HOST_GAP = 0.006;
    /** Tolerance for rounding errors before a ceiling. */
    private static final double SLACK = 1e-9;

    private Timing() {
    }

    /**
     * Returns the end of the first scan that ends at or after {@code time}.
     *
     * @param scanTime seconds
     */
    static double scanEnd(double time, double scanTime) {
        return Math.ceil(time / scanTime - SLACK) * scanTime;
    }

    /**
     * Interval of telegrams in a stream, seconds: the smallest multiple of {@code scanTime} in which one fits through
     * the line.
     */
    static double streamPeriod(int bytes, int baud, double scanTime) {
        return Math.max(1, Math.ceil(Uart.seconds(bytes, baud) / scanTime - SLACK)) * scanTime;
    }
}
