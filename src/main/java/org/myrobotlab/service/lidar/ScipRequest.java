// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.nio.charset.StandardCharsets;
import java.util.function.Consumer;
import org.SEAR.protocol.scip.Reply;
import org.myrobotlab.service.lidar.requests.DeviceRequest;

/** A command to a Hokuyo scanner with its reply handler. */
final class ScipRequest extends DeviceRequest {
    /** The command, which the reply echoes. */
    final String command;
    /** Takes the reply. */
    final Consumer<Reply> then;

    /**
     * @param before commands whose replies don't matter, each with its line feed
     * @param replyLength bytes
     * @param timeout seconds
     */
    ScipRequest(String name, String before, String command, int replyLength, double timeout, Consumer<Reply> then) {
        super(name, () -> (before + command + "\n").getBytes(StandardCharsets.US_ASCII), replyLength, timeout);
        this.command = command;
        this.then = then;
    }
}
