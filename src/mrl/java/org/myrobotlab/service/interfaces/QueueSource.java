// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import java.util.concurrent.BlockingQueue;

/** Has a readable queue. */
public interface QueueSource {
    String getName();

    /** The queue. */
    BlockingQueue<?> getQueue();
}
