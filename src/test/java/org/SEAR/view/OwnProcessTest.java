// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.runner.RunWith;

/** The window in its own process. */
@RunWith(UnderXvfb.class)
public class OwnProcessTest {
    private static final int TIMES = 5;
    private final List<String> warnings = Collections.synchronizedList(new ArrayList<>());
    private final AtomicInteger closed = new AtomicInteger();
    private RunningWorld world;
    private SimulatorWindow window;
    private Path pictures;

    @Before
    public void open() throws Exception {
        pictures = Files.createTempDirectory("pictures");
        world = new RunningWorld(ViewProjects.room());
        window = SimulatorWindow.open(world.runner, new WindowOptions().setSize(640, 400).setTitle("SEAR elsewhere")
            .setWarnings(warnings::add).setOnClosed(closed::incrementAndGet).setScreenshotFolder(pictures));
        assertNull(window.getProblem(), window.getProblem());
        Views.tool("mousemove", "640", "400");
    }

    @After
    public void close() {
        window.close();
        world.close();
    }

    private double speed() {
        return world.robot().speed;
    }

    @Test
    public void keysReachTheWorld() throws Exception {
        assertTrue(window.isOpen());
        Views.tool("key", "u");
        Views.until("it drives", () -> speed() > 0.15);
        Views.tool("key", "semicolon");
        Views.until("it stands", () -> Math.abs(speed()) < 0.01);
        Views.tool("key", "plus");
        Views.until("it is faster", () -> world.runner.getSpeed() == 2);
        Views.tool("key", "F12");
        Views.until("the picture is there", () -> Files.exists(pictures.resolve("sear-0001.png")));
        Views.tool("key", "p");
        Views.until("it pauses", world.runner::isPaused);
        long step = world.pausedStep();
        Views.tool("key", "period");
        Views.until("it steps", () -> world.snapshot().step == step + 1);
        Views.tool("key", "Return");
        Views.until("it starts again", () -> world.snapshot().step == 0);
        assertEquals(List.of(), warnings);
    }

    @Test
    public void closingEndsTheProcessWithoutACallback() {
        ProcessHandle child = ProcessHandle.current().children()
            .filter(process -> process.info().command().orElse("").endsWith("java")).findFirst().get();
        window.close();
        assertFalse(window.isOpen());
        assertFalse(child.isAlive());
        assertEquals(0, closed.get());
        assertEquals(List.of(), warnings);
    }

    @Test
    public void windowsOneAfterAnotherLeaveNothingBehind() throws Exception {
        window.close();
        window.close();
        int most = 0;
        for (int i = 0; i < TIMES; i++) {
            window = SimulatorWindow.open(world.runner, new WindowOptions().setSize(200, 160)
                .setWarnings(warnings::add));
            assertTrue("window " + i + ": " + warnings, window.isOpen());
            window.close();
            assertFalse(window.isOpen());
            most = i == 0 ? threads() : most;
        }
        int threads = most;
        // a thread that is ending may still run
        Views.until("no more threads than " + threads, () -> threads() <= threads);
        assertEquals("processes", 0, ProcessHandle.current().children().count());
    }

    private static int threads() {
        return (int) Thread.getAllStackTraces().keySet().stream()
            .filter(thread -> !thread.getName().startsWith("process reaper")).count();
    }

    @Test
    public void twoWindowsShowTwoWorlds() throws Exception {
        try (RunningWorld second = new RunningWorld(ViewProjects.room());
                SimulatorWindow other = SimulatorWindow.open(second.runner, new WindowOptions().setSize(320, 200))) {
            assertTrue(other.getProblem(), other.isOpen());
            assertTrue(window.isOpen());
        }
        assertTrue(window.isOpen());
    }

    @Test
    public void closingTheWindowIsNoticed() throws Exception {
        CloseButton.press("SEAR elsewhere");
        Views.until("it is noticed", () -> closed.get() == 1);
        assertFalse(window.isOpen());
        assertEquals(List.of(), warnings);
    }

    @Test
    public void aProcessThatDiesTakesOnlyTheWindowAway() {
        ProcessHandle.current().children().forEach(ProcessHandle::destroyForcibly);
        Views.until("it is noticed", () -> !window.isOpen() && !warnings.isEmpty());
        assertEquals(List.of("the simulator window's process has ended; the simulation continues without it"),
            warnings);
        long step = world.snapshot().step;
        Views.until("the world goes on", () -> world.snapshot().step > step);
    }
}
