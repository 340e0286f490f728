// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import java.io.BufferedReader;
import java.io.File;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;

/** A separate X server without a screen, and processes that show their windows there. */
final class Xvfb implements AutoCloseable {
    private static final String SCREEN = "1280x800x24";
    /** Options of the tests themselves: most such processes end before the optimizing compiler pays off. */
    private static final List<String> QUICK = List.of("-XX:TieredStopAtLevel=1", "-XX:+UseSerialGC");
    private final Process server;
    private final String display;

    /**
     * Starts a server on a free display number.
     * @param more options for it
     */
    Xvfb(String... more) throws IOException {
        List<String> command = new ArrayList<>(
            Arrays.asList("Xvfb", "-displayfd", "1", "-screen", "0", SCREEN, "-nolisten", "tcp", "-noreset"));
        command.addAll(Arrays.asList(more));
        server = new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.DISCARD).start();
        String number = new BufferedReader(new InputStreamReader(server.getInputStream(), StandardCharsets.US_ASCII))
            .readLine();
        if (number == null) {
            throw new IOException("Xvfb did not start; install xvfb (Debian: apt-get install xvfb)");
        }
        display = ":" + number.trim();
    }

    /** Returns the name of the display, for example {@code :99}. */
    String display() {
        return display;
    }

    /**
     * Returns a Java process with this process's class path that shows its windows on a display.
     * @param display null for none
     * @param options of the JVM, which by default has no optimizing compiler
     */
    static ProcessBuilder java(String display, List<String> options, String main, String... arguments) {
        List<String> command = new ArrayList<>();
        command.add(System.getProperty("java.home") + File.separator + "bin" + File.separator + "java");
        command.addAll(QUICK);
        command.addAll(Arrays.asList("-cp", System.getProperty("java.class.path"),
            "-Dsear.root=" + System.getProperty("sear.root", "."), "-Dsear.cliClasspath="
                + System.getProperty("sear.cliClasspath", "")));
        command.addAll(options);
        command.add(main);
        command.addAll(Arrays.asList(arguments));
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
        builder.environment().remove("DISPLAY");
        builder.environment().remove("WAYLAND_DISPLAY");
        if (display != null) {
            builder.environment().put("DISPLAY", display);
        }
        return builder;
    }

    /** Returns the number of the server's process. */
    long pid() {
        return server.pid();
    }

    void kill() throws InterruptedException {
        server.destroyForcibly().waitFor();
    }

    @Override
    public void close() {
        server.destroy();
        try {
            if (!server.waitFor(60, TimeUnit.SECONDS)) {
                server.destroyForcibly();
            }
        } catch (InterruptedException e) {
            server.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
