package org.myrobotlab.service.interfaces;

import java.util.concurrent.BlockingQueue;

/** Has a queue that can be read. */
public interface QueueSource {
    String getName();

    /** The queue. */
    BlockingQueue<?> getQueue();
}
