package org.SEAR.protocol;

/** What a byte costs on a serial line with 8 data bits, no parity and one stop bit, as all devices of the project have it. */
public final class Uart {
    /** Bits that a byte takes on the line: start, eight of data, stop. */
    public static final double BITS_PER_BYTE = 10;

    private Uart() {
    }

    /**
     * Seconds that so many bytes take.
     *
     * @param baud bits a second, above 0
     */
    public static double seconds(int bytes, double baud) {
        return bytes * BITS_PER_BYTE / baud;
    }

    /**
     * Bytes that fit through the line in a time.
     *
     * @param seconds 0 or more
     * @param baud bits a second, above 0
     */
    public static double bytes(double seconds, double baud) {
        return baud / BITS_PER_BYTE * seconds;
    }
}
