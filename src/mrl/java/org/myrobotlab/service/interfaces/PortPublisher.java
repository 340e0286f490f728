// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import java.util.List;
import org.myrobotlab.framework.interfaces.NameProvider;

/** Publishes when a port opens or closes. */
public interface PortPublisher extends NameProvider {
    /** Publishes an opened port. */
    String publishConnect(String portName);

    /** Publishes a closed port. */
    String publishDisconnect(String portName);

    /** Name of the open port; null if none is open. */
    String getPortName();

    /** Names of all ports. */
    List<String> getPortNames();

    /** Whether a port is open. */
    boolean isConnected();
}
