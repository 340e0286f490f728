// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.SEAR.view.platform.DisplayCheck;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Machines that can't show a window run the simulation without one and report the cause. */
public class NoDisplayTest {
    /**
     * Opens a window, prints the result, runs until its input ends and then prints whether the window is still open.
     */
    public static final class Opener {
        private Opener() {
        }

        /** @param arguments none */
        public static void main(String[] arguments) throws Exception {
            RunningWorld world = new RunningWorld(ViewProjects.room());
            SimulatorWindow window = SimulatorWindow.open(world.runner, new WindowOptions().setSize(320, 200)
                .setWarnings(warning -> System.out.println("warning: " + warning)));
            System.out.println("opened: " + window.isOpen() + ", headless: " + window.isHeadless());
            int end = System.in.read();
            Views.until("it notices", () -> end == -1 && !window.isOpen());
            window.close();
            long step = world.snapshot().step;
            Views.until("the world goes on", () -> world.snapshot().step > step);
            System.out.println("still alive");
            System.exit(0);
        }
    }

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Returns options that put the projects and native libraries of processes with a window into the test's folder. */
    private List<String> options() {
        return List.of("-Djava.io.tmpdir=" + folder.getRoot());
    }

    private static String run(Process process) throws Exception {
        process.getOutputStream().close();
        String output = new String(process.getInputStream().readAllBytes());
        assertTrue(output, process.waitFor(240, TimeUnit.SECONDS));
        assertEquals(output, 0, process.exitValue());
        assertTrue(output, output.contains("still alive"));
        return output;
    }

    @Test
    public void withoutDisplay() throws Exception {
        String output = run(Xvfb.java(null, options(), Opener.class.getName()).start());
        assertTrue(output, output.contains("warning: there is no display (DISPLAY is not set); the simulation runs "
            + "without a window"));
        assertTrue(output, output.contains("opened: false, headless: true"));
    }

    @Test
    public void withADisplayThatDoesNotAnswer() throws Exception {
        String output = run(Xvfb.java(":4242", options(), Opener.class.getName()).start());
        assertTrue(output, output.contains("warning: no window could be opened (X11: Failed to open display :4242)"));
        assertTrue(output, output.contains("opened: false, headless: true"));
    }

    @Test
    public void withoutOpenGl() throws Exception {
        try (Xvfb server = new Xvfb("-extension", "GLX")) {
            String output = run(Xvfb.java(server.display(), options(), Opener.class.getName()).start());
            assertTrue(output, output.contains("warning: no window could be opened"));
            assertTrue(output, output.contains("opened: false, headless: true"));
        }
    }

    @Test
    public void withoutNativeLibraries() throws Exception {
        try (Xvfb server = new Xvfb()) {
            ProcessBuilder builder = Xvfb.java(server.display(), options(), Opener.class.getName());
            withoutJars(builder, "-natives-");
            String output = run(builder.start());
            assertTrue(output, output.contains("warning: no window could be opened (jMonkeyEngine or its native "
                + "libraries can't be loaded: "));
            assertTrue(output, output.contains("opened: false, headless: true"));
        }
    }

    @Test
    public void withoutTheWindowLibrary() throws Exception {
        try (Xvfb server = new Xvfb()) {
            ProcessBuilder builder = Xvfb.java(server.display(), options(), Opener.class.getName());
            withoutJars(builder, "jme3-lwjgl3", "lwjgl");
            String output = run(builder.start());
            assertTrue(output, output.contains("warning: no window could be opened (jMonkeyEngine or its native "
                + "libraries can't be loaded: "));
            assertTrue(output, output.contains("opened: false, headless: true"));
        }
    }

    /** A MyRobotLab from before 2024 has a jMonkeyEngine without KeyInput.getKeyName. */
    @Test
    public void anOlderEngineLeavesNoEmptyWindow() throws Exception {
        try (Xvfb server = new Xvfb()) {
            ProcessBuilder builder = Xvfb.java(server.display(), options(), Opener.class.getName());
            List<String> command = builder.command();
            int at = command.indexOf("-cp") + 1;
            command.set(at, olderEngine() + File.pathSeparator + command.get(at));
            Process process = builder.start();
            BufferedReader lines = new BufferedReader(new InputStreamReader(process.getInputStream()));
            String warning = lines.lines().filter(line -> line.startsWith("warning")).findFirst().orElse("it ended");
            assertTrue(warning, warning.startsWith("warning: no window could be opened (the window needs jMonkeyEngine "
                + "3.6 and LWJGL 3.3 but found older or mixed versions: jMonkeyEngine 3.6.1-stable, LWJGL 3.3.2"));
            assertTrue(warning, warning.contains("sear install --replace-jme"));
            assertTrue(warning, warning.contains("NoSuchMethodError") && warning.contains("getKeyName"));
            assertEquals("opened: false, headless: true", lines.readLine());
            assertEquals("windows", "", windows(server));
            process.getOutputStream().close();
            assertTrue(lines.lines().anyMatch("still alive"::equals));
        }
    }

    /** Makes a folder with a class that lacks a method. */
    private Path olderEngine() throws IOException {
        String name = "com/jme3/input/KeyInput.class";
        Path file = folder.getRoot().toPath().resolve(name);
        Files.createDirectories(file.getParent());
        try (InputStream in = NoDisplayTest.class.getClassLoader().getResourceAsStream(name)) {
            String bytes = new String(in.readAllBytes(), StandardCharsets.ISO_8859_1);
            Files.write(file, bytes.replace("getKeyName", "notYetHere").getBytes(StandardCharsets.ISO_8859_1));
        }
        return folder.getRoot().toPath();
    }

    private static String windows(Xvfb server) throws IOException {
        ProcessBuilder tool = new ProcessBuilder("xdotool", "search", "--onlyvisible", "--name", "SEAR");
        tool.environment().put("DISPLAY", server.display());
        return new String(tool.start().getInputStream().readAllBytes());
    }

    private static void withoutJars(ProcessBuilder builder, String... unwanted) {
        List<String> command = builder.command();
        int at = command.indexOf("-cp") + 1;
        command.set(at, Arrays.stream(command.get(at).split(File.pathSeparator))
            .filter(jar -> Arrays.stream(unwanted).noneMatch(new File(jar).getName()::contains))
                .collect(Collectors.joining(File.pathSeparator)));
        builder.command(command);
    }

    @Test
    public void anXServerThatDiesTakesOnlyTheWindowAway() throws Exception {
        try (Xvfb server = new Xvfb()) {
            Process process = Xvfb.java(server.display(), options(), Opener.class.getName()).start();
            BufferedReader lines = new BufferedReader(new InputStreamReader(process.getInputStream()));
            String first = lines.lines().filter(line -> line.startsWith("opened")).findFirst().orElse("it ended");
            assertEquals("opened: true, headless: false", first);
            server.kill();
            process.getOutputStream().close();
            String rest = lines.lines().collect(Collectors.joining("\n"));
            assertTrue(rest, rest.contains("warning: the simulator window's process has ended; the simulation "
                + "continues without it"));
            assertTrue(rest, rest.contains("still alive"));
            assertEquals(0, process.waitFor());
        }
    }

    @Test
    public void displayCheckMessages() {
        assertEquals("there is no display (DISPLAY is not set)", DisplayCheck.problem("Linux", Map.of()));
        assertNull(DisplayCheck.problem("Linux", Map.of("DISPLAY", ":0")));
        assertNull(DisplayCheck.problem("Linux", Map.of("WAYLAND_DISPLAY", "wayland-0")));
        assertNull(DisplayCheck.problem("Windows 11", Map.of()));
    }
}
