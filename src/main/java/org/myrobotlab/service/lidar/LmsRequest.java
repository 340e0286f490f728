// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import java.util.function.Supplier;
import org.SEAR.protocol.lms.LmsCommand;
import org.SEAR.protocol.lms.LmsPayload;
import org.SEAR.protocol.lms.Telegram;
import org.myrobotlab.service.lidar.requests.DeviceRequest;

/** A request to an LMS2xx with its expected reply, time-out and handler. */
final class LmsRequest extends DeviceRequest {
    /** The command; its reply byte starts the reply. */
    final LmsCommand command;
    /** Takes the reply. */
    final Consumer<Telegram> then;

    /**
     * @param payload command and data
     * @param replyLength bytes
     * @param timeout seconds
     */
    LmsRequest(String name, LmsCommand command, Supplier<LmsPayload> payload, int replyLength, double timeout,
        Consumer<Telegram> then) {
        super(name, () -> Telegram.request(payload.get()).toBytes(), replyLength, timeout);
        this.command = command;
        this.then = then;
    }
}
