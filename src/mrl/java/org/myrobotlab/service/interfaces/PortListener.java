package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.interfaces.NameProvider;

/** Is told when a port opens and closes. */
public interface PortListener extends NameProvider {
    /** The port is open. */
    void onConnect(String portName);

    /** The port is closed. */
    void onDisconnect(String portName);
}
