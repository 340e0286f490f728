package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;

/** Knows how it is. */
public interface ServiceStatus {
    /** Publishes this service as it is now. */
    Service<?> broadcastState();

    /** The last error; null if there was none. */
    Status getLastError();
}
