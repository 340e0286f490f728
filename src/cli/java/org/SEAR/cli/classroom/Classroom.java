// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.classroom;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.LocalTime;
import java.time.temporal.ChronoUnit;
import java.util.List;
import java.util.concurrent.TimeUnit;

/**
 * Starts the pupils' programs, a few at a time, and restarts programs that end, until it is ended itself. Any thread.
 */
final class Classroom {
    private static final int LOOK_MILLIS = 250;
    private static final long WEIGH_NANOS = TimeUnit.SECONDS.toNanos(3);
    private static final long END_NANOS = TimeUnit.SECONDS.toNanos(20);
    private static final int REPORTED_EACH = 10;

    private final List<Pupil> pupils;
    private final int atOnce;
    private final long most;
    private final PrintWriter out;
    private boolean isEnding;
    private boolean isComplete;
    private long reportedRunning;
    private long weighed = System.nanoTime();

    /**
     * @param atOnce number of programs that start at the same time
     * @param most memory limit of one program with its child processes, MB
     */
    Classroom(List<Pupil> pupils, int atOnce, long most, PrintWriter out) {
        this.pupils = pupils;
        this.atOnce = atOnce;
        this.most = most;
        this.out = out;
    }

    /** Supervises the programs until {@link #end}. */
    synchronized void run() throws InterruptedException {
        while (!isEnding) {
            look();
            wait(LOOK_MILLIS);
        }
    }

    private void look() {
        for (Pupil pupil : pupils) {
            pupil.look().ifPresent(what -> report(pupil, what));
        }
        if (System.nanoTime() - weighed > WEIGH_NANOS) {
            ProcessTable table = ProcessTable.now();
            pupils.forEach(pupil -> pupil.weigh(table, most));
            weighed = System.nanoTime();
        }
        long starting = count(Pupil.State.STARTING);
        for (Pupil pupil : pupils) {
            if (starting < atOnce && pupil.isDue()) {
                starting += start(pupil) ? 1 : 0;
            }
        }
        reportStart();
    }

    private boolean start(Pupil pupil) {
        try {
            pupil.start();
            return true;
        } catch (IOException e) {
            pupil.failed();
            report(pupil, e.getMessage());
            return false;
        }
    }

    private long count(Pupil.State state) {
        return pupils.stream().filter(pupil -> pupil.state() == state).count();
    }

    private void reportStart() {
        long running = count(Pupil.State.RUNNING);
        if (isComplete || running == reportedRunning) {
            return;
        }
        isComplete = running == pupils.size();
        if (isComplete) {
            out.println("All " + running + " are running. Enter shows their state, a name and Enter restarts one, "
                + "Ctrl+C ends all.");
        } else if (running % REPORTED_EACH == 0) {
            out.println(running + " of " + pupils.size() + " are running");
        }
        reportedRunning = running;
        out.flush();
    }

    private void report(Pupil pupil, String what) {
        out.println(LocalTime.now().truncatedTo(ChronoUnit.SECONDS) + " " + pupil.name + ": " + what);
        out.flush();
    }

    /** Handles a line of the teacher: a name, or nothing. */
    synchronized void hear(String line) {
        String wanted = line.trim();
        if (wanted.isEmpty()) {
            pupils.forEach(pupil -> out.println(String.format("%-30s %5d %-9s %5d MB", pupil.name, pupil.port,
                pupil.state().name().toLowerCase(java.util.Locale.ROOT).replace('_', ' '), pupil.megabytes())));
            out.println("total " + pupils.stream().mapToLong(Pupil::megabytes).sum() + " MB");
        } else if (pupils.stream().noneMatch(pupil -> pupil.name.equals(wanted))) {
            out.println("There is no pupil \"" + wanted + "\".");
        } else {
            pupils.stream().filter(pupil -> pupil.name.equals(wanted)).forEach(Pupil::renew);
        }
        out.flush();
    }

    /** Ends all programs and the processes that they started. */
    synchronized void end() {
        isEnding = true;
        notifyAll();
        pupils.forEach(Pupil::askToEnd);
        long deadline = System.nanoTime() + END_NANOS;
        try {
            for (Pupil pupil : pupils) {
                pupil.end(deadline);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }
}
