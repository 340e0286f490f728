// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import org.myrobotlab.service.lidar.requests.DeviceLine;
import org.myrobotlab.service.lidar.requests.DeviceRequest;
import org.myrobotlab.service.lidar.requests.DriverEvents;
import org.myrobotlab.service.lidar.requests.Requests;

/**
 * Sends requests to a scanner through {@link Requests}; subclasses implement the protocols. Any thread; calls
 * overridden methods under its lock.
 *
 * @param <R> type of the requests
 */
abstract class LidarDriver<R extends DeviceRequest> {
    final DriverEvents events;
    final Requests<R> requests;

    /** @param bauds the rates that the scanner may be set to */
    LidarDriver(DeviceLine line, DriverEvents events, int[] bauds) {
        this.events = events;
        this.requests = new Requests<>(line, events, bauds, this::forget, this::sending);
    }

    /** Drops an incomplete reply. */
    abstract void forget();

    /** Called before a request is sent. */
    void sending(R request) {
    }

    /** Takes bytes from the scanner. */
    abstract void receive(byte[] bytes);

    /**
     * Queues a request.
     *
     * @throws IllegalStateException if too many requests wait
     */
    final synchronized void ask(R request) {
        requests.add(request);
    }

    /** Checks time-outs. */
    synchronized void tick() {
        requests.tick();
    }

    /** Forgets all requests after the port was closed. */
    synchronized void clear() {
        requests.clear();
    }

    /** Returns whether no request is active or waiting. */
    final synchronized boolean isIdle() {
        return requests.isIdle();
    }

    /** Sets the port to the scanner's new rate and pauses until the scanner listens again. */
    final synchronized void changeBaud(int baud) {
        requests.changeBaud(baud);
    }
}
