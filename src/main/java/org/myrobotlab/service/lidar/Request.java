package org.myrobotlab.service.lidar;

import java.util.function.Supplier;

/** One thing asked of a device: what is sent, and how long the answer may take. */
class Request {
    /** In words, for messages. */
    final String name;
    /** What is sent, made when it is sent: later requests of a series depend on earlier answers. */
    final Supplier<byte[]> bytes;
    /** Bytes of the whole answer, for the time it takes on the line. */
    final int replyLength;
    /** Seconds that the device may think before it answers. */
    final double patience;

    Request(String name, Supplier<byte[]> bytes, int replyLength, double patience) {
        this.name = name;
        this.bytes = bytes;
        this.replyLength = replyLength;
        this.patience = patience;
    }
}
