package org.SEAR.devices;

import java.util.Locale;

/**
 * Whether a device understands what comes over its line, in words for the user when it doesn't: a program at the wrong port, or one that has not gone
 * along with a change of speed. Told once for each program. Simulation thread.
 */
final class BaudMismatch {
    /** So many bytes are no noise. */
    private static final int ENOUGH = 10;
    /** Simulated seconds from the first byte on; every program's first command is whole by then. */
    private static final double TIMEOUT = 5;

    private final int[] first = new int[2];
    private boolean understood;
    private boolean reported;
    private int strange;
    private double since;
    private int garbled;
    private int garbledAt;
    private boolean reportedSpeed;

    /** A program has come. */
    void begin() {
        understood = false;
        reported = false;
        strange = 0;
        garbled = 0;
        reportedSpeed = false;
    }

    /** A byte has come to a device that takes bytes. */
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

    /** A byte has come at another speed than the device's. */
    void garbled(int speed) {
        garbled = garbledAt == speed ? garbled + 1 : 1;
        garbledAt = speed;
    }

    /** The device has understood something: the program is at the right port, and has the right speed. */
    void understood() {
        understood = true;
        strange = 0;
        garbled = 0;
        reportedSpeed = false;
    }

    /**
     * What to tell the user now.
     *
     * @param device with its article
     * @param speed the device's
     * @return null for nothing
     */
    String complaint(String device, int speed, double time) {
        if (!reported && strange >= ENOUGH && time > since + TIMEOUT) {
            reported = true;
            return String.format(Locale.ROOT, "%d bytes came that %s does not understand (first: %02X %02X): is it the right port?", strange, device,
                first[0], first[1]);
        }
        if (!reportedSpeed && understood && garbled >= ENOUGH) {
            reportedSpeed = true;
            return String.format(Locale.ROOT, "%d bytes came at %d baud, and %s is at %d by now: the program has to change its rate, too", garbled,
                garbledAt, device, speed);
        }
        return null;
    }
}
