package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import org.SEAR.protocol.rplidar.RplidarCommand;
import org.SEAR.protocol.rplidar.RplidarRequestPacket;
import org.myrobotlab.service.lidar.requests.DeviceRequest;

/** A request to an RPLIDAR, and what then happens. */
final class RplidarRequest extends DeviceRequest {
    /** STOP has no answer; after it the device needs a moment. */
    private static final int NO_REPLY = 0;
    private static final int EXPRESS_PAYLOAD = 5;

    /** What is asked. */
    final RplidarCommand command;
    /** Whether the answer is a whole turn, not just the descriptor of a scan. */
    final boolean wholeTurn;
    /** Takes the packet of the answer; of a scan null. */
    final Consumer<byte[]> then;

    /** @param timeout seconds until the answer, or, after what has none, until the next request */
    RplidarRequest(String name, RplidarCommand command, boolean wholeTurn, double timeout, Consumer<byte[]> then) {
        super(name, () -> bytes(command), command.getDescriptor() == null ? NO_REPLY : command.getDescriptor().getLength(), timeout);
        this.command = command;
        this.wholeTurn = wholeTurn;
        this.then = then;
    }

    private static byte[] bytes(RplidarCommand command) {
        return new RplidarRequestPacket(command.getCode(), new byte[command.hasPayload() ? EXPRESS_PAYLOAD : 0]).toBytes();
    }
}
