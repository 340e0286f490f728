package org.SEAR.POJOs;

/** An object with a serial device behind it. */
public interface SerialObject {
    /** Port name of the device's end; null without ports. */
    String getUartPort();

    /** Port name of the user's end; null without ports. */
    String getUserPort();

    /** Where programs outside find the user's end while a simulation runs, see {@link ExportTarget}; null for nowhere. */
    default String getExport() {
        return null;
    }

    /** Bits a second at power-on. */
    int getBaud();
}
