// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicLong;
import org.SEAR.Slow;
import org.SEAR.simulator.Simulation;
import org.SEAR.view.UnderXvfb;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;

/** Simulated time begins when the window is open, so that its opening costs no simulated seconds. */
@RunWith(UnderXvfb.class)
@Category(Slow.class)
public class WindowClockTest {
    private static final double NANOS = 1e9;

    private Path project;
    private SEAR sear;

    @Before
    public void build() throws Exception {
        System.clearProperty("sear.headless");
        System.setProperty("sear.speed", "1");
        project = Files.createTempDirectory("window-clock");
        TestWorld.build(project);
        sear = (SEAR) Runtime.start("sear", "SEAR");
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    private static boolean isThereAWindow() {
        try {
            Process tool = new ProcessBuilder("xdotool", "search", "--onlyvisible", "--name", "SEAR").start();
            return tool.getInputStream().readAllBytes().length > 0;
        } catch (IOException e) {
            throw new AssertionError("xdotool (Debian: apt-get install xdotool)", e);
        }
    }

    /** Simulated time is at most the real time since the last check without a window, on a busy machine too. */
    @Test
    public void timeBeginsWhenTheWindowIsOpen() throws Exception {
        AtomicLong withoutWindow = new AtomicLong(System.nanoTime());
        Thread watcher = new Thread(() -> {
            long asked = System.nanoTime();
            while (!isThereAWindow()) {
                withoutWindow.set(asked);
                asked = System.nanoTime();
            }
        });
        watcher.start();
        sear.startSimulation();
        double simulated = sear.getTime();
        long now = System.nanoTime();
        watcher.join();
        double real = (now - withoutWindow.get()) / NANOS;
        assertTrue(simulated + " s are simulated, the window is there for " + real + " s at most", simulated <= real
            + Simulation.STEP);
        sear.simSleep(0.2);
        assertTrue("time goes on", sear.getTime() > simulated);
    }

    @Test
    public void inLockStepTheScriptControlsTime() {
        sear.setLockStep(true);
        sear.startSimulation();
        assertEquals(0, sear.getTime(), 0);
        sear.simSleep(0.5);
        assertEquals(0.5, sear.getTime(), Simulation.STEP);
    }

    /** Without SEAR on its class path the window's process ends. */
    @Test
    public void withoutAWindowTimeStillBegins() {
        String classPath = System.setProperty("java.class.path", "nothing");
        try {
            sear.startSimulation();
        } finally {
            System.setProperty("java.class.path", classPath);
        }
        assertFalse(isThereAWindow());
        sear.simSleep(0.2);
        assertTrue(sear.getTime() >= 0.2);
    }
}
