// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.concurrent.TimeUnit;

/** Limits lock-step to the requested speed. Any thread. */
final class Throttle {
    private static final double NANOS = TimeUnit.SECONDS.toNanos(1);

    private double speed;
    private double startTime;
    private long startNanos;

    /** @param speed simulated seconds per second; infinity = as fast as possible */
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
     * Sets the start of the measurement.
     *
     * @param time simulated seconds
     */
    synchronized void begin(double time) {
        startTime = time;
        startNanos = System.nanoTime();
    }

    /** Waits until real time has caught up with simulated time. */
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
