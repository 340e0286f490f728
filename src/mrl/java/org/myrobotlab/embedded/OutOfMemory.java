package org.myrobotlab.embedded;

import org.python.core.Py;
import org.python.core.PyException;

/**
 * Errors of a memory that has run out, where they are caught and become a message: whoever watches the end of threads
 * ({@link Thread#setDefaultUncaughtExceptionHandler}) is told of them as if they had ended one. Any thread.
 */
public final class OutOfMemory {
    private OutOfMemory() {
    }

    /** Tells of what a called method has thrown, if it or what caused it is such an error. */
    public static void report(Throwable thrown) {
        for (Throwable at = thrown; at != null; at = at.getCause() == at ? null : at.getCause()) {
            if (at instanceof OutOfMemoryError) {
                reportWatcher((OutOfMemoryError) at);
                return;
            }
        }
    }

    /** Tells of what a script has raised: Python's MemoryError or Java's error. */
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
