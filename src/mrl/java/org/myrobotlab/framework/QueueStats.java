package org.myrobotlab.framework;

/** How fast a queue or line moves. */
public class QueueStats {
    public String name;
    /** Items so far. */
    public int total;
    /** Items between two reports. */
    public int interval = 1000;
    /** When the last report was made, and the one before; milliseconds since 1970. */
    public long ts;
    public long lastTS;
    /** Milliseconds between the two. */
    public long delta;
    /** Bits a millisecond. */
    public long lineSpeed;
    public int currentQueueCount;

    public String getName() {
        return name;
    }
}
