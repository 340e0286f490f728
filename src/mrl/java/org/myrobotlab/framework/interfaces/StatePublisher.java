package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Service;

/** Publishes its state. */
public interface StatePublisher {
    /** Publishes this service as it is now. */
    Service<?> broadcastState();

    /** Where states are published. */
    Service<?> publishState();
}
