// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.Locale;

/**
 * Detects a host program at the wrong port, or one that missed a change of baud rate, and words a warning. Warns once
 * per program. Simulation thread.
 */
final class BaudMismatch {
    /** Number of bytes from which on they are not just noise. */
    private static final int ENOUGH = 10;
    /** Simulated seconds since the first byte; by then the first command of any program is complete. */
    private static final double TIMEOUT = 5;

    private final int[] first = new int[2];
    private boolean understood;
    private boolean reported;
    private int strange;
    private double since;
    private int garbled;
    private int garbledAt;
    private boolean reportedSpeed;

    /** Starts again for a new program. */
    void begin() {
        understood = false;
        reported = false;
        strange = 0;
        garbled = 0;
        reportedSpeed = false;
    }

    /** Counts a byte that the device receives at its own baud rate. */
    void heard(int value, double time) {
        if (!understood) {
            if (strange == 0) {
                since = time;
            }
            if (strange < first.length) {
                first[strange] = value;
            }
            strange++;
        }
    }

    /** Counts a byte that came at another baud rate than the device's. */
    void garbled(int speed) {
        garbled = garbledAt == speed ? garbled + 1 : 1;
        garbledAt = speed;
    }

    /** Notes a command that the device understood: port and baud rate of the program are right. */
    void understood() {
        understood = true;
        strange = 0;
        garbled = 0;
        reportedSpeed = false;
    }

    /**
     * Returns a warning that is due now.
     *
     * @param device with its article
     * @param speed baud rate of the device
     * @return null for none
     */
    String complaint(String device, int speed, double time) {
        if (!reported && strange >= ENOUGH && time > since + TIMEOUT) {
            reported = true;
            return String.format(Locale.ROOT, "%d bytes came that %s does not understand (first: %02X %02X): is it "
                + "the right port?", strange, device, first[0], first[1]);
        }
        if (!reportedSpeed && understood && garbled >= ENOUGH) {
            reportedSpeed = true;
            return String.format(Locale.ROOT, "%d bytes came at %d baud, but %s is at %d baud now: change the "
                + "program's rate, too", garbled, garbledAt, device, speed);
        }
        return null;
    }
}
