// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;

/** Reports its state and last error. */
public interface ServiceStatus {
    /** Publishes this service in its current state. */
    Service<?> broadcastState();

    /** The last error; null if there was none. */
    Status getLastError();
}
