package org.myrobotlab.service.lidar;

import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DeviceRequest;
import org.myrobotlab.service.lidar.requests.DriverEvents;
import org.myrobotlab.service.lidar.requests.Requests;

/**
 * Talks to a scanner: its requests go through {@link Requests}, what it speaks a subclass knows. Any thread; what a subclass overrides is called
 * under its lock.
 *
 * @param <R> what is asked
 */
abstract class LidarDriver<R extends DeviceRequest> {
    final DriverEvents events;
    final Requests<R> requests;

    /** @param bauds that the scanner may be left at */
    LidarDriver(DeviceLine line, DriverEvents events, int[] bauds) {
        this.events = events;
        this.requests = new Requests<>(line, events, bauds, this::forget, this::sending);
    }

    /** Forgets what the scanner has begun to say. */
    abstract void forget();

    /** A request is about to be sent. */
    void sending(R request) {
    }

    /** Bytes from the scanner. */
    abstract void receive(byte[] bytes);

    /**
     * Queues a request.
     *
     * @throws IllegalStateException if the scanner is far behind
     */
    final synchronized void ask(R request) {
        requests.add(request);
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
    final synchronized boolean isIdle() {
        return requests.isIdle();
    }

    /** Follows the scanner to another rate; it needs a moment before it listens there. */
    final synchronized void changeBaud(int baud) {
        requests.changeBaud(baud);
    }
}
