// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.List;
import java.util.function.Consumer;
import org.SEAR.protocol.rplidar.AnswerReader;
import org.SEAR.protocol.rplidar.Capsule;
import org.SEAR.protocol.rplidar.Node;
import org.SEAR.protocol.rplidar.RplidarCommand;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DriverEvents;
import org.myrobotlab.service.lidar.requests.Requests;

/**
 * Driver of an RPLIDAR: requests and replies, see {@link Requests}, and scans, which continue until the next request.
 * Any thread.
 */
final class RplidarDriver extends LidarDriver<RplidarRequest> implements AnswerReader.Listener {
    private final Consumer<List<RplidarTurn.Sample>> turns;
    private final AnswerReader reader = new AnswerReader(this);
    private final RplidarTurn turn = new RplidarTurn();

    /**
     * @param bauds the rates that the device may have
     * @param turns takes full turns
     */
    RplidarDriver(DeviceLine line, DriverEvents events, int[] bauds, Consumer<List<RplidarTurn.Sample>> turns) {
        super(line, events, bauds);
        this.turns = turns;
    }

    @Override
    void forget() {
        turn.clear();
    }

    @Override
    void sending(RplidarRequest request) {
        turn.clear();
        reader.expect(request.command);
    }

    @Override
    synchronized void receive(byte[] bytes) {
        reader.accept(bytes);
    }

    @Override
    synchronized void clear() {
        super.clear();
        reader.expect(RplidarCommand.STOP);
    }

    @Override
    public void onDescriptor(RplidarCommand command) {
        requests.hear();
        RplidarRequest current = requests.current();
        if (current != null && command.getDescriptor().isMultiple() && !current.wholeTurn) {
            answered(null);
        }
    }

    @Override
    public void onPacket(RplidarCommand command, byte[] bytes) {
        switch (command) {
            case SCAN:
            case FORCE_SCAN:
                turned(turn.add(Node.of(bytes)));
                break;
            case EXPRESS_SCAN:
                turned(turn.add(Capsule.of(bytes)));
                break;
            default:
                answered(bytes);
                break;
        }
    }

    private void turned(List<RplidarTurn.Sample> whole) {
        if (whole == null || whole.isEmpty()) {
            return;
        }
        turns.accept(whole);
        RplidarRequest current = requests.current();
        if (current != null && current.wholeTurn) {
            answered(null);
        }
    }

    private void answered(byte[] packet) {
        RplidarRequest answered = requests.answered();
        if (answered != null) {
            answered.then.accept(packet);
        }
        requests.next();
    }
}
