package org.myrobotlab.service.sear.run;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/** Whether time stands still because somebody wants it, who that is, and who waits for the end of it. Any thread. */
final class Pauses {
    private static final long LOOK_MILLIS = 200;
    /** Who has waited so long hears for what. */
    private static final long WORD = TimeUnit.SECONDS.toNanos(2);

    private final Host host;
    private volatile boolean paused;
    private boolean ended;
    private Thread pauser;
    private String line = "";
    private boolean reported;

    Pauses(Host host) {
        this.host = host;
    }

    /** The present thread wants time to stand still. */
    synchronized void begin() {
        paused = true;
        pauser = Thread.currentThread();
        line = ScriptLine.here();
        reported = false;
    }

    /** Time may pass again. */
    synchronized void end() {
        paused = false;
        pauser = null;
        line = "";
        notifyAll();
    }

    /** The simulation ends: nobody waits any more. */
    synchronized void close() {
        ended = true;
        notifyAll();
    }

    boolean isPaused() {
        return paused;
    }

    /**
     * Before the present thread waits for time to pass.
     *
     * @throws IllegalStateException if it has paused the simulation itself, in a script: nobody would end that
     */
    synchronized void checkSleep() {
        if (paused && pauser == Thread.currentThread() && !line.isEmpty()) {
            throw new IllegalStateException("simulated time stands still since " + line + " has paused it: sear.resume() first");
        }
    }

    /** Waits for the end of a pause, as long as the caller has to. */
    synchronized void await(BooleanSupplier waits) throws InterruptedException {
        Sleeper sleeper = new Sleeper();
        while (paused && !ended && waits.getAsBoolean()) {
            wait(LOOK_MILLIS);
            sleeper.look(paused);
        }
    }

    private synchronized void report() {
        if (!reported && !ended) {
            reported = true;
            host.warn(ScriptLine.added("simSleep waits, for the simulation is paused" + (line.isEmpty() ? "" : " by " + line)
                + ": Resume in SEAR's tab, P in the window or sear.resume() lets time pass", ScriptLine.here()));
        }
    }

    /** One who waits for time to pass; its thread. */
    final class Sleeper {
        private long since = Long.MIN_VALUE;

        /** Called again and again meanwhile. */
        void look(boolean standing) {
            if (!standing) {
                since = Long.MIN_VALUE;
            } else if (since == Long.MIN_VALUE) {
                since = System.nanoTime();
            } else if (System.nanoTime() - since > WORD) {
                report();
            }
        }
    }
}
