// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.ProcessorTime;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/** The SEAR service and the clock. Tests check bounds that hold on a busy machine. */
@Category(Slow.class)
public class SearClockTest {
    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private SEAR sear;

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
    }

    private void start(String speed) {
        System.setProperty("sear.speed", speed);
        sear = (SEAR) Runtime.start("testSear", "SEAR");
    }

    @Test
    public void lockStepKeepsToASpeedThatWasAskedFor() {
        start("max");
        sear.setSpeed(4);
        sear.startSimulation();
        long start = System.nanoTime();
        sear.simSleep(2);
        double seconds = (System.nanoTime() - start) / 1e9;
        assertTrue("took " + seconds, seconds > 0.45);
        assertEquals(2, sear.getTime(), 1e-6);
    }

    @Test
    public void tenMinutesOfDrivingTakeSecondsOfCpuTime() {
        start("max");
        sear.startSimulation();
        sear.drive(0.1, 0.3);
        ProcessorTime time = new ProcessorTime();
        sear.simSleep(600);
        double seconds = time.seconds();
        assertEquals(600, sear.getTime(), 1e-3);
        assertTrue("took " + seconds + " s", seconds < 60);
    }

    @Test
    public void withoutLockStepTimeRunsByItself() {
        start("20");
        sear.startSimulation();
        long start = System.nanoTime();
        sear.simSleep(4);
        double seconds = (System.nanoTime() - start) / 1e9;
        assertTrue("took " + seconds, seconds > 0.15);
        assertTrue(sear.getTime() >= 4);
        sear.pause();
        double time = sear.getTime();
        sear.step(3);
        assertEquals(time + 0.05, sear.getTime(), 1e-6);
        sear.resume();
        sear.simSleep(1);
    }
}
