package org.myrobotlab.service.link;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.myrobotlab.serial.PortClock;

/**
 * The time by which a driver waits for answers: that of its port's clock, but never faster than the computer's, because the threads that bring the
 * answer need the computer's time. So a simulation at hundreds of times real time gives no false alarm. While bytes are on their way through this
 * program it stands still: on a busy machine the threads that carry them may have no processor for seconds. In lock-step the steps wait for these
 * threads, and this is exactly the port's clock. A reset of the simulation doesn't set it back. Any thread.
 */
final class TimeOutClock {
    /** Of real time that went by without simulated time so much counts later: steps and calls come unevenly. Seconds. */
    private static final double MAX_SAVED = 0.25;
    private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

    private final Supplier<PortClock> clock;
    private final LongSupplier nanoTime;
    private final BooleanSupplier underWay;
    private double last;
    private long lastNanos;
    private double saved;
    /** By which the port's clock is ahead of this one. */
    private double ahead;

    /** @param underWay whether bytes have been sent that those for whom they are don't have yet */
    TimeOutClock(Supplier<PortClock> clock, LongSupplier nanoTime, BooleanSupplier underWay) {
        this.clock = clock;
        this.nanoTime = nanoTime;
        this.underWay = underWay;
    }

    /** Begins with the clock of another port. */
    synchronized void restart() {
        last = clock.get().now();
        lastNanos = nanoTime.getAsLong();
        saved = 0;
        ahead = 0;
    }

    /** Seconds. */
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
