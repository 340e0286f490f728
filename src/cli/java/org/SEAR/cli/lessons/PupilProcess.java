// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;

/**
 * A pupil's script in its own process without a window. Limits of time and memory include all processes that it starts,
 * and all end with it. Single use; the waiting thread.
 */
final class PupilProcess {
    /** Limit of kept output, bytes. */
    private static final int MAX_PRINTED = 200_000;
    private static final long LOOK_MILLIS = 100;
    /** Ratio of the time between two searches for new processes to the time between two looks at the memory. */
    private static final int SEARCH_EVERY = 5;
    /** Share of the memory limit for the heap; the rest is for the JVM itself. */
    private static final double HEAP_SHARE = 0.6;
    private static final int KILOBYTES = 1024;
    private static final String OUT_OF_MEMORY = "java.lang.OutOfMemoryError";
    private static final Set<String> SCREENS = Set.of("DISPLAY", "WAYLAND_DISPLAY");

    private final Process process;
    private final ProcessFamily family;
    private final Printed out;
    private final Printed err;
    private String tooLong;
    private boolean tooLarge;

    /** Output of the process; keeps its beginning and reads on. */
    private static final class Printed implements Runnable {
        private final InputStream from;
        private final ByteArrayOutputStream kept = new ByteArrayOutputStream();
        private final Thread thread = new Thread(this, "printed");

        Printed(InputStream from) {
            this.from = from;
            thread.setDaemon(true);
            thread.start();
        }

        @Override
        public void run() {
            byte[] some = new byte[8192];
            for (int count = read(some); count >= 0; count = read(some)) {
                synchronized (kept) {
                    kept.write(some, 0, Math.min(count, MAX_PRINTED - kept.size()));
                }
            }
        }

        /** Returns the number of bytes; negative at the end, and after the process was killed. */
        private int read(byte[] some) {
            try {
                return from.read(some);
            } catch (IOException e) {
                return -1;
            }
        }

        /**
         * Returns the output after the end of the process; a child process that still runs may keep the stream open.
         */
        String text() throws InterruptedException {
            thread.join(TimeUnit.SECONDS.toMillis(1));
            synchronized (kept) {
                return new String(kept.toByteArray(), StandardCharsets.UTF_8);
            }
        }
    }

    private PupilProcess(Process process, ProcessFamily family) {
        this.process = process;
        this.family = family;
        out = new Printed(process.getInputStream());
        err = new Printed(process.getErrorStream());
    }

    /**
     * Runs a script to its end or to a limit.
     *
     * @param folder working folder
     * @param arguments of {@code sear}
     * @param limit processor time and idle time, s
     * @param memory limit, MB
     */
    static PupilProcess run(Path folder, List<String> arguments, double limit, int memory)
        throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(
            List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream().filter(PupilProcess::isForAll)
            .forEach(command::add);
        command.addAll(List.of("-Xmx" + (int) (HEAP_SHARE * memory) + "m", "-Xms16m", "-XX:+UseSerialGC",
            "-XX:TieredStopAtLevel=1",
            "-XX:+ExitOnOutOfMemoryError", "-XX:ActiveProcessorCount=1", "-Djava.awt.headless=true",
            "-Dsear.parent=" + ProcessHandle.current().pid(), "-Dsear.home=" + System.getProperty("sear.home", "."),
            "-cp",
            System.getProperty("java.class.path"), "org.SEAR.cli.SearCommand"));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
        builder.environment().keySet().removeAll(SCREENS);
        ProcessFamily family = new ProcessFamily();
        ExitHook exit = new ExitHook(() -> end(family));
        try {
            Process process = family.start(builder);
            process.getOutputStream().close();
            PupilProcess pupil = new PupilProcess(process, family);
            pupil.watch(new TimeLimit(limit), memory);
            family.end();
            process.waitFor();
            return pupil;
        } finally {
            family.end();
            exit.cancel();
        }
    }

    private static boolean isForAll(String option) {
        return option.startsWith("-XX:SharedArchiveFile") || option.startsWith("-XX:ArchiveRelocation")
            || option.startsWith("-Xlog:cds")
            || option.equals("-XX:+UnlockDiagnosticVMOptions") || option.startsWith("-XX:+IgnoreUnrecognized")
            || option.startsWith("--sun-misc") || option.startsWith("--enable-native")
            || option.startsWith("-Dfile.encoding");
    }

    /** Ends a script together with this program. */
    private static void end(ProcessFamily family) {
        try {
            family.end();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void watch(TimeLimit limit, int memory) throws InterruptedException {
        long start = System.nanoTime();
        for (int look = 1; !process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS); look++) {
            if (look % SEARCH_EVERY == 0) {
                family.look();
            }
            tooLong = limit.exceeded((System.nanoTime() - start) / (double) TimeUnit.SECONDS.toNanos(1),
                family.seconds());
            tooLarge = family.kilobytes() > (long) memory * KILOBYTES;
            if (tooLong != null || tooLarge) {
                return;
            }
        }
    }

    /** Returns what the script did for too long, so that it was killed; null if it wasn't. */
    String getTooLong() {
        return isTooLarge() ? null : tooLong;
    }

    /** Returns whether the process was killed for taking too much memory. */
    boolean isTooLarge() {
        return tooLarge || said(out).contains(OUT_OF_MEMORY) || said(err).contains(OUT_OF_MEMORY);
    }

    private static String said(Printed printed) {
        synchronized (printed.kept) {
            return new String(printed.kept.toByteArray(), StandardCharsets.UTF_8);
        }
    }

    int getStatus() {
        return process.exitValue();
    }

    /** Returns the standard output. */
    String getPrinted() throws InterruptedException {
        return out.text();
    }

    /** Returns the error output. */
    String getErrors() throws InterruptedException {
        return err.text().lines().filter(line -> !line.startsWith("Open this in a browser"))
            .collect(Collectors.joining("\n"));
    }
}
