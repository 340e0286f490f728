// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import org.SEAR.protocol.scip.Reply;
import org.SEAR.protocol.scip.ReplyReader;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DriverEvents;
import org.myrobotlab.service.lidar.requests.Requests;

/** Driver of a Hokuyo scanner: commands with echo and reply, see {@link Requests}, and streamed scans. Any thread. */
final class ScipDriver extends LidarDriver<ScipRequest> {
    private final Consumer<Reply> scans;
    private final ReplyReader reader = new ReplyReader(this::onReply, () -> { });

    /**
     * @param bauds the rates that the scanner may be set to
     * @param scans takes the scans of MD and MS
     */
    ScipDriver(DeviceLine line, DriverEvents events, int[] bauds, Consumer<Reply> scans) {
        super(line, events, bauds);
        this.scans = scans;
    }

    @Override
    void forget() {
        reader.clear();
    }

    @Override
    synchronized void receive(byte[] bytes) {
        reader.accept(bytes);
    }

    private void onReply(Reply reply) {
        ScipRequest current = requests.current();
        if (reply.isScan()) {
            requests.hear();
            accept(scans, reply);
        } else if (current != null && reply.getEcho().endsWith(current.command)) {
            requests.hear();
            accept(requests.answered().then, reply);
            requests.next();
        }
    }

    private void accept(Consumer<Reply> taker, Reply reply) {
        try {
            taker.accept(reply);
        } catch (IndexOutOfBoundsException | IllegalArgumentException e) {
            events.error("the LIDAR sent an invalid reply to " + reply.getEcho() + ": " + e.getMessage());
        }
    }
}
