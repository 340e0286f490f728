// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import javax.imageio.ImageIO;
import org.SEAR.view.link.RunnerLink;

/** A running simulation with its window in the test's process, for tests that look inside. */
final class Views implements AutoCloseable {
    private static final long PATIENCE = 120;
    final RunningWorld world;
    final WindowApplication window;
    final List<String> warnings = Collections.synchronizedList(new ArrayList<>());

    Views(Path project, WindowOptions options) throws Exception {
        world = new RunningWorld(project);
        window = WindowStart.open(new RunnerLink(world.runner, options.getScriptDrives()),
            options.setWarnings(warnings::add).setScreenshotFolder(report()), () -> { });
        assertNull(window.problem(), window.problem());
        until("the window shows the world", () -> app().frames > 2);
        tool("mousemove", "640", "400");
    }

    /** Returns the folder for pictures of test reports. */
    static Path report() throws IOException {
        return Files.createDirectories(
            Paths.get(System.getProperty("sear.root", "."), "build", "reports", "screenshots"));
    }

    WindowApplication app() {
        return window;
    }

    WindowScene scene() {
        return app().scene();
    }

    /** Runs a query on the window's thread. */
    <T> T ask(Callable<T> question) throws Exception {
        FutureTask<T> task = new FutureTask<>(question);
        app().enqueue(task);
        return task.get(PATIENCE, TimeUnit.SECONDS);
    }

    boolean is(Callable<Boolean> question) {
        try {
            return ask(question);
        } catch (Exception e) {
            throw new AssertionError(e);
        }
    }

    static void until(String what, BooleanSupplier condition) {
        if (!within(PATIENCE, condition)) {
            fail("not within " + PATIENCE + " s: " + what);
        }
    }

    static boolean within(long seconds, BooleanSupplier condition) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (!condition.getAsBoolean()) {
            if (System.nanoTime() > end) {
                return false;
            }
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(5));
        }
        return true;
    }

    /** Waits until the window has drawn this many more pictures. */
    void frames(int count) {
        long wanted = app().frames + count;
        until(count + " more pictures", () -> app().frames >= wanted);
    }

    /** Presses a key of the X server's keyboard with the pointer over the window. */
    void press(String... keys) throws IOException, InterruptedException {
        tool("key", keys);
        frames(2);
    }

    /** Runs an xdotool command. */
    static void tool(String verb, String... words) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(Arrays.asList("xdotool", verb));
        command.addAll(Arrays.asList(words));
        Process tool = new ProcessBuilder(command).redirectErrorStream(true).start();
        String output = new String(tool.getInputStream().readAllBytes());
        assertTrue(command + " (Debian: apt-get install xdotool): " + output, tool.waitFor() == 0);
    }

    /** Takes a picture of the window and saves it as {@code build/reports/screenshots/NAME.png}. */
    BufferedImage picture(String name) throws Exception {
        Path file = report().resolve(name + ".png");
        Files.deleteIfExists(file);
        frames(2);
        ask(() -> {
            scene().picture(file);
            return null;
        });
        until("the picture is written", () -> scene().hud().messagesText().contains(file.toString()));
        return ImageIO.read(file.toFile());
    }

    @Override
    public void close() {
        window.close();
        world.close();
    }
}
