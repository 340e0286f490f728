package org.myrobotlab.service.link;

import java.io.IOException;
import org.myrobotlab.framework.Service;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.serial.PortUser;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** A service that drives a device and connects to its port again when that comes back, as far as nobody has disconnected it. Any thread. */
public interface Reconnects extends SerialDataListener {
    /** Connects to the port last used. */
    void reconnectSerial() throws IOException;

    /** Closes the port. */
    void disconnect();

    /** Whether a port is open. */
    boolean isConnected();

    /**
     * Waits until a simulation has the port; {@link PortArrivals#forget} ends it.
     *
     * @param ofThisProject whether another project ends it, too
     */
    default void reconnectWhenBack(String port, boolean ofThisProject) {
        PortArrivals.await(new PortUser(getName(), port, ofThisProject, this::reconnect, () -> {
            if (isConnected()) {
                disconnect();
                ((Service<?>) this).info("%s leaves port %s to another service", getName(), port);
            }
        }));
    }

    /** Connects, unless the service has been released; a warning says why it can't. */
    default void reconnect() {
        if (Runtime.getService(getName()) == this) {
            try {
                reconnectSerial();
            } catch (IOException | RuntimeException e) {
                ServiceWarnings.publish((Service<?>) this, "%s", e.getMessage());
            }
        }
    }

    /**
     * A configuration has been restored: connects if the port is there, else waits for it and says so.
     *
     * @param port null for a service that was never connected
     * @param link knows which ports there are
     */
    static void restore(Reconnects driver, String port, SerialLink link) {
        if (port == null) {
            return;
        }
        if (link.getPortNames().contains(port)) {
            driver.reconnect();
        } else {
            driver.reconnectWhenBack(port, false);
            ((Service<?>) driver).info("there is no port %s: %s connects to it as soon as a simulation has it; reconnectSerial() tries again", port,
                driver.getName());
        }
    }
}
