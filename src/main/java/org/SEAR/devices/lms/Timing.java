package org.SEAR.devices.lms;

import org.SEAR.protocol.Uart;

/** How long an LMS200 takes. Seconds; sources: SICK telegram listing, chapter 4 and table 10-17, and drivers' experience within its limits. */
final class Timing {
    /** End of a request to ACK or NAK; the listing allows 60 ms. */
    static final double ACKNOWLEDGE = 0.005;
    /** ACK to the answer of a simple request; the listing allows 60 ms. */
    static final double ANSWER = 0.010;
    /** ACK to the answer of a change of mode, baud or variant; the listing allows 3 s. */
    static final double CHANGE = 0.1;
    /** ACK to the answer of a written configuration; real devices take up to 7 s, but MRPT's driver waits 0.6 s only. */
    static final double WRITE = 0.2;
    /** ACK to the reset. */
    static final double RESET = 0.010;
    /** Reset to the power-on telegram; the listing allows 60 s. */
    static final double BOOT = 5;
    /** Longest pause between two bytes of a request. */
    static final double HOST_GAP = 0.006;
    /** Guards a ceiling against the last bit of a quotient. */
    private static final double SLACK = 1e-9;

    private Timing() {
    }

    /**
     * The end of the first scan that ends at or after {@code time}.
     *
     * @param scanTime seconds
     */
    static double scanEnd(double time, double scanTime) {
        return Math.ceil(time / scanTime - SLACK) * scanTime;
    }

    /** Time from one telegram of a stream to the next: the least multiple of {@code scanTime} in which it fits through the line. */
    static double streamPeriod(int bytes, int baud, double scanTime) {
        return Math.max(1, Math.ceil(Uart.seconds(bytes, baud) / scanTime - SLACK)) * scanTime;
    }
}
