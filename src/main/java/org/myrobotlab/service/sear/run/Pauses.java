// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.SEAR.grammar.ScriptLine;
import org.myrobotlab.service.sear.Host;

/**
 * The pause of a simulation: whether one is active, which thread and script line started it, and which threads wait for
 * its end. Any thread.
 */
final class Pauses {
    private static final long LOOK_MILLIS = 200;
    /** Waiting time after which the waiting script gets a warning, ns. */
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

    /** Starts a pause on behalf of the present thread. */
    synchronized void begin() {
        paused = true;
        pauser = Thread.currentThread();
        line = ScriptLine.here();
        reported = false;
    }

    /** Ends the pause. */
    synchronized void end() {
        paused = false;
        pauser = null;
        line = "";
        notifyAll();
    }

    /** Releases all waiting threads at the end of the simulation. */
    synchronized void close() {
        ended = true;
        notifyAll();
    }

    boolean isPaused() {
        return paused;
    }

    /**
     * Checks that the present thread may wait for time to pass.
     *
     * @throws IllegalStateException if this thread has paused the simulation in a script, so that nothing would end the
     *     pause
     */
    synchronized void checkSleep() {
        if (paused && pauser == Thread.currentThread() && !line.isEmpty()) {
            throw new IllegalStateException("the simulation is paused by " + line + ": call sear.resume() first");
        }
    }

    /** Waits for the end of a pause while the caller still needs to wait. */
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
            host.warn(ScriptLine.added("simSleep waits because the simulation is paused"
                + (line.isEmpty() ? "" : " by " + line)
                + ": continue with Resume in SEAR's tab, P in the window or sear.resume()", ScriptLine.here()));
        }
    }

    /** A thread that waits for time to pass. That thread only. */
    final class Sleeper {
        private long since = Long.MIN_VALUE;

        /** Checks how long time has stood still; call repeatedly while waiting. */
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
