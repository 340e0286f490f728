// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import org.python.core.Py;
import org.python.core.PyException;

/**
 * Passes caught out-of-memory errors to the default handler of uncaught exceptions ({@link
 * Thread#setDefaultUncaughtExceptionHandler}), as if they had ended a thread. Any thread.
 */
public final class OutOfMemory {
    private OutOfMemory() {
    }

    /** Reports an exception of a called method if it, or one of its causes, is an out-of-memory error. */
    public static void report(Throwable thrown) {
        for (Throwable at = thrown; at != null; at = at.getCause() == at ? null : at.getCause()) {
            if (at instanceof OutOfMemoryError) {
                reportWatcher((OutOfMemoryError) at);
                return;
            }
        }
    }

    /** Reports an exception of a script if it is Python's MemoryError or Java's out-of-memory error. */
    public static void report(PyException raised) {
        if (raised.match(Py.MemoryError)) {
            reportWatcher(new OutOfMemoryError("in a script: " + raised.value));
            return;
        }
        Object java = raised.value == null ? Py.NoConversion : raised.value.__tojava__(Throwable.class);
        report(java == Py.NoConversion ? raised.getCause() : (Throwable) java);
    }

    private static void reportWatcher(OutOfMemoryError error) {
        Thread.UncaughtExceptionHandler watcher = Thread.getDefaultUncaughtExceptionHandler();
        if (watcher != null) {
            watcher.uncaughtException(Thread.currentThread(), error);
        }
    }
}
