// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.Map;
import org.junit.Test;

/** Detection of a script that loops while it waits for simulated time. */
public class BusyLineTest {
    private static final StackTraceElement SCRIPT = new StackTraceElement("org.python.pycode._pyx1", "f$0",
        "drive.py", 12);

    private static final long TENTH = 100_000_000;

    private static Thread busy(StackTraceElement... stack) {
        return ClockTrap.busy(Map.of(Thread.currentThread(), stack));
    }

    private static StackTraceElement call(String method) {
        return new StackTraceElement("org.myrobotlab.service.SEAR", method, "SEAR.java", 1);
    }

    @Test
    public void repeatedQueriesAreALoop() {
        assertEquals(Thread.currentThread(), busy(SCRIPT));
        assertEquals(Thread.currentThread(), busy(call("getTime"), SCRIPT));
    }

    @Test
    public void longCallsAreNotALoop() {
        for (String method : new String[] {"step", "simSleep", "startSimulation", "loadProject", "rerunRecord",
            "saveImage", "savePlan", "savePlot", "saveRecordCsv"}) {
            assertNull(method, busy(call("lambda$" + method + "$0"), call(method), SCRIPT));
        }
    }

    /** Returns the number of looks until a loop is found; 0 if there is none within 100. */
    private static int looks(long processorPerLook, int queriesPerLook, int lines) {
        WaitingLoop loop = new WaitingLoop();
        for (int i = 1; i <= 100; i++) {
            if (loop.look("line " + i % lines, 1, i * processorPerLook, (long) i * queriesPerLook)) {
                return i;
            }
        }
        return 0;
    }

    @Test
    public void twoSecondsOfItsOwnProcessorTimeAreALoop() {
        assertEquals(22, looks(TENTH, 5, 2));
        assertEquals("on a busy computer it takes longer", 42, looks(TENTH / 2, 1, 2));
        assertEquals("a script that does not run", 0, looks(0, 0, 1));
    }

    @Test
    public void computingLoadingAndDrawingAreNoLoop() {
        assertEquals("without queries", 0, looks(TENTH, 0, 2));
        assertEquals("in many lines", 0, looks(TENTH, 5, 30));
        WaitingLoop loop = new WaitingLoop();
        for (int i = 0; i < 100; i++) {
            assertFalse("a query now and then", loop.look("line 1", 1, i * TENTH, i / 4));
        }
    }

    @Test
    public void aLoopEndsWhenTimeGoesOn() {
        WaitingLoop loop = new WaitingLoop();
        for (int i = 0; i < 50; i++) {
            if (i % 15 == 0) {
                loop.end();
            }
            assertFalse(loop.look("line 1", 1, i * TENTH, i));
        }
        boolean found = false;
        for (int i = 50; i < 80; i++) {
            found |= loop.look("line 1", 1, i * TENTH, i);
        }
        assertTrue(found);
    }
}
