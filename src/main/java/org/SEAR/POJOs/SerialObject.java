package org.SEAR.POJOs;

import org.SEAR.grammar.ExportTarget;

/**
 * A {@link SearObject} with a serial device behind it: its ports, the speed of its line, and where programs outside find it. One thread at a time.
 */
public interface SerialObject {
    /** All that follows, as parameters of the object. */
    SerialParameters getSerial();

    /** Port name of the device's end; null without ports. */
    default String getUartPort() {
        return getSerial().getUartPort();
    }

    /** Port name of the user's end; null without ports. */
    default String getUserPort() {
        return getSerial().getUserPort();
    }

    /** Bits a second at power-on. */
    default int getBaud() {
        return getSerial().getBaud();
    }

    /** Where programs outside find the user's end while a simulation runs, see {@link ExportTarget}; null for nowhere. */
    default String getExport() {
        return getSerial().getExport();
    }

    /**
     * Names both ports and writes the object's file.
     *
     * @param uart the device's end; null, as the user's, for none
     * @param user the end that the user opens
     * @throws IllegalArgumentException unless both are names of two ports, or both null
     */
    default void setPorts(String uart, String user) {
        getSerial().setPorts(uart, user);
    }

    /**
     * Has every start of a simulation export the user's port; the export stays while the simulation is stopped.
     *
     * @param target the name of a link in the folder SEARports, for example {@code ttySICK}; or {@code tcp:5001} or {@code rfc2217:5001}, a port of
     *     this computer; null for nowhere
     */
    default void setExport(String target) {
        getSerial().setExport(target);
    }

    /** @param port raw bytes at this TCP port of this computer, 1024 to 65535 */
    default void setExport(int port) {
        getSerial().setExport("tcp:" + port);
    }

    /** @param newBaud bits a second at power-on, 300 to 100000000 */
    default void setBaud(int newBaud) {
        getSerial().setBaud(newBaud);
    }
}
