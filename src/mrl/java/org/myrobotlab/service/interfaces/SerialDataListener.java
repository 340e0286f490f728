// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.interfaces.NameProvider;

/** Gets the bytes of a port. */
public interface SerialDataListener extends NameProvider, QueueReporter, PortListener {
    /** Called with received bytes by the port's reader thread. */
    void onBytes(byte[] bytes);
}
