package org.SEAR.parallel;

import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLongArray;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;

/**
 * Does pieces of work side by side: who calls {@link #forEach} does some, its helpers, which are threads of this pool, do the others, and all are
 * done when it returns. Each takes the next piece when it is done with one, so a helper that wakes late or not at all costs little. Who the pieces go
 * to is not known: they must not depend on each other.
 *
 * <p>Helpers begin when there is work for them, look out for more of it for a moment, sleep, and end after some seconds without any, or when the pool
 * is closed. Sharing work allocates nothing once they live. One thread calls it at a time; pieces that call it again, and other threads meanwhile, do
 * all of theirs themselves.
 */
public final class WorkerPool implements AutoCloseable {
    /** Most threads that can be asked for. */
    public static final int MAX_THREADS = 256;
    /** What can be asked for, in words. */
    public static final String LEGAL = "1 to " + MAX_THREADS;
    /** A pool of nobody but the caller. */
    public static final WorkerPool ALONE = new WorkerPool(1);

    /** What {@link #CLAIM} has for the next piece when there is none. */
    private static final int CLOSED = Integer.MAX_VALUE;
    private static final int GENERATION = Integer.SIZE;
    /** So long it is looked for work, or for the others' end, before sleeping: waking a thread takes about as long. */
    private static final long SPIN_NANOS = TimeUnit.MICROSECONDS.toNanos(50);
    private static final long IDLE_NANOS = TimeUnit.SECONDS.toNanos(5);

    /** Places in {@link #counters}, each in a cache line of its own: number of the present work, with that of its next piece below; pieces done. */
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

    /** @param threads how many work, the caller included, as {@link #setThreads} has it */
    public WorkerPool(int threads) {
        counters.set(CLAIM, CLOSED);
        setThreads(threads);
    }

    /** As many as the machine has processors. */
    public static int threadsOfMachine() {
        return Math.min(MAX_THREADS, Runtime.getRuntime().availableProcessors());
    }

    /**
     * @return the number of threads
     * @throws IllegalArgumentException that names the legal range
     */
    public static int checked(int threads) {
        if (threads < 1 || threads > MAX_THREADS) {
            throw new IllegalArgumentException("threads is " + threads + ", legal: " + LEGAL);
        }
        return threads;
    }

    /** Whether a text is a number of threads. */
    public static boolean isLegal(String text) {
        return text.matches("[0-9]{1,3}") && Integer.parseInt(text) >= 1 && Integer.parseInt(text) <= MAX_THREADS;
    }

    /**
     * How many threads work from now on, the caller included. Between two works.
     *
     * @throws IllegalArgumentException that names the legal range
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

    /** How many threads work, the caller included. */
    public int getThreads() {
        return helpers.length + 1;
    }

    /** How many pieces were for the caller and helpers, whoever of them did them: the work that was shared. */
    public long getShared() {
        return shared;
    }

    /**
     * Does all pieces, from 0 on, and returns when they are done.
     *
     * @param pieces how many there are
     * @throws RuntimeException or an error that a piece has thrown, the first of them if several have
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
        } finally {    // also where there is no memory for one more thread
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

    /** Work is there, and some of its pieces belong to nobody yet. */
    private boolean isOpen() {
        return (int) claim() < count;
    }

    /**
     * Does pieces until none is left. When all are done the claim is closed before {@link #work} and {@link #count} change, so who has claimed a
     * piece has seen those it belongs to.
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

    /** Ends the helpers; who still has work does it alone. */
    @Override
    public void close() {
        closed = true;
        endHelpers();
    }

    /** One thread of the pool, which is made when it has something to do. */
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

        /** Has it look for work, unless it does so now. */
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

        /** Sleeps; false when nobody has waked it for long, and it is gone. */
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
