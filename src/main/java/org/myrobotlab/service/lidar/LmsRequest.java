package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.LmsPayload;
import org.SEAR.protocol.lms.Telegram;
import org.myrobotlab.service.lidar.requests.DeviceRequest;

/** One thing asked of an LMS2xx: what is sent, what answers it, how long that may take, and what then happens. */
final class LmsRequest extends DeviceRequest {
    /** What is asked; its reply byte begins the answer. */
    final LmsCommand command;
    /** Takes the answer. */
    final Consumer<Telegram> then;

    /**
     * @param payload command and data
     * @param replyLength bytes
     * @param timeout seconds
     */
    LmsRequest(String name, LmsCommand command, Supplier<LmsPayload> payload, int replyLength, double timeout, Consumer<Telegram> then) {
        super(name, () -> Telegram.request(payload.get()).toBytes(), replyLength, timeout);
        this.command = command;
        this.then = then;
    }
}
