// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.SEAR.view.platform.NativeMemory;
import org.junit.Test;
import org.junit.runner.RunWith;

/** Opening and closing of windows. */
@RunWith(UnderXvfb.class)
public class LifeCycleTest {
    private static final int TIMES = 50;
    private static final int TRIALS = 3;
    private static final int WARM_UP = 10;
    /**
     * Number of trials, of which the one with the smallest leak counts: the memory of graphics driver and compiler
     * varies.
     */
    private static final int ROUND = 10;
    private static final long LEAK = 20L << 20;

    /** Opens fifty windows; a leak shows in any fifty, but temporary memory of the compiler doesn't. */
    @Test
    public void fiftyWindowsOneAfterAnotherLeaveNothingBehind() throws Exception {
        try (RunningWorld world = new RunningWorld(ViewProjects.room())) {
            String leak = null;
            for (int i = 0; i < TRIALS && (i == 0 || leak != null); i++) {
                leak = leakOfFifty(world);
                System.out.println(leak == null ? "no leak" : leak);
            }
            assertNull(leak, leak);
        }
    }

    /** Returns the quantity that grew too much, or null. */
    private static String leakOfFifty(RunningWorld world) throws Exception {
        long[] heap = new long[TIMES];
        long[] resident = new long[TIMES];
        int threads = 0;
        for (int i = 0; i < TIMES; i++) {
            List<String> warnings = new ArrayList<>();
            WindowOptions options = new WindowOptions().setSize(200, 160).setWarnings(warnings::add);
            SimulatorWindow window = SimulatorWindow.open(world.runner, options);
            assertTrue("window " + i + ": " + warnings, window.isOpen());
            window.close();
            assertFalse(window.isOpen());
            heap[i] = usedHeap();
            resident[i] = resident();
            threads = i == WARM_UP ? threads() : threads;
        }
        int most = threads;
        Views.until("no more threads than " + most, () -> threads() <= most);    // a thread that is ending may still run
        assertEquals("windows", 0, windows());
        String grown = growth("heap", heap);
        return grown != null ? grown : growth("memory", resident);
    }

    private static String growth(String what, long[] bytes) {
        long growth = least(bytes, TIMES - ROUND) - least(bytes, WARM_UP);
        return growth < LEAK ? null : what + " grew by " + growth + " bytes: " + Arrays.toString(bytes);
    }

    private static long least(long[] bytes, int from) {
        return Arrays.stream(bytes, from, from + ROUND).min().getAsLong();
    }

    private static long usedHeap() {
        for (int i = 0; i < 3; i++) {
            System.gc();
            System.runFinalization();
        }
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    private static long resident() {
        NativeMemory.giveBack();
        try {
            return Files.readAllLines(Paths.get("/proc/self/status")).stream().filter(line -> line.startsWith("VmRSS"))
                .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")) << 10).findFirst().getAsLong();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static int threads() {
        return (int) Thread.getAllStackTraces().keySet().stream().filter(thread -> !thread.getName().startsWith("process reaper")).count();
    }

    private static int windows() throws IOException, InterruptedException {
        Process tool = new ProcessBuilder("xdotool", "search", "--name", "SEAR").start();
        int found = (int) new String(tool.getInputStream().readAllBytes()).lines().count();
        tool.waitFor();
        return found;
    }

    @Test
    public void closingTheWindowIsNoticedOnce() throws Exception {
        AtomicInteger closed = new AtomicInteger();
        try (Views view = new Views(ViewProjects.room(), new WindowOptions().setSize(320, 200).setTitle("SEAR to close")
                .setOnClosed(closed::incrementAndGet))) {
            CloseButton.press("SEAR to close");
            Views.until("it is closed", () -> closed.get() == 1 && !view.window.isOpen());
            view.window.close();
            view.window.close();
            assertEquals(1, closed.get());
            long step = view.world.snapshot().step;
            Views.until("the world goes on", () -> view.world.snapshot().step > step);
        }
        assertEquals(1, closed.get());
    }

    @Test
    public void closingFromTheProgramCausesNoCallback() throws Exception {
        AtomicInteger closed = new AtomicInteger();
        Views view = new Views(ViewProjects.room(), new WindowOptions().setSize(320, 200).setOnClosed(closed::incrementAndGet));
        view.close();
        assertEquals(0, closed.get());
    }

    @Test
    public void aSecondWindowIsRefusedWithAReasonAndOpensWhenTheFirstIsGone() throws Exception {
        try (Views view = new Views(ViewProjects.room(), new WindowOptions().setSize(320, 200))) {
            SimulatorWindow second = SimulatorWindow.open(view.world.runner, new WindowOptions());
            assertTrue(second.isHeadless());
            assertTrue(second.getProblem(), second.getProblem().contains("another simulator window is open"));
            second.close();
            assertTrue(view.window.isOpen());
            view.window.close();
            SimulatorWindow third = SimulatorWindow.open(view.world.runner, new WindowOptions().setSize(320, 200));
            assertNull(third.getProblem());
            third.close();
        }
    }
}
