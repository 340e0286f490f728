// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.SEAR.simulator.Simulation;
import org.junit.Test;

/** Rates of published readings. */
public class ScheduleTest {
    private static final int STEPS = 6000;

    /** The 7, 25, 40 and 59 among them. */
    @Test
    public void theMeanOverAHundredSecondsIsTheRate() {
        for (double rate : new double[] {0.1, 0.3, 1, 3, 7, 9.9, 10, 12.5, 25, 29.97, 30, 40, 45, 50, 59, 59.9, 60}) {
            for (int first : new int[] {0, 1, 17}) {
                Schedule schedule = new Schedule(rate);
                int count = 0;
                for (int step = first; step <= first + STEPS; step++) {
                    if (schedule.isDue("run", step * Simulation.STEP)) {
                        double due = first * Simulation.STEP + count / rate;
                        double late = step * Simulation.STEP - due;
                        assertTrue(rate + " Hz: late by " + late, late > -1e-6 && late < Simulation.STEP + 1e-6);
                        count++;
                    }
                }
                assertEquals(rate + " Hz", Math.floor(100 * rate + 1e-6) + 1, count, 0);
            }
        }
    }

    @Test
    public void aQuestionFindsOneDueTime() {
        Schedule schedule = new Schedule(10);
        assertTrue(schedule.isDue("run", 1));
        assertFalse(schedule.isDue("run", 1));
        assertTrue(schedule.isDue("run", 1.35));
        assertFalse(schedule.isDue("run", 1.39));
        assertTrue(schedule.isDue("run", 1.4));
    }

    @Test
    public void aResetAndAnotherRunBeginAgain() {
        Schedule schedule = new Schedule(1);
        assertTrue(schedule.isDue("run", 0.5));
        assertFalse(schedule.isDue("run", 1.4));
        assertTrue("reset", schedule.isDue("run", 0.3));
        assertFalse(schedule.isDue("run", 1.2));
        assertTrue("another run", schedule.isDue("other", 1.25));
        assertFalse(schedule.isDue("other", 2.2));
        assertTrue(schedule.isDue("other", 2.25));
    }
}
