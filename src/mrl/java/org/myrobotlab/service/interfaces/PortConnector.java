// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

/** Opens and closes ports. */
public interface PortConnector {
    /** Opens a port. */
    void connect(String port) throws Exception;

    /** Opens a port at a baud rate. */
    void connect(String port, int rate) throws Exception;

    /** Opens a port. */
    void connect(String port, int rate, int dataBits, int stopBits, int parity) throws Exception;

    /** Closes the port. */
    void disconnect();

    /** Whether a port is open. */
    boolean isConnected();
}
