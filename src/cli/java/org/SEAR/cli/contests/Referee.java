// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.contests;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.embedded.python.ScriptResult;

/**
 * The referee.py of a contest, in an interpreter separate from the entrants' scripts. It runs on its own thread, which
 * the contest abandons if it hangs.
 */
final class Referee {
    private static final double MAX_SECONDS = 3600;
    private static final String STEPPED = "stepped";
    private static final long GRACE_MILLIS = 2000;
    private static final long KNOCK_MILLIS = 20;

    private final Path file;
    private final ByteArrayOutputStream printed = new ByteArrayOutputStream();
    private final PythonEngine engine;
    private final double timeout;
    private final double seconds;
    private final ExecutorService thread = Executors.newSingleThreadExecutor(work -> {
        Thread one = new Thread(work, "referee");
        one.setDaemon(true);
        return one;
    });

    /**
     * Runs the file, which defines the functions.
     *
     * @param patience time limit of the file and of each function, by the computer's clock, s
     * @throws IOException if the file has an error or lacks a part
     */
    Referee(Path file, double patience) throws IOException, InterruptedException {
        this.file = file;
        this.timeout = patience;
        engine = new PythonEngine("referee of " + file, printed, printed);
        await("it", () -> engine.runFile(file.toString()));
        Object limit = engine.get("SECONDS");
        if (!engine.has(STEPPED) || !(limit instanceof Number)) {
            throw new IOException(file + " lacks " + (engine.has(STEPPED) ? "SECONDS, the simulated time of the contest"
                : "the function stepped(contest)"));
        }
        seconds = ((Number) limit).doubleValue();
        if (!(seconds > 0 && seconds <= MAX_SECONDS)) {
            throw new IOException(file + ": SECONDS is " + seconds + ", legal: above 0 to " + MAX_SECONDS);
        }
    }

    private void await(String what, Callable<ScriptResult> work) throws IOException, InterruptedException {
        Future<ScriptResult> result = thread.submit(work);
        try {
            checked(result.get((long) (timeout * TimeUnit.SECONDS.toNanos(1)), TimeUnit.NANOSECONDS));
        } catch (TimeoutException e) {
            breakOff();
            throw new IOException(String.format(Locale.ROOT, "%s hung: %s ran for %.3g s, legal: at most --limit, by "
                + "the computer's clock", file, what, timeout), e);
        } catch (ExecutionException e) {
            throw e.getCause() instanceof IOException ? (IOException) e.getCause()
                : new IOException(file + " can't be run: " + e.getCause(), e);
        }
    }

    /** Interrupts the referee repeatedly; abandons its thread if it does not end in time. */
    private void breakOff() throws InterruptedException {
        thread.shutdown();
        long until = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(GRACE_MILLIS);
        while (!thread.awaitTermination(KNOCK_MILLIS, TimeUnit.MILLISECONDS) && System.nanoTime() < until) {
            engine.interrupt();
        }
    }

    private void checked(ScriptResult result) throws IOException {
        if (result.getExitCode() != 0 && result.getTraceback() == null) {
            throw new IOException(file + " ended itself with status " + result.getExitCode()
                + ", legal: contest.end(words)");
        }
        if (result.getTraceback() != null) {
            throw new IOException(file + " has an error, which is not an entrant's:\n" + result.getTraceback());
        }
    }

    /** Returns the time limit of the contest, simulated seconds. */
    double getSeconds() {
        return seconds;
    }

    /**
     * Calls a function of the referee, if it exists.
     *
     * @throws IOException with the error that it raises, or if it hangs
     */
    void call(String function, Contest contest) throws IOException, InterruptedException {
        if (engine.has(function)) {
            await(function + "(contest)", () -> engine.call(function, contest));
        }
    }

    /** Returns the output since the last call. */
    String takePrinted() {
        String text = new String(printed.toByteArray(), StandardCharsets.UTF_8);
        printed.reset();
        return text;
    }

    void close() {
        thread.shutdown();
        engine.close();
    }
}
