package org.myrobotlab.service.interfaces;

import java.util.List;
import org.myrobotlab.framework.interfaces.NameProvider;

/** Tells when a port opens and closes. */
public interface PortPublisher extends NameProvider {
    /** Where openings are published. */
    String publishConnect(String portName);

    /** Where closings are published. */
    String publishDisconnect(String portName);

    /** Name of the open port; null if none is. */
    String getPortName();

    /** Names of all ports. */
    List<String> getPortNames();

    /** Whether a port is open. */
    boolean isConnected();
}
