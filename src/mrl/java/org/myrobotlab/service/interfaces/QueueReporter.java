// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.interfaces;

import org.myrobotlab.framework.QueueStats;

/** Reports statistics of its queue. */
public interface QueueReporter {
    /** Publishes statistics. */
    QueueStats publishStats(QueueStats stats);

    /** Updates the statistics. */
    void updateStats(QueueStats stats);
}
