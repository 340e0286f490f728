// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

/** Throughput of a queue or serial line. */
public class QueueStats {
    public String name;
    /** Items so far. */
    public int total;
    /** Items between two reports. */
    public int interval = 1000;
    /** Time of the last report and the one before; milliseconds since 1970. */
    public long ts;
    public long lastTS;
    /** Time between the last two reports, ms. */
    public long delta;
    /** Line speed, bits per millisecond. */
    public long lineSpeed;
    public int currentQueueCount;

    public String getName() {
        return name;
    }
}
