// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import org.SEAR.geometry.TimeStep;

/**
 * Due times of a rate: the first one is the first question, the n-th one n periods later. A question finds at most one
 * of them. One thread at a time.
 */
final class Schedule {
    private final double rate;
    private Object run;
    private double start;
    private double last;
    private long done;

    /** @param rate Hz, above 0 */
    Schedule(double rate) {
        this.rate = rate;
    }

    /**
     * Returns whether a due time has come since the last question; restarts in another run and after a reset.
     *
     * @param session identity of the run
     * @param now simulated seconds
     */
    boolean isDue(Object session, double now) {
        boolean restarted = session != run || now < last;
        if (restarted) {
            run = session;
            start = now;
        }
        last = now;
        long periods = TimeStep.periods(now - start, rate);
        boolean due = restarted || periods > done;
        done = periods;
        return due;
    }
}
