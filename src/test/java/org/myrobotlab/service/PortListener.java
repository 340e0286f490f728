// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;
import org.myrobotlab.service.interfaces.SerialDataListener;

/** A service that only listens to the bytes of a port. */
public abstract class PortListener extends Service<ServiceConfig> implements SerialDataListener {
    private static final long serialVersionUID = 1L;

    protected PortListener(String name, String id) {
        super(name, id);
    }

    @Override
    public void onConnect(String portName) {
        // nothing to do
    }

    @Override
    public void onDisconnect(String portName) {
        // nothing to do
    }
}
