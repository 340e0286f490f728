package org.myrobotlab.serial;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;

/**
 * The time by which bytes travel over virtual ports: simulated time while a simulation runs, else the computer's. Any thread.
 */
public abstract class PortClock {
    /** The computer's time: seconds since some fixed moment. */
    public static final PortClock WALL = new Wall();

    private static final double NANOS = TimeUnit.SECONDS.toNanos(1);
    private static volatile PortClock current = WALL;

    /** The clock that holds now. */
    public static PortClock current() {
        return current;
    }

    /** Makes this the clock of all virtual ports. */
    public void install() {
        current = this;
    }

    /** Gives the ports back to the computer's time, if this is their clock. */
    public void uninstall() {
        if (current == this) {
            current = WALL;
        }
    }

    /** Seconds. */
    public abstract double now();

    /** Waits until {@link #now} has reached {@code time}, or this is no longer the ports' clock, or it has changed to lock-step. */
    public abstract void await(double time) throws InterruptedException;

    /** Whether time stands still but for the calls that advance it; what is sent between two users is then delivered at once. */
    public abstract boolean isLockStep();

    /** Has something run after each step of lock-step, on the thread that advances time; does nothing on a clock that runs by itself. */
    public abstract void addTicker(Runnable ticker);

    /** Ends {@link #addTicker}. */
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
            // The computer's time is never advanced by a call.
        }

        @Override
        public void removeTicker(Runnable ticker) {
            // Nothing was added.
        }
    }
}
