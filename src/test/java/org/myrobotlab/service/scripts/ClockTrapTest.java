// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.scripts;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;

/** SEAR warns once about a script that waits by the computer's clock in lock-step. */
public class ClockTrapTest {
    private static final String SLEEP = "from java.util.concurrent import TimeUnit\nimport time\n"
        + "end = time.time() + 60\nwhile not %s and time.time() < end: TimeUnit.MILLISECONDS.sleep(400)\n";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private SEAR sear;
    private Heard heard;
    private Python python;

    @Before
    public void start() {
        System.setProperty("sear.headless", "true");
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("python", "Python");
        sear = (SEAR) Runtime.start("sear", "SEAR");
        heard = (Heard) Runtime.start("searStatus", "Heard");
        sear.addListener("publishStatus", "searStatus", "onStatus");
        python.set("heard", heard);
        python.set("sear", sear); // the service also sets it, but some time after the start
    }

    @After
    public void release() {
        for (String name : new String[] {"sear", "searStatus", "python"}) {
            Runtime.releaseService(name);
        }
        System.clearProperty("sear.project");
    }

    private long warnings() {
        return heard.getStatuses().stream().filter(one -> one.contains("the script waits by the computer's clock")
            && one.contains("sear.simSleep(seconds)")).count();
    }

    @Test
    public void aSleepWithoutSimulatedTimeIsReportedOnce() throws Exception {
        sear.setLockStep(true);
        sear.startSimulation();
        assertTrue(python.exec(String.format(
            SLEEP, "heard.getStatuses().toString().count(\"by the computer's clock\")")));
        assertEquals(1, warnings());
        assertTrue(python.exec("from java.util.concurrent import TimeUnit\nTimeUnit.MILLISECONDS.sleep(700)"));
        assertEquals(1, warnings());
    }

    @Test
    public void aLoopWithoutSimulatedTimeIsReportedOnceWithItsLine() throws Exception {
        sear.setLockStep(true);
        sear.startSimulation();
        assertTrue(String.valueOf(python.getLastError()), python.exec("import time\nend = time.time() + 60\n"
            + "while sear.getTime() < 5 and not heard.getStatuses().toString().count('busy at') and time.time() < "
                + "end:\n    pass\n"));
        String said = heard.getStatuses().stream().filter(one -> one.contains("busy at")).findFirst().orElse("nothing");
        assertTrue(said, said.contains("simulated time has stood still for 2 s while the script is busy at line "
            + "3 of <script>") || said.contains("busy at line 4 of <script>"));
        assertTrue(said, said.contains("sear.simSleep(seconds)"));
    }

    @Test
    public void anObjectMadeInLockStepAppearsAfterTheNextStart() throws Exception {
        sear.startSimulation();
        new Box("late", 1, 1, 1, 0);
        assertTrue(heard.awaitStatus("Box \"late\" was made while a simulation runs"));
        sear.stopSimulation();
        new Box("early", 1, 1, 1, 0);
        assertTrue(heard.getStatuses().stream().noneMatch(one -> one.contains("early")));
    }
}
