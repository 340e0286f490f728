// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.util.Locale;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Reports the progress of long work, such as reading a large model, to the listener of the thread that waits for it:
 * after two seconds of the computer's clock, then each time the duration has doubled. One thread.
 */
public final class LongWork {
    private static final ThreadLocal<Consumer<String>> LISTENERS = new ThreadLocal<>();
    private static final long FIRST = TimeUnit.SECONDS.toNanos(2);

    private final String what;
    private final LongSupplier nanoTime;
    private final long start;
    private long next = FIRST;

    /** @param what the work, as {@code model tree: reading tree.blend} */
    public LongWork(String what) {
        this(what, System::nanoTime);
    }

    LongWork(String what, LongSupplier nanoTime) {
        this.what = what;
        this.nanoTime = nanoTime;
        start = nanoTime.getAsLong();
    }

    /**
     * Sets the calling thread's listener.
     *
     * @param listener called on this thread
     * @return restores the listener before, on this thread
     */
    public static Runnable listen(Consumer<String> listener) {
        Consumer<String> before = LISTENERS.get();
        LISTENERS.set(listener);
        return () -> LISTENERS.set(before);
    }

    /** Returns the time to the next report, nanoseconds, at least one millisecond. */
    public long untilReport() {
        return Math.max(TimeUnit.MILLISECONDS.toNanos(1), next - (nanoTime.getAsLong() - start));
    }

    /** Reports if a report is due, without a share. */
    public void report() {
        report(Double.NaN);
    }

    /** @param share of the work that is done, 0 to 1; NaN if unknown */
    public void report(double share) {
        long elapsed = nanoTime.getAsLong() - start;
        Consumer<String> listener = LISTENERS.get();
        if (elapsed < next || listener == null) {
            return;
        }
        while (next <= elapsed) {
            next *= 2;
        }
        String done = Double.isNaN(share) ? "" : String.format(Locale.ROOT, " %.0f %%,", 100 * share);
        listener.accept(String.format(Locale.ROOT, "%s:%s %d s so far", what, done,
            TimeUnit.NANOSECONDS.toSeconds(elapsed)));
    }
}
