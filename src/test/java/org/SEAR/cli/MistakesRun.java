// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.myrobotlab.embedded.python.PythonEngine;

/**
 * Runs {@code script.py} of each folder in a folder as {@code sear --headless --port none --speed max} does, one after
 * the other in one JVM. Writes the user's view to {@code output.txt}, the exit status to {@code status.txt} and the CPU
 * time in seconds to {@code seconds.txt}. A script whose folder has {@code message.txt} runs endlessly and is aborted
 * when that message appears.
 */
public final class MistakesRun {
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(120);
    private static final long LOOK_MILLIS = 20;

    private MistakesRun() {
    }

    /** @param arguments the folder of the folders */
    public static void main(String[] arguments) throws Exception {
        Console.quiet();
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.speed", "max");
        List<Path> folders;
        try (Stream<Path> all = Files.list(Paths.get(arguments[0]))) {
            folders = all.filter(Files::isDirectory).sorted().collect(Collectors.toList());
        }
        PrintStream console = System.out;
        for (Path folder : folders) {
            run(folder);
        }
        System.setOut(console);
        System.exit(0);
    }

    private static void run(Path folder) throws Exception {
        ByteArrayOutputStream seen = new ByteArrayOutputStream();
        PrintStream out = new PrintStream(seen, true, StandardCharsets.UTF_8);
        System.setOut(out);
        System.setErr(out);
        System.setProperty("sear.project", folder.resolve("SEARproject").toString());
        int[] status = {-1};
        long before = processorNanos();
        Thread script = new Thread(() -> {
            try {
                status[0] = new MrlRun(MrlRun.NO_PORT, false, new PrintWriter(out, true))
                    .script(folder.resolve("script.py"), List.of(), false, Double.POSITIVE_INFINITY);
            } catch (IOException | InterruptedException e) {
                out.println(e);
            }
        }, "script");
        script.start();
        Path message = folder.resolve("message.txt");
        if (Files.exists(message)) {
            String wanted = Files.readString(message);
            long end = System.nanoTime() + PATIENCE;
            while (script.isAlive() && !text(seen, folder).contains(wanted) && System.nanoTime() < end) {
                script.join(LOOK_MILLIS);
            }
            while (script.isAlive()) {    // it may not have started yet
                PythonEngine engine = PythonEngine.of("python");
                if (engine != null) {
                    engine.interrupt();
                }
                script.join(LOOK_MILLIS);
            }
        }
        script.join();
        double seconds = (processorNanos() - before) / (double) TimeUnit.SECONDS.toNanos(1);
        Files.writeString(folder.resolve("output.txt"), text(seen, folder));
        Files.writeString(folder.resolve("status.txt"), String.valueOf(status[0]));
        Files.writeString(folder.resolve("seconds.txt"), String.valueOf(seconds));
    }

    private static String text(ByteArrayOutputStream seen, Path folder) {
        return seen.toString(StandardCharsets.UTF_8).replace(folder + "/", "");
    }

    private static long processorNanos() {
        return ((com.sun.management.OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean())
            .getProcessCpuTime();
    }
}
