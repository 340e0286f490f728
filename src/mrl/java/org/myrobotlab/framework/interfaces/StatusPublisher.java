// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Status;

/** Publishes statuses. */
public interface StatusPublisher extends NameProvider {
    /** Publishes a status. */
    void broadcastStatus(Status status);

    /** Called to publish statuses. */
    Status publishStatus(Status status);
}
