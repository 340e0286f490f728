// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import org.junit.Test;

/** When a script has run for too long. */
public class TimeLimitTest {
    private static final double LIMIT = 60;

    private final TimeLimit limit = new TimeLimit(LIMIT);

    /** Returns the first reason to stop a script that uses a share of a processor; null if there is none. */
    private String reason(double share, double seconds) {
        String reason = null;
        for (double time = 0; time <= seconds && reason == null; time += 0.5) {
            reason = limit.exceeded(time, share * time);
        }
        return reason;
    }

    @Test
    public void aScriptThatRarelyGetsAProcessorMayGoOn() {
        assertNull(reason(0.05, 9.9 * LIMIT));
    }

    @Test
    public void aComputingScriptIsStoppedByItsProcessorTime() {
        assertNull(limit.exceeded(2 * LIMIT, LIMIT));
        assertEquals("it used more than 60 s of processor time", limit.exceeded(2 * LIMIT, 1.01 * LIMIT));
    }

    @Test
    public void anIdleScriptIsStoppedByTheClock() {
        assertNull(reason(0.01, 0.99 * LIMIT));
        assertEquals("it did nothing for 60 s by the computer's clock", reason(0.01, 1.5 * LIMIT));
    }

    @Test
    public void aScriptThatComputesALittleIsStoppedByTheLongestTime() {
        assertEquals("it took more than 600 s by the computer's clock", reason(0.05, 11 * LIMIT));
    }
}
