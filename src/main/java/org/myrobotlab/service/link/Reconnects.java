// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import java.io.IOException;
import org.myrobotlab.framework.Service;
import org.myrobotlab.serial.PortArrivals;
import org.myrobotlab.serial.PortUser;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.interfaces.SerialDataListener;

/**
 * A service that drives a device and reconnects when its port comes back, unless the user has disconnected it. Any
 * thread.
 */
public interface Reconnects extends SerialDataListener {
    /** Connects to the port last used. */
    void reconnectSerial() throws IOException;

    void disconnect();

    boolean isConnected();

    /**
     * Reconnects as soon as a simulation has the port; {@link PortArrivals#forget} cancels this.
     *
     * @param ofThisProject whether loading another project cancels it, too
     */
    default void reconnectWhenBack(String port, boolean ofThisProject) {
        PortArrivals.await(new PortUser(getName(), port, ofThisProject, this::reconnect, () -> {
            if (isConnected()) {
                disconnect();
                ((Service<?>) this).info("%s leaves port %s to another service", getName(), port);
            }
        }));
    }

    /** Connects unless the service has been released; publishes a failure as a warning. */
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
     * Connects after a configuration was restored. If the port is missing, reports that and waits for the port.
     *
     * @param port null for a service that was never connected
     * @param link lists the available ports
     */
    static void restore(Reconnects driver, String port, SerialLink link) {
        if (port == null) {
            return;
        }
        if (link.getPortNames().contains(port)) {
            driver.reconnect();
        } else {
            driver.reconnectWhenBack(port, false);
            ((Service<?>) driver).info("there is no port %s: %s connects to it as soon as a simulation has it; "
                + "reconnectSerial() tries again", port, driver.getName());
        }
    }
}
