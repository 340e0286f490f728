package org.SEAR.devices.oi;

/** A 16 bit count that is cleared by reading (packets 19, 20): holds at 32767 and -32768. What is less than a unit stays for the next reading. */
final class SaturatingCounter {
    private double base;

    /**
     * The units since the last reading.
     *
     * @param total since start
     */
    int read(double total) {
        long units = Math.round(total - base);
        if (units > Short.MAX_VALUE || units < Short.MIN_VALUE) {
            base = total;
            return units > 0 ? Short.MAX_VALUE : Short.MIN_VALUE;
        }
        base += units;
        return (int) units;
    }

    /** The units since the last reading, which stay. */
    double peek(double total) {
        return total - base;
    }

    void clear(double total) {
        base = total;
    }
}
