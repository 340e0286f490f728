package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.SEAR.protocol.lms.Command;
import org.SEAR.protocol.lms.Payload;
import org.SEAR.protocol.lms.Telegram;

/** One thing asked of an LMS2xx: what is sent, what answers it, how long that may take, and what then happens. */
final class LmsRequest {
    /** In words, for messages. */
    final String name;
    /** What is asked; its reply byte begins the answer. */
    final Command command;
    /** Command and data, made when it is sent: later requests of a series depend on earlier answers. */
    final Supplier<Payload> payload;
    /** Bytes of the whole answer, for the time it takes on the line. */
    final int replyLength;
    /** Seconds that the device may think before it answers. */
    final double patience;
    /** Takes the answer. */
    final Consumer<Telegram> then;

    LmsRequest(String name, Command command, Supplier<Payload> payload, int replyLength, double patience, Consumer<Telegram> then) {
        this.name = name;
        this.command = command;
        this.payload = payload;
        this.replyLength = replyLength;
        this.patience = patience;
        this.then = then;
    }
}
