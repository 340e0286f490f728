// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.bundle;

import java.nio.file.Path;
import java.util.Locale;
import java.util.function.Consumer;

/**
 * Reports the progress of saving or loading in words, at every tenth:
 * {@code loading robot.sear: 40 % of 120 MB (assets/hall.glb)}. Small projects are too fast for a report.
 */
public final class PercentProgress implements Progress {
    /** Projects smaller than this are not reported, bytes. */
    static final long LARGE = 8 << 20;
    private static final int TENTHS = 10;
    private static final double MEGABYTE = 1 << 20;

    private final String what;
    private final Consumer<String> listener;
    private long reported;

    /**
     * @param what the operation, for example "loading"
     * @param listener called on the thread that saves or loads
     */
    public PercentProgress(String what, Path bundle, Consumer<String> listener) {
        this.what = what + " " + bundle.getFileName();
        this.listener = listener;
    }

    @Override
    public void at(String file, long done, long total) {
        if (total < LARGE) {
            return;
        }
        long tenths = TENTHS * done / total;
        if (tenths > reported) {
            reported = tenths;
            listener.accept(String.format(Locale.ROOT, "%s: %d %% of %.0f MB (%s)", what, tenths * TENTHS,
                total / MEGABYTE, file));
        }
    }

    @Override
    public void said(String line) {
        listener.accept(line);
    }
}
