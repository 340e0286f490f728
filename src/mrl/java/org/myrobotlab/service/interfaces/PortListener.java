// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.interfaces.NameProvider;

/** Gets called when a port opens or closes. */
public interface PortListener extends NameProvider {
    /** Called when the port is open. */
    void onConnect(String portName);

    /** Called when the port closes. */
    void onDisconnect(String portName);
}
