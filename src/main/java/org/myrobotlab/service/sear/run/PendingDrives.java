// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.SEAR.grammar.ScriptLine;

/**
 * A script's drive commands and whether simulated time has passed to run them. Times are simulated seconds that a reset
 * does not set back. Any thread.
 */
final class PendingDrives {
    /** A simulation that ends within this time after a robot's first command has not run it, s. */
    private static final double AT_ONCE = 0.1;
    /**
     * Simulated time, s, that may pass before a script's next line if a busy machine runs the simulation by the clock.
     */
    private static final double NEXT_LINE = 0.25;
    /**
     * Delay of the report about a command without time, s. If its line runs again meanwhile, it belongs to a loop and
     * is not reported.
     */
    private static final double UNTIL_REPORTED = 1;
    /** Time after a script's drive command in which the window's keys don't drive the robot, ns. */
    private static final long SCRIPT_DRIVES = TimeUnit.SECONDS.toNanos(1);

    /** Last command by robot. */
    private final Map<String, Order> last = new HashMap<>();
    private final Map<String, Order> first = new HashMap<>();
    /** Lines of commands so far. Those in ofLoops were in force while time passed, or ran more than once. */
    private final Set<String> lines = new HashSet<>();
    private final Set<String> ofLoops = new HashSet<>();
    /** The first command that a later one replaced before time passed; null if none did. */
    private Order lost;
    private Order next;
    private volatile boolean driven;
    private volatile long lastDriven;

    /** A drive command. */
    static final class Order {
        final String call;
        final String values;
        final boolean moves;
        final double time;
        final long sleeps;
        final String line = ScriptLine.here();
        private final long thread = Thread.currentThread().getId();

        /**
         * Creates a command of the present thread, given now.
         *
         * @param call the method's name
         * @param values its arguments
         * @param moves whether it starts the robot
         * @param sleeps how often any thread has advanced time
         */
        Order(String call, String values, boolean moves, double time, long sleeps) {
            this.call = call;
            this.values = values;
            this.moves = moves;
            this.time = time;
            this.sleeps = sleeps;
        }

        /**
         * Returns whether a command of the same thread replaces this one before time passes. Commands of other threads
         * don't count: their timing depends on the machine.
         */
        boolean isReplacedAtOnceBy(Order next) {
            return thread == next.thread && moves && !line.isEmpty() && !next.line.isEmpty() && sleeps == next.sleeps
                && next.time - time < NEXT_LINE && !(call + values).equals(next.call + next.values);
        }
    }

    /** Records that a script has moved a robot. */
    void touch() {
        lastDriven = System.nanoTime();
        driven = true;
    }

    /** Returns whether a script has moved a robot recently, by the computer's clock. */
    boolean areRecent() {
        return driven && System.nanoTime() - lastDriven < SCRIPT_DRIVES;
    }

    /** Records a command to a robot. */
    synchronized void give(String robot, Order order) {
        Order former = last.put(robot, order);
        if (!lines.add(order.line)) {
            ofLoops.add(order.line);
        }
        if (former != null && former.isReplacedAtOnceBy(order)) {
            if (lost == null) {
                lost = former;
                next = order;
            }
        } else if (former != null && former.time < order.time) {
            ofLoops.add(former.line);
        }
        Order begin = first.get(robot);
        if (order.moves) {
            first.putIfAbsent(robot, order);
        } else if (begin != null && order.time - begin.time < NEXT_LINE) {
            first.remove(robot);
        }
    }

    /** Forgets the robots' commands after a reset. */
    synchronized void reset() {
        last.clear();
        first.clear();
    }

    /**
     * Returns a warning about a command that the next one replaced before it could run.
     *
     * @param ends whether the simulation ends
     * @return the warning, once; empty if there is none, or if it is too early
     */
    synchronized String replaced(double time, boolean ends) {
        if (lost == null || next == null || !ends && time - next.time < UNTIL_REPORTED) {
            return "";
        }
        boolean isOfLoop = ofLoops.contains(lost.line);
        String said = isOfLoop ? "" : "the " + lost.call + " of " + lost.line + " had no time to act: the " + next.call
            + " of " + next.line + " replaced it immediately; put sear.simSleep(seconds) between them";
        lost = isOfLoop ? null : lost;
        next = null;
        return said;
    }

    /**
     * Returns the line of a robot's first command if it came so late that the robot has not moved at the end.
     *
     * @param time of the end
     * @return null if there is no such command
     */
    synchronized String tooLate(double time) {
        return first.values().stream().filter(order -> time - order.time < AT_ONCE).map(order -> order.line).findFirst()
            .orElse(null);
    }
}
