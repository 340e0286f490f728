package org.myrobotlab.service.lidar;

import java.util.function.Consumer;
import org.SEAR.protocol.scip.Reply;
import org.SEAR.protocol.scip.ReplyReader;
import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DriverEvents;
import org.myrobotlab.service.lidar.requests.Requests;

/** Talks to a Hokuyo scanner: commands that are echoed and answered, see {@link Requests}, and scans that come by themselves. Any thread. */
final class ScipDriver {
    private final DriverEvents events;
    private final Consumer<Reply> scans;
    private final ReplyReader reader = new ReplyReader(this::onReply, () -> { });
    private final Requests<ScipRequest> requests;

    /**
     * @param bauds that the scanner may be left at
     * @param scans takes the scans of MD and MS
     */
    ScipDriver(DeviceLine line, DriverEvents events, int[] bauds, Consumer<Reply> scans) {
        this.events = events;
        this.scans = scans;
        this.requests = new Requests<>(line, events, bauds, reader::clear, request -> { });
    }

    /**
     * Queues a request.
     *
     * @throws IllegalStateException if the device is far behind
     */
    synchronized void ask(ScipRequest request) {
        requests.add(request);
    }

    /** Bytes from the device. */
    synchronized void receive(byte[] bytes) {
        reader.accept(bytes);
    }

    /** Lets time-outs pass. */
    synchronized void tick() {
        requests.tick();
    }

    /** Forgets all requests: the port was closed. */
    synchronized void clear() {
        requests.clear();
    }

    /** Whether nothing is asked or waits. */
    synchronized boolean isIdle() {
        return requests.isIdle();
    }

    /** Follows the device to another rate. */
    synchronized void changeBaud(int baud) {
        requests.changeBaud(baud);
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
            events.error("the LIDAR sent an answer to " + reply.getEcho() + " that makes no sense: " + e.getMessage());
        }
    }
}
