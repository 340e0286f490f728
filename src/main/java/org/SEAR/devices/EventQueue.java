// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.PriorityQueue;
import java.util.function.DoubleConsumer;

/** Queue of a device's timed actions, ordered by time and then by insertion. Simulation thread only. */
public final class EventQueue {
    private final PriorityQueue<Entry> entries = new PriorityQueue<>();
    private long count;

    /**
     * Schedules an action; {@link #runUntil} runs it with its time.
     *
     * @param time simulated seconds
     */
    public void at(double time, DoubleConsumer action) {
        entries.add(new Entry(time, count++, action));
    }

    /** Runs the actions that are due up to and including {@code time}; actions may add more. */
    public void runUntil(double time) {
        while (!entries.isEmpty() && entries.peek().time <= time) {
            Entry entry = entries.remove();
            entry.action.accept(entry.time);
        }
    }

    /** Time of the next action, simulated seconds; infinity without any. */
    public double next() {
        return entries.isEmpty() ? Double.POSITIVE_INFINITY : entries.peek().time;
    }

    /** Removes all actions. */
    public void clear() {
        entries.clear();
    }

    private static final class Entry implements Comparable<Entry> {
        private final double time;
        private final long number;
        private final DoubleConsumer action;

        Entry(double time, long number, DoubleConsumer action) {
            this.time = time;
            this.number = number;
            this.action = action;
        }

        @Override
        public int compareTo(Entry other) {
            int order = Double.compare(time, other.time);
            return order != 0 ? order : Long.compare(number, other.number);
        }
    }
}
