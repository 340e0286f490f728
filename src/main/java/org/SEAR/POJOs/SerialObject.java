package org.SEAR.POJOs;

/** An object with a serial device behind it. */
public interface SerialObject {
    /** Port name of the device's end; null without ports. */
    String getUartPort();

    /** Port name of the user's end; null without ports. */
    String getUserPort();

    /** Bits a second at power-on. */
    int getBaud();
}
