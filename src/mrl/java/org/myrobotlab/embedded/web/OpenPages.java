// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.web;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.TimeUnit;

/**
 * Counts the pages open in browsers, for all web servers of this process. A script can wait for the last one to close:
 * {@code OpenPages.stay(True, 5)}. Any thread.
 */
public final class OpenPages {
    private static final Object LOCK = new Object();
    private static int count;

    private OpenPages() {
    }

    /** Counts a page that has connected. */
    static void come() {
        change(1);
    }

    /** Counts a page that has closed. */
    static void go() {
        change(-1);
    }

    private static void change(int by) {
        synchronized (LOCK) {
            count += by;
            LOCK.notifyAll();
        }
    }

    /** Returns the number of open pages. */
    public static int count() {
        synchronized (LOCK) {
            return count;
        }
    }

    /**
     * Waits until the last page is closed, at a terminal also until Enter. Returns immediately if no page is open and
     * no terminal is attached.
     *
     * @param atTerminal whether to read from a terminal; the end of its input counts as none
     * @param grace seconds after which a page counts as closed, not as reloading
     */
    public static void stay(boolean atTerminal, double grace) throws InterruptedException {
        stay(atTerminal ? System.in : InputStream.nullInputStream(), grace);
    }

    static void stay(InputStream terminal, double grace) throws InterruptedException {
        long timeout = (long) (grace * TimeUnit.SECONDS.toNanos(1));
        Enter enter = new Enter(terminal);
        synchronized (LOCK) {
            boolean hadPages = false;
            long left = System.nanoTime();
            while (!enter.isPressed) {
                if (count > 0) {
                    hadPages = true;
                    LOCK.wait();
                    left = System.nanoTime();
                } else if (hadPages) {
                    long more = left + timeout - System.nanoTime();
                    if (more <= 0) {
                        return;
                    }
                    TimeUnit.NANOSECONDS.timedWait(LOCK, more);
                } else if (!enter.isOver) {
                    LOCK.wait();
                } else {
                    return;
                }
            }
        }
    }

    /** Reads a terminal on its own thread, because such a read can't be interrupted; guarded by {@link #LOCK}. */
    private static final class Enter {
        private boolean isPressed;
        private boolean isOver;

        Enter(InputStream terminal) {
            Thread reader = new Thread(() -> read(terminal), "enter");
            reader.setDaemon(true);
            reader.start();
        }

        private void read(InputStream terminal) {
            int got;
            try {
                do {
                    got = terminal.read();
                } while (got >= 0 && got != '\n');
            } catch (IOException e) {
                got = -1;       // the terminal was closed
            }
            synchronized (LOCK) {
                isPressed = got >= 0;
                isOver = got < 0;
                LOCK.notifyAll();
            }
        }
    }
}
