// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.ExportTarget;
import org.SEAR.grammar.Included;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ParameterTable;
import org.SEAR.grammar.TextRule;

/**
 * Ports and baud rate of a simulated device, as {@link Included} parameters of a {@link SerialObject}. One thread at a
 * time.
 */
public final class SerialParameters {
    private final SearObject owner;
    @Param(doc = "port of the simulated device's end")
    private String uartPort;
    @Param(doc = "port that the user opens")
    private String userPort;
    @Param(doc = "baud rate at power-on", unit = "baud", min = 300, max = 1e8)
    private int baud;
    @Param(doc = "where other programs on this computer find the user's port, from a simulation's start on",
        text = TextRule.EXPORT)
    private String export;

    /**
     * Without ports.
     *
     * @param owner the object with these parameters
     * @param baud default bits a second at power-on
     */
    SerialParameters(SearObject owner, int baud) {
        this.owner = owner;
        this.baud = baud;
    }

    public String getUartPort() {
        return uartPort;
    }

    public String getUserPort() {
        return userPort;
    }

    public int getBaud() {
        return baud;
    }

    /**
     * Sets both port names and writes the object's file.
     *
     * @param uart the device's end; null, as the user's, for none
     * @throws IllegalArgumentException unless both are different names, or both null
     */
    public void setPorts(String uart, String user) {
        if (uart == null && user == null) {
            owner.checkChangeable();
        } else if (uart == null || user == null || uart.trim().isEmpty() || user.trim().isEmpty()
            || uart.equals(user)) {
            throw new IllegalArgumentException(owner.label() + ": ports are " + ParameterTable.quote(uart) + " and "
                + ParameterTable.quote(user) + ", legal: two different names");
        } else {
            owner.checked("uartPort", uart);
            owner.checked("userPort", user);
        }
        uartPort = uart;
        userPort = user;
        owner.changed();
    }

    public String getExport() {
        return export;
    }

    /**
     * Sets where other programs find the user's end, and writes the object's file.
     *
     * @param target see {@link ExportTarget}; null for no export
     */
    public void setExport(String target) {
        if (target == null) {
            owner.checkChangeable();
        } else {
            owner.checked("export", target);
        }
        export = target;
        owner.changed();
    }

    /**
     * Sets the baud rate at power-on and writes the object's file.
     *
     * @param newBaud 300 to 100000000
     */
    public void setBaud(int newBaud) {
        baud = owner.checked("baud", newBaud);
        owner.changed();
    }
}
