package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.QueueStats;

/** Reports how its queue does. */
public interface QueueReporter {
    /** Where statistics are published. */
    QueueStats publishStats(QueueStats stats);

    /** Takes new statistics. */
    void updateStats(QueueStats stats);
}
