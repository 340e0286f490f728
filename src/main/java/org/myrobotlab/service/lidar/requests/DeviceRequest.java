package org.myrobotlab.service.lidar.requests;

import java.util.function.Supplier;

/** One thing asked of a device: what is sent, and how long the answer may take. */
public class DeviceRequest {
    /** In words, for messages. */
    public final String name;
    /** What is sent, made when it is sent: later requests of a series depend on earlier answers. */
    public final Supplier<byte[]> bytes;
    /** Bytes of the whole answer, for the time it takes on the line; 0 if there is none. */
    public final int replyLength;
    /** Seconds that the device may think before it answers; after what has no answer, until the next request. */
    public final double timeout;

    /**
     * @param replyLength bytes; 0 if there is no answer
     * @param patience seconds
     */
    protected DeviceRequest(String name, Supplier<byte[]> bytes, int replyLength, double patience) {
        this.name = name;
        this.bytes = bytes;
        this.replyLength = replyLength;
        this.timeout = patience;
    }
}
