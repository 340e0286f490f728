// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;

/**
 * Detects a script that queries SEAR in a loop. Counts the script's processor time, so a busy computer changes nothing.
 * Loading, drawing and computing are no loop, because they do not query SEAR all the time. One thread.
 */
final class WaitingLoop {
    /** Processor time of a loop that is reported, ns. */
    private static final long LOOP_NANOS = TimeUnit.SECONDS.toNanos(2);
    /** Processor time without a query that ends a loop, ns. */
    private static final long WORK_NANOS = TimeUnit.MILLISECONDS.toNanos(150);
    /** Most distinct lines of a loop; a script that computes much shows more. */
    private static final int MOST_LINES = 12;
    private static final int LEAST_LOOKS = 10;

    private final Set<String> lines = new TreeSet<>();
    private int looks;
    private long start;
    private long thread;
    private long queries;
    private long queried;

    /**
     * Adds an observation of the script.
     *
     * @param line of the script
     * @param id of its thread
     * @param processor time of the thread, ns
     * @param count of all queries of scripts so far
     * @return whether the script is a loop
     */
    boolean look(String line, long id, long processor, long count) {
        if (count != queries || looks == 0 || id != thread) {
            queries = count;
            queried = processor;
        }
        lines.add(line);
        if (looks == 0 || id != thread || lines.size() > MOST_LINES || processor - queried > WORK_NANOS) {
            end();
            lines.add(line);
            start = processor;
            thread = id;
        }
        looks++;
        return looks > LEAST_LOOKS && processor - start > LOOP_NANOS;
    }

    /** Forgets the loop: the script waits, advances time, or has ended. */
    void end() {
        lines.clear();
        looks = 0;
    }
}
