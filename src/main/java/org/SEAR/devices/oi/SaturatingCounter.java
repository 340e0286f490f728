// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

/**
 * A 16-bit count that reading clears (packets 19, 20). It saturates at 32767 and -32768. Fractions of a unit stay for
 * the next reading.
 */
final class SaturatingCounter {
    private double base;

    /**
     * Returns the units since the last reading and clears them.
     *
     * @param total units since start
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

    /** Returns the units since the last reading without clearing them. */
    double peek(double total) {
        return total - base;
    }

    void clear(double total) {
        base = total;
    }
}
