// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/** Clock of the bytes on virtual ports: simulated time while a simulation runs, else the computer's. Any thread. */
public abstract class PortClock {
    /** The computer's clock: seconds since some fixed moment. */
    public static final PortClock WALL = new Wall();

    private static final double NANOS = TimeUnit.SECONDS.toNanos(1);
    private static volatile PortClock current = WALL;

    /** Returns the clock in use. */
    public static PortClock current() {
        return current;
    }

    /** Makes this the clock of all virtual ports. */
    public void install() {
        current = this;
    }

    /** Restores the computer's clock, if this clock is in use. */
    public void uninstall() {
        if (current == this) {
            current = WALL;
        }
    }

    /** Time, seconds. */
    public abstract double now();

    /**
     * Waits until {@link #now} has reached {@code time}, until another clock is in use, or until this one changes to
     * lock-step.
     */
    public abstract void await(double time) throws InterruptedException;

    /** Whether only calls advance time; bytes between two users then arrive immediately. */
    public abstract boolean isLockStep();

    /**
     * Runs a callback after each step in lock-step mode, on the thread that advances time; does nothing on a
     * free-running clock.
     */
    public abstract void addTicker(Runnable ticker);

    /** Removes a callback of {@link #addTicker}. */
    public abstract void removeTicker(Runnable ticker);

    private static final class Wall extends PortClock {
        @Override
        public double now() {
            return System.nanoTime() / NANOS;
        }

        @Override
        public void await(double time) throws InterruptedException {
            for (double left = time - now(); left > 0 && current == this; left = time - now()) {
                LockSupport.parkNanos(this, (long) (left * NANOS) + 1);
                if (Thread.interrupted()) {
                    throw new InterruptedException();
                }
            }
        }

        @Override
        public boolean isLockStep() {
            return false;
        }

        @Override
        public void addTicker(Runnable ticker) {
            // No call advances the computer's time.
        }

        @Override
        public void removeTicker(Runnable ticker) {
            // No callback was added.
        }
    }
}
