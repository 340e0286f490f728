package org.myrobotlab.service.sear.run;

import java.util.concurrent.TimeUnit;

/** Keeps lock-step from running faster than asked for. Any thread. */
final class Throttle {
    private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

    private double speed;
    private double startTime;
    private long startNanos;

    /** @param speed simulated seconds a second; infinity = as fast as possible */
    Throttle(double speed) {
        this.speed = speed;
    }

    synchronized void setSpeed(double factor) {
        speed = factor;
        startTime = Double.NaN;
        notifyAll();
    }

    synchronized double getSpeed() {
        return speed;
    }

    /**
     * From here on time is kept.
     *
     * @param time simulated seconds
     */
    synchronized void begin(double time) {
        startTime = time;
        startNanos = System.nanoTime();
    }

    /** Waits until the computer's time has come as far as simulated time. */
    synchronized void await(double time) throws InterruptedException {
        if (Double.isNaN(startTime)) {
            begin(time);
        }
        while (!Double.isInfinite(speed) && !Double.isNaN(startTime)) {
            long left = (long) ((time - startTime) / speed * NANOS) - (System.nanoTime() - startNanos);
            if (left <= 0) {
                return;
            }
            TimeUnit.NANOSECONDS.timedWait(this, Math.max(left, TimeUnit.MILLISECONDS.toNanos(1)));
        }
    }
}
