// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.link;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.myrobotlab.serial.PortClock;

/**
 * The clock for a driver's time-outs: follows the port's clock, but never runs faster than the computer's. The threads
 * that deliver the answer need real time, so a simulation at hundreds of times real time causes no false time-outs. The
 * clock stands still while bytes are in transit, because a busy machine may delay their threads for seconds. In
 * lock-step, where steps wait for these threads, it equals the port's clock. A reset of the simulation doesn't set it
 * back. Any thread.
 */
final class TimeOutClock {
    /** Most real time without simulated time that may count later, seconds. Allows for uneven steps and calls. */
    private static final double MAX_SAVED = 0.25;
    private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

    private final Supplier<PortClock> clock;
    private final LongSupplier nanoTime;
    private final BooleanSupplier underWay;
    private double last;
    private long lastNanos;
    private double saved;
    /** Lead of the port's clock over this clock, seconds. */
    private double ahead;

    /** @param underWay whether sent bytes have not reached their receiver yet */
    TimeOutClock(Supplier<PortClock> clock, LongSupplier nanoTime, BooleanSupplier underWay) {
        this.clock = clock;
        this.nanoTime = nanoTime;
        this.underWay = underWay;
    }

    /** Restarts with the clock of another port. */
    synchronized void restart() {
        last = clock.get().now();
        lastNanos = nanoTime.getAsLong();
        saved = 0;
        ahead = 0;
    }

    /** Returns the time, seconds. */
    synchronized double now() {
        PortClock port = clock.get();
        double now = port.now();
        long nanos = nanoTime.getAsLong();
        if (!port.isLockStep()) {
            double passed = now - last;
            saved = Math.min(MAX_SAVED, saved + (nanos - lastNanos) / NANOS);
            double counted = underWay.getAsBoolean() ? 0 : Math.max(0, Math.min(passed, saved));
            saved -= counted;
            ahead += passed - counted;
        }
        last = now;
        lastNanos = nanos;
        return now - ahead;
    }
}
