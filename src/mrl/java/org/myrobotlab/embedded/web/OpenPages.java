package org.myrobotlab.embedded.web;

import java.io.IOException;
import java.io.InputStream;
import java.util.concurrent.TimeUnit;

/**
 * How many pages browsers have open, of all web servers of this process; and a script's waiting for the last one to go:
 * {@code OpenPages.stay(True, 5)}. Any thread.
 */
public final class OpenPages {
    private static final Object LOCK = new Object();
    private static int count;

    private OpenPages() {
    }

    /** One has connected. */
    static void come() {
        change(1);
    }

    /** One has gone. */
    static void go() {
        change(-1);
    }

    private static void change(int by) {
        synchronized (LOCK) {
            count += by;
            LOCK.notifyAll();
        }
    }

    /** How many are open. */
    public static int count() {
        synchronized (LOCK) {
            return count;
        }
    }

    /**
     * Waits until the last page has gone, at a terminal also until Enter. Returns at once if no page is open and nobody sits at a terminal, who could
     * open one.
     *
     * @param atTerminal whether somebody sits at one; nobody does any more when its input has ended
     * @param grace seconds after which a page that has gone was closed, not loaded again
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

    /** Reads a terminal on a thread of its own, for nothing ends a read there; guarded by {@link #LOCK}. */
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
