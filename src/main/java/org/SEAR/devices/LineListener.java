// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/**
 * Observes the bytes and events of a line without changing anything. Each method does nothing unless overridden.
 * Simulation thread.
 */
public interface LineListener {
    /** Bytes from the host start now; the array belongs to the line. */
    default void heard(SerialLine line, byte[] bytes, int count) {
    }

    /** Bytes have left the device, whether a program reads them or not; the array belongs to the reader. */
    default void said(SerialLine line, byte[] bytes) {
    }

    /** The host port has this baud rate from now on; 0: the device's own. */
    default void baud(SerialLine line, int baud) {
    }

    /** The device notices that a program has opened the host port. */
    default void opened(SerialLine line) {
    }

    /** The device notices that the last program has closed the host port. */
    default void lineClosed(SerialLine line) {
    }
}
