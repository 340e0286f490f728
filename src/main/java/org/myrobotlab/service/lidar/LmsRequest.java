package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import java.util.function.Supplier;

/** One thing asked of an LMS2xx: what is sent, what answers it, how long that may take, and what then happens. */
final class LmsRequest {
    /** In words, for messages. */
    final String name;
    /** Command and data, made when it is sent: later requests of a series depend on earlier answers. */
    final Supplier<byte[]> body;
    /** The command byte of the answer. */
    final int reply;
    /** Bytes of the whole answer, for the time it takes on the line. */
    final int replyLength;
    /** Seconds that the device may think before it answers. */
    final double patience;
    /** Takes command, data and status of the answer. */
    final Consumer<byte[]> then;

    LmsRequest(String name, Supplier<byte[]> body, int reply, int replyLength, double patience, Consumer<byte[]> then) {
        this.name = name;
        this.body = body;
        this.reply = reply;
        this.replyLength = replyLength;
        this.patience = patience;
        this.then = then;
    }
}
