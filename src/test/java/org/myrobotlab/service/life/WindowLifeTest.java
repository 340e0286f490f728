// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import org.SEAR.Slow;
import org.SEAR.view.UnderXvfb;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.runner.RunWith;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;

/**
 * However a SEAR service with a window ends, neither its window nor any of its threads or ports remains, and another
 * service can follow.
 */
@RunWith(UnderXvfb.class)
@Category(Slow.class)
public class WindowLifeTest {
    private static final long PATIENCE = 120;
    private SEAR sear;

    @Before
    public void open() throws Exception {
        System.clearProperty("sear.headless");
        System.setProperty("sear.speed", "1");
        TestWorld.build(Files.createTempDirectory("window-life"));
        start();
    }

    @After
    public void release() {
        Runtime.releaseAll();
    }

    private void start() {
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        assertEquals("a window while the simulation runs", 1, windows());
    }

    /** Returns the number of windows on this test's own display. */
    private static int windows() {
        try {
            Process tool = new ProcessBuilder("xdotool", "search", "--onlyvisible", "--name", "SEAR").start();
            int found = (int) new String(tool.getInputStream().readAllBytes()).lines().count();
            tool.waitFor();
            return found;
        } catch (IOException e) {
            throw new AssertionError("xdotool (Debian: apt-get install xdotool)", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new AssertionError(e);
        }
    }

    private static List<String> threads() {
        List<String> names = new ArrayList<>(TestWorld.threads());
        Thread.getAllStackTraces().keySet().stream().map(Thread::getName).filter(name -> name.startsWith("jME3"))
            .forEach(names::add);
        return names;
    }

    private static void until(String what, BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE);
        while (!condition.getAsBoolean()) {
            assertTrue("not within " + PATIENCE + " s: " + what + "; threads " + threads() + ", windows " + windows(),
                System.nanoTime() < end);
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(20));
        }
    }

    private static void assertNothingIsLeft() {
        assertEquals("windows", 0, windows());
        until("no thread is left", () -> threads().isEmpty());
        assertNoPorts();
    }

    private static void assertNoPorts() {
        for (String port : new String[] {TestWorld.ROOMBA_PORT, TestWorld.LIDAR_PORT, TestWorld.GPS_PORT}) {
            assertNull(port, SerialDeviceFactory.get(port));
        }
    }

    @Test
    public void aReleaseClosesItsWindowAndAnotherServiceCanFollow() {
        sear.simSleep(0.1);
        assertTrue(Runtime.releaseService("sear"));
        assertNothingIsLeft();
        start();
        sear.simSleep(0.1);
    }

    @Test
    public void stoppedAndStartedAgainItOpensAnother() {
        sear.stopSimulation();
        assertEquals("windows", 0, windows());
        until("only the service's own thread is left", () -> threads().equals(List.of("SEAR publisher")));
        assertNoPorts();
        sear.startSimulation();
        assertEquals(1, windows());
        sear.stopService();
        assertFalse(sear.isSimulating());
        assertNothingIsLeft();
        sear.startService();
        start();
    }

    @Test
    public void shutDownOfMyRobotLabClosesIt() {
        Runtime.start("lidar", "LIDAR");
        Runtime.shutdown();
        assertNothingIsLeft();
        assertNull(Runtime.getService("sear"));
    }

    @Test
    public void releasedWhileAScriptDrivesAndTheSimulationIsPaused() throws Exception {
        Python python = (Python) Runtime.start("python", "Python");
        Thread script = new Thread(() -> python.exec("driven = 0\nwhile True:\n  sear.drive(0.2, 1)\n  driven += 1\n"));
        python.exec("sear = Runtime.getService('sear')");
        script.start();
        until("the script drives", () -> python.get("driven") instanceof Number && ((Number) python.get("driven"))
            .intValue() > 10);
        sear.pause();
        Runtime.releaseService("sear");
        script.join(TimeUnit.SECONDS.toMillis(PATIENCE));
        assertFalse("the script hangs", script.isAlive());
        assertNothingIsLeft();
    }

    /** Both services have the same world. The second gets an error, and its attempt leaves the first window open. */
    @Test
    public void aSecondServiceLeavesTheFirstWindowOpen() {
        SEAR second = (SEAR) Runtime.start("second", "SEAR");
        try {
            second.startSimulation();
            throw new AssertionError("two simulations");
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("service sear runs a simulation: stop it first"));
        }
        Runtime.releaseService("second");
        assertEquals(1, windows());
        sear.simSleep(0.1);
    }
}
