// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import org.myrobotlab.framework.Service;

/** Publishes its state. */
public interface StatePublisher {
    /** Publishes this service in its current state. */
    Service<?> broadcastState();

    /** Called to publish states. */
    Service<?> publishState();
}
