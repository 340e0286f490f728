package org.SEAR.devices;

/**
 * Looks at what goes over a line, in a step or between two, without changing anything; each method does nothing unless it is overridden. Simulation
 * thread.
 */
public interface LineListener {
    /** Bytes of the user's end are on their way to the device from now on; the array is the line's. */
    default void heard(SerialLine line, byte[] bytes, int count) {
    }

    /** Bytes have left the device, whether somebody reads them or not; the array is the reader's. */
    default void said(SerialLine line, byte[] bytes) {
    }

    /** From now on the user's end has this speed, 0 for the device's own. */
    default void baud(SerialLine line, int baud) {
    }

    /** The device notices that a program has opened the user's end. */
    default void opened(SerialLine line) {
    }

    /** The device notices that the last program has left the user's end. */
    default void lineClosed(SerialLine line) {
    }
}
