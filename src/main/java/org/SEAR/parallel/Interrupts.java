// SPDX-License-Identifier: Apache-2.0
package org.SEAR.parallel;

import java.util.concurrent.CancellationException;

/** Ends long computations of an interrupted thread, such as that of a Python 3 program after Ctrl+C. Any thread. */
public final class Interrupts {
    private Interrupts() {
    }

    /**
     * Does nothing unless this thread is interrupted. The interrupt stays set.
     *
     * @throws CancellationException if it is
     */
    public static void check() {
        if (Thread.currentThread().isInterrupted()) {
            throw new CancellationException("interrupted");
        }
    }
}
