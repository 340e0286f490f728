// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.ExportTarget;

/**
 * A {@link SearObject} with a serial device: its ports, its baud rate, and its export to other programs. One thread at
 * a time.
 */
public interface SerialObject {
    /** Returns the parameters of the serial line. */
    SerialParameters getSerial();

    /** Returns the port name of the device's end; null without ports. */
    default String getUartPort() {
        return getSerial().getUartPort();
    }

    /** Returns the port name of the user's end; null without ports. */
    default String getUserPort() {
        return getSerial().getUserPort();
    }

    /** Returns the bits a second at power-on. */
    default int getBaud() {
        return getSerial().getBaud();
    }

    /**
     * Returns where other programs find the user's end while a simulation runs, see {@link ExportTarget}; null for no
     * export.
     */
    default String getExport() {
        return getSerial().getExport();
    }

    /**
     * Sets both port names and writes the object's file.
     *
     * @param uart the device's end; null, as the user's, for none
     * @param user the end that the user opens
     * @throws IllegalArgumentException unless both are different names, or both null
     */
    default void setPorts(String uart, String user) {
        getSerial().setPorts(uart, user);
    }

    /**
     * Exports the user's port from each start of a simulation on; the export stays while the simulation is stopped.
     *
     * @param target the name of a link in the folder SEARports, for example {@code ttySICK}; or {@code tcp:5001} or
     *     {@code rfc2217:5001}, a port of this computer; null for no export
     */
    default void setExport(String target) {
        getSerial().setExport(target);
    }

    /** @param port TCP port of this computer for raw bytes, 1024 to 65535 */
    default void setExport(int port) {
        getSerial().setExport("tcp:" + port);
    }

    /** @param newBaud bits a second at power-on, 300 to 100000000 */
    default void setBaud(int newBaud) {
        getSerial().setBaud(newBaud);
    }
}
