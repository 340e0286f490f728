// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.python3;

import java.io.IOException;

/** The only gateway of a service, if it is open. Any thread. */
public final class Gateways implements AutoCloseable {
    private Gateway gateway;

    /** Opens the gateway at its default port unless it is already open. */
    public synchronized int open() throws IOException {
        return open(gateway == null ? Gateway.PORT : 0);
    }

    /**
     * Opens the gateway; a repeated call returns the same one.
     *
     * @param port 0 for any
     * @return the port
     * @throws IllegalStateException if it is open at another port
     */
    public synchronized int open(int port) throws IOException {
        if (gateway == null) {
            gateway = Gateway.open(port);
        } else if (port != 0 && port != gateway.getPort()) {
            throw new IllegalStateException("the Python 3 gateway is open at port " + gateway.getPort()
                + " already: call stopPython3() first");
        }
        return gateway.getPort();
    }

    /** Closes the gateway if it is open. */
    @Override
    public synchronized void close() {
        if (gateway != null) {
            gateway.close();
            gateway = null;
        }
    }
}
