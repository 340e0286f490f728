// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;

import java.util.Map;
import org.junit.Test;

/** Detection of the script line that loops while waiting for simulated time. */
public class BusyLineTest {
    private static final StackTraceElement SCRIPT = new StackTraceElement("org.python.pycode._pyx1", "f$0", "drive.py", 12);

    private static String line(StackTraceElement... stack) {
        return ClockTrap.busyLine(Map.of(Thread.currentThread(), stack));
    }

    private static StackTraceElement call(String method) {
        return new StackTraceElement("org.myrobotlab.service.SEAR", method, "SEAR.java", 1);
    }

    @Test
    public void repeatedQueriesAreALoop() {
        assertEquals("line 12 of drive.py", line(SCRIPT));
        assertEquals("line 12 of drive.py", line(call("getTime"), SCRIPT));
    }

    @Test
    public void longCallsAreNotALoop() {
        for (String method : new String[] {"step", "simSleep", "startSimulation", "loadProject", "rerunRecord"}) {
            assertNull(method, line(call("lambda$" + method + "$0"), call(method), SCRIPT));
        }
    }
}
