package org.myrobotlab.service.sear.run;

import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import org.SEAR.grammar.ScriptLine;

/**
 * The orders to drive that a script has given, and whether simulated time has passed for them to be obeyed. Times are simulated seconds that a reset
 * does not take back. Any thread.
 */
final class PendingDrives {
    /** A simulation that ends so soon after a robot's first order has not obeyed it, s. */
    private static final double AT_ONCE = 0.1;
    /** Within so much time, by the clock, a script comes to its next line on a busy machine, s. */
    private static final double NEXT_LINE = 0.25;
    /** After so long an order that had no time is told, unless its line was carried out again: then it is a loop's, s. */
    private static final double UNTIL_REPORTED = 1;
    /** The window's keys leave a robot alone so long after a script has driven it. */
    private static final long SCRIPT_DRIVES = TimeUnit.SECONDS.toNanos(1);

    /** By robot. */
    private final Map<String, Order> last = new HashMap<>();
    private final Map<String, Order> first = new HashMap<>();
    /** Lines whose orders were in force while time passed, or that were carried out more than once. */
    private final Set<String> lines = new HashSet<>();
    private final Set<String> ofLoops = new HashSet<>();
    /** The first order that had no time, by the next one; null before. */
    private Order lost;
    private Order next;
    private volatile boolean driven;
    private volatile long lastDriven;

    /** One order. */
    static final class Order {
        final String call;
        final String values;
        final boolean moves;
        final double time;
        final long sleeps;
        final String line = ScriptLine.here();
        private final long thread = Thread.currentThread().getId();

        /**
         * One that is given now, by the present thread.
         *
         * @param call the method's name
         * @param values those that it was given
         * @param moves whether it sets the robot going
         * @param sleeps how often anybody has let time pass
         */
        Order(String call, String values, boolean moves, double time, long sleeps) {
            this.call = call;
            this.values = values;
            this.moves = moves;
            this.time = time;
            this.sleeps = sleeps;
        }

        /** By the same thread: when another one comes is not for the script to say, and a busy machine lets it come early or late. */
        boolean isReplacedAtOnceBy(Order next) {
            return thread == next.thread && moves && !line.isEmpty() && !next.line.isEmpty() && sleeps == next.sleeps && next.time - time < NEXT_LINE
                && !(call + values).equals(next.call + next.values);
        }
    }

    /** A script has told some robot to move. */
    void touch() {
        lastDriven = System.nanoTime();
        driven = true;
    }

    /** Whether a script has told a robot to move lately, by the computer's clock. */
    boolean areRecent() {
        return driven && System.nanoTime() - lastDriven < SCRIPT_DRIVES;
    }

    /** A robot was given an order. */
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

    /** Everything is back at the start. */
    synchronized void reset() {
        last.clear();
        first.clear();
    }

    /**
     * What to say of an order that the next one has replaced before it could be obeyed.
     *
     * @param ends whether the simulation ends
     * @return once; empty if there is nothing to say, or it is too early
     */
    synchronized String replaced(double time, boolean ends) {
        if (lost == null || next == null || !ends && time - next.time < UNTIL_REPORTED) {
            return "";
        }
        boolean isOfLoop = ofLoops.contains(lost.line);
        String said = isOfLoop ? "" : "the " + lost.call + " of " + lost.line + " had no time to act, for the " + next.call + " of " + next.line
            + " has replaced it at once: sear.simSleep(seconds) between them";
        lost = isOfLoop ? null : lost;
        next = null;
        return said;
    }

    /**
     * The line of the first order to a robot, if that has come so late that the robot has not moved when the simulation ends.
     *
     * @param time of the end
     * @return null if there is no such robot
     */
    synchronized String tooLate(double time) {
        return first.values().stream().filter(order -> time - order.time < AT_ONCE).map(order -> order.line).findFirst().orElse(null);
    }
}
