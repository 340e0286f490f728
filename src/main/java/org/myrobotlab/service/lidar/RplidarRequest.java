// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import org.SEAR.protocol.rplidar.RplidarCommand;
import org.SEAR.protocol.rplidar.RplidarRequestPacket;
import org.myrobotlab.service.lidar.requests.DeviceRequest;

/** A request to an RPLIDAR with its reply handler. */
final class RplidarRequest extends DeviceRequest {
    /** Reply length of STOP, which has no reply. */
    private static final int NO_REPLY = 0;
    private static final int EXPRESS_PAYLOAD = 5;

    final RplidarCommand command;
    /** Whether the reply is a full turn instead of the descriptor of a scan. */
    final boolean wholeTurn;
    /** Takes the packet of the reply; null for a scan. */
    final Consumer<byte[]> then;

    /** @param timeout seconds until the reply or, without a reply, until the next request */
    RplidarRequest(String name, RplidarCommand command, boolean wholeTurn, double timeout, Consumer<byte[]> then) {
        super(name, () -> bytes(command), command.getDescriptor() == null ? NO_REPLY : command.getDescriptor()
            .getLength(), timeout);
        this.command = command;
        this.wholeTurn = wholeTurn;
        this.then = then;
    }

    private static byte[] bytes(RplidarCommand command) {
        return new RplidarRequestPacket(command.getCode(), new byte[command.hasPayload() ? EXPRESS_PAYLOAD : 0])
            .toBytes();
    }
}
