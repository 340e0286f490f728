// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.junit.Test;

/** Due times of steps, and the elapsed fraction between two of them, by a clock that the test sets. */
public class PaceTest {
    private static final long STEP = 16_666_666;
    private final Pace pace = new Pace();

    @Test
    public void stepsKeepToTheClockAndCatchUpShortDelays() {
        assertTrue("the first at once", pace.isDue(1000, 1));
        assertFalse(pace.isDue(1000, 1));
        assertFalse(pace.isDue(999 + STEP, 1));
        assertTrue(pace.isDue(1000 + STEP, 1));
        long late = 1000 + 5 * STEP;
        for (int caughtUp = 0; caughtUp < 4; caughtUp++) {
            assertTrue(pace.isDue(late, 1));
        }
        assertFalse(pace.isDue(late, 1));
    }

    @Test
    public void aLongDelayIsNotCaughtUp() {
        assertTrue(pace.isDue(0, 1));
        assertTrue(pace.isDue(10_000_000_000L, 1));
        assertFalse(pace.isDue(10_000_000_000L, 1));
    }

    @Test
    public void aNewPaceCountsFromNow() {
        assertTrue(pace.isDue(0, 1));
        pace.restart();
        assertTrue(pace.isDue(1, 10));
        assertFalse(pace.isDue(1, 10));
        assertTrue(pace.isDue(1 + STEP / 10, 10));
        assertTrue(pace.isDue(2 + STEP / 10, Double.POSITIVE_INFINITY));
        assertTrue(pace.isDue(2 + STEP / 10, Double.POSITIVE_INFINITY));
    }

    @Test
    public void partsOfAStepAreThoseOfItsTime() {
        assertTrue(pace.isDue(0, 0.5));
        assertFalse(pace.isDue(0, 0.5));
        assertEquals("never the step's own moment", 1, pace.part(0));
        assertEquals("what was written in the step before", 1, pace.part(-STEP));
        assertEquals(64, pace.part(STEP / 2 + 100));
        assertEquals(128, pace.part(STEP + 100));
        assertEquals(255, pace.part(2 * STEP - 1));
        assertEquals(255, pace.part(3 * STEP));
        assertEquals(0.25 * STEP, pace.waitFor(160, STEP), 1000);
        assertEquals("until the next step", STEP, pace.waitFor(Simulation.PARTS, STEP), 1000);
        assertEquals(STEP / 128, pace.waitFor(129, STEP), 1000);
        assertTrue("not beyond the step", pace.waitFor(129, 2 * STEP - 5) <= 10);
        pace.restart();
        assertTrue(pace.isDue(0, 10));
        assertFalse(pace.isDue(0, 10));
        assertEquals("not all that the processor does", 100_000, pace.waitFor(2, 0), 0);
    }
}
