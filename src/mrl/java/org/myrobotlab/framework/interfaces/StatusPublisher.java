package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Status;

/** Publishes statuses. */
public interface StatusPublisher extends NameProvider {
    /** Logs a status and publishes it. */
    void broadcastStatus(Status status);

    /** Where statuses are published. */
    Status publishStatus(Status status);
}
