package org.myrobotlab.service.sear.python3;

import java.io.IOException;

/** The one gateway of a service, if it is open. Any thread. */
public final class Gateways implements AutoCloseable {
    private Gateway gateway;

    /** Opens it at its usual port, if it is not open at another one. */
    public synchronized int open() throws IOException {
        return open(gateway == null ? Gateway.PORT : 0);
    }

    /**
     * Opens it; asked for again, it is the same one.
     *
     * @param port 0 for any
     * @return the port
     * @throws IllegalStateException if it is open at another one
     */
    public synchronized int open(int port) throws IOException {
        if (gateway == null) {
            gateway = Gateway.open(port);
        } else if (port != 0 && port != gateway.getPort()) {
            throw new IllegalStateException("Python 3 is served at port " + gateway.getPort() + " already: stopPython3() first");
        }
        return gateway.getPort();
    }

    /** Closes it, if it is open. */
    @Override
    public synchronized void close() {
        if (gateway != null) {
            gateway.close();
            gateway = null;
        }
    }
}
