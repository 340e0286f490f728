// SPDX-License-Identifier: Apache-2.0
package org.SEAR.parallel;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;

/**
 * Runs pieces of work in parallel. The caller of {@link #forEach} and the pool's helper threads each take the next free
 * piece, and all pieces are done when the call returns. A helper that wakes late, or not at all, costs little. Any
 * thread may run any piece, so pieces must not depend on each other.
 *
 * <p>Helpers start when there is work, spin briefly for more, then sleep. They end after some idle seconds or when the
 * pool is closed. Sharing work allocates nothing while they live. One thread at a time shares work. A nested call, or
 * another thread's call meanwhile, runs all its pieces itself.
 */
public final class WorkerPool implements AutoCloseable {
    /** Maximum number of threads. */
    public static final int MAX_THREADS = 256;
    /** Text of the legal range. */
    public static final String LEGAL = "1 to " + MAX_THREADS;
    /** A pool without helpers. */
    public static final WorkerPool ALONE = new WorkerPool(1);

    /** Value of {@link #CLAIM}'s next piece when there is no work. */
    private static final int CLOSED = Integer.MAX_VALUE;
    private static final int GENERATION = Integer.SIZE;
    /** Time to spin for work, or for the others' end, before sleeping; waking a thread takes about as long. */
    private static final long SPIN_NANOS = TimeUnit.MICROSECONDS.toNanos(50);
    private static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(5);

    /**
     * Indices in {@link #counters}, each in its own cache line. CLAIM: number of the present work in the upper half,
     * its next piece in the lower. FINISHED: pieces done.
     */
    private static final int CLAIM = 16;
    private static final int FINISHED = 32;
    private static final int COUNTERS = 48;

    private final AtomicBoolean busy = new AtomicBoolean();
    private final AtomicLongArray counters = new AtomicLongArray(COUNTERS);
    private IntConsumer work;
    private int count;
    private long shared;
    private int failedPiece;
    private Throwable failure;
    private volatile Thread waiter;
    private volatile Helper[] helpers;
    private volatile boolean closed;
    private volatile boolean spinning;

    /** @param threads number of threads including the caller, see {@link #setThreads} */
    public WorkerPool(int threads) {
        counters.set(CLAIM, CLOSED);
        setThreads(threads);
    }

    /** Returns the machine's number of processors, up to the maximum. */
    public static int threadsOfMachine() {
        return Math.min(MAX_THREADS, Runtime.getRuntime().availableProcessors());
    }

    /**
     * @return the number of threads
     * @throws IllegalArgumentException with the legal range
     */
    public static int checked(int threads) {
        if (threads < 1 || threads > MAX_THREADS) {
            throw new IllegalArgumentException("threads is " + threads + ", legal: " + LEGAL);
        }
        return threads;
    }

    /** Returns whether a text is a legal number of threads. */
    public static boolean isLegal(String text) {
        return text.matches("[0-9]{1,3}") && Integer.parseInt(text) >= 1 && Integer.parseInt(text) <= MAX_THREADS;
    }

    /**
     * Sets the number of threads including the caller. Not during {@link #forEach}.
     *
     * @throws IllegalArgumentException with the legal range
     */
    public void setThreads(int threads) {
        checked(threads);
        endHelpers();
        spinning = threads <= threadsOfMachine();
        Helper[] made = new Helper[threads - 1];
        for (int i = 0; i < made.length; i++) {
            made[i] = new Helper(i + 1);
        }
        helpers = made;
    }

    /** Returns the number of threads including the caller. */
    public int getThreads() {
        return helpers.length + 1;
    }

    /** Returns the number of pieces that were shared with helpers, whichever thread ran them. */
    public long getShared() {
        return shared;
    }

    /**
     * Runs all pieces, from 0 on, and returns when they are done.
     *
     * @param pieces number of pieces
     * @throws RuntimeException or an error that a piece has thrown; of several, that of the lowest piece
     */
    public void forEach(int pieces, IntConsumer piece) {
        if (pieces < 2 || helpers.length == 0 || closed || !busy.compareAndSet(false, true)) {
            for (int i = 0; i < pieces; i++) {
                piece.accept(i);
            }
            return;
        }
        try {
            share(pieces, piece);
        } finally {
            busy.set(false);
        }
    }

    private void share(int pieces, IntConsumer piece) {
        shared += pieces;
        work = piece;
        count = pieces;
        counters.set(FINISHED, 0);
        long generation = (claim() >>> GENERATION) + 1;
        counters.set(CLAIM, generation << GENERATION);
        Throwable failed;
        try {
            Helper[] present = helpers;
            for (int i = 0; i < present.length && i < pieces - 1; i++) {
                present[i].wake();
            }
        } finally {    // also if there is no memory for another thread
            takePieces();
            awaitEnd();
            counters.set(CLAIM, generation << GENERATION | CLOSED);
            work = null;
            failed = takeFailure();
        }
        throwAgain(failed);
    }

    private synchronized Throwable takeFailure() {
        Throwable thrown = failure;
        failure = null;
        return thrown;
    }

    private static void throwAgain(Throwable thrown) {
        if (thrown instanceof Error) {
            throw (Error) thrown;
        }
        if (thrown != null) {
            throw (RuntimeException) thrown;
        }
    }

    /** Returns whether some pieces are unclaimed. */
    private boolean isOpen() {
        return (int) claim() < count;
    }

    /**
     * Runs pieces until none is left. The claim is closed before {@link #work} and {@link #count} change, so a thread
     * that has claimed a piece has seen the right ones.
     */
    private void takePieces() {
        int done = 0;
        int end = 0;
        for (long now = claim(); (int) now != CLOSED; now = claim()) {
            IntConsumer piece = work;
            end = count;
            int number = (int) now;
            if (number >= end) {
                break;
            }
            if (counters.compareAndSet(CLAIM, now, now + 1)) {
                done++;
                doPiece(piece, number);
            }
        }
        if (done > 0 && counters.addAndGet(FINISHED, done) == end) {
            LockSupport.unpark(waiter);
        }
    }

    private long claim() {
        return counters.get(CLAIM);
    }

    private void doPiece(IntConsumer piece, int number) {
        try {
            piece.accept(number);
        } catch (RuntimeException | Error e) {
            fail(number, e);
        }
    }

    private synchronized void fail(int number, Throwable thrown) {
        if (failure == null || number < failedPiece) {
            failedPiece = number;
            failure = thrown;
        }
    }

    private void awaitEnd() {
        long from = System.nanoTime();
        while (counters.get(FINISHED) < count) {
            if (spinning && System.nanoTime() - from < SPIN_NANOS) {
                Thread.onSpinWait();
            } else {
                waiter = Thread.currentThread();
                if (counters.get(FINISHED) < count) {
                    LockSupport.park(this);
                }
            }
        }
        waiter = null;
    }

    private void endHelpers() {
        if (helpers != null) {
            for (Helper helper : helpers) {
                helper.end();
            }
        }
    }

    /** Ends the helpers; later work runs on the caller alone. */
    @Override
    public void close() {
        closed = true;
        endHelpers();
    }

    /** One thread of the pool, created when there is work for it. */
    private final class Helper implements Runnable {
        private static final int GONE = 0;
        private static final int AWAKE = 1;
        private static final int ASLEEP = 2;

        private final int number;
        private final AtomicInteger state = new AtomicInteger(GONE);
        private volatile Thread thread;
        private volatile boolean ending;

        Helper(int number) {
            this.number = number;
        }

        /** Makes the helper look for work, unless it does so already. */
        void wake() {
            if (state.compareAndSet(ASLEEP, AWAKE)) {
                LockSupport.unpark(thread);
            } else if (state.compareAndSet(GONE, AWAKE)) {
                start();
            }
        }

        private void start() {
            Thread made = new Thread(this, "SEAR worker " + number);
            made.setDaemon(true);
            thread = made;
            boolean begun = false;
            try {
                made.start();
                begun = true;
            } finally {
                if (!begun) {
                    state.set(GONE);
                }
            }
        }

        void end() {
            ending = true;
            LockSupport.unpark(thread);
        }

        @Override
        public void run() {
            boolean awake = true;
            try {
                while (awake && !ending) {
                    takePieces();
                    awake = isWorkSoon() || isWokenUp();
                }
            } finally {
                if (awake) {
                    state.set(GONE);
                }
            }
        }

        private boolean isWorkSoon() {
            for (long from = System.nanoTime(); spinning && System.nanoTime() - from < SPIN_NANOS && !ending;) {
                if (isOpen()) {
                    return true;
                }
                Thread.onSpinWait();
            }
            return false;
        }

        /** Sleeps until woken; returns false after a long idle time, when the helper is gone. */
        private boolean isWokenUp() {
            state.set(ASLEEP);
            if (isOpen() && state.compareAndSet(ASLEEP, AWAKE)) {
                return true;
            }
            long from = System.nanoTime();
            while (state.get() == ASLEEP && !ending) {
                LockSupport.parkNanos(WorkerPool.this, IDLE_NANOS);
                if (System.nanoTime() - from >= IDLE_NANOS && state.compareAndSet(ASLEEP, GONE)) {
                    return false;
                }
            }
            return true;
        }
    }
}
