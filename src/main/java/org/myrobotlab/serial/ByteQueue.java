// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.serial;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/** Bytes on their way over a virtual cable, each with the end of its stop bit. Guarded by the port's lock. */
final class ByteQueue {
    private static final double ROUNDING = 1e-9;

    private final Deque<Burst> bursts = new ArrayDeque<>();
    private PortClock lineClock;
    private double lineFreeAt;

    /** Adds bytes that arrive immediately. */
    void add(byte[] bytes) {
        bursts.add(new Burst(bytes, null, 0, 0));
    }

    /**
     * Adds bytes that arrive one after another.
     *
     * @param byteTime duration of a byte, seconds
     */
    void add(byte[] bytes, PortClock clock, double byteTime) {
        double now = clock.now();
        double start = clock == lineClock && lineFreeAt > now ? lineFreeAt : now;
        bursts.add(new Burst(bytes, clock, start, byteTime));
        lineClock = clock;
        lineFreeAt = start + bytes.length * byteTime;
    }

    boolean isEmpty() {
        return bursts.isEmpty();
    }

    void clear() {
        bursts.clear();
        lineClock = null;
    }

    /** Removes and returns up to {@code most} bytes that have arrived; empty if none has. */
    byte[] take(int most) {
        byte[] taken = new byte[most];
        int count = 0;
        while (count < most && !bursts.isEmpty()) {
            Burst head = bursts.peek();
            int n = Math.min(most - count, head.arrived() - head.taken);
            if (n <= 0) {
                break;
            }
            System.arraycopy(head.bytes, head.taken, taken, count, n);
            count += n;
            head.taken += n;
            if (head.taken == head.bytes.length) {
                bursts.remove();
            }
        }
        return count == most ? taken : Arrays.copyOf(taken, count);
    }

    /** Returns the first burst; null if there is none. */
    Burst head() {
        return bursts.peek();
    }

    /** Bytes that were sent together. */
    static final class Burst {
        private final byte[] bytes;
        private final PortClock clock;
        private final double start;
        private final double byteTime;
        private int taken;

        Burst(byte[] bytes, PortClock clock, double start, double byteTime) {
            this.bytes = bytes;
            this.clock = clock;
            this.start = start;
            this.byteTime = byteTime;
        }

        /** Number of its bytes that have arrived; all if its clock has ended or is in lock-step. */
        private int arrived() {
            if (clock == null || clock != PortClock.current() || clock.isLockStep()) {
                return bytes.length;
            }
            return (int) Math.min(bytes.length, Math.floor((clock.now() - start) / byteTime + ROUNDING));
        }

        /** Waits until the next byte arrives. */
        void await() throws InterruptedException {
            if (clock != null) {
                clock.await(start + (taken + 1) * byteTime);
            }
        }
    }
}
