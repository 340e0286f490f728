package org.SEAR.cli.lessons;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A pupil's script in its own process without a window. Limits of time and memory include all processes that it starts.
 * Single use; the waiting thread.
 */
final class PupilProcess {
    /** Limit of kept output, bytes. */
    private static final int MAX_PRINTED = 200_000;
    private static final long LOOK_MILLIS = 100;
    /** Share of the memory limit for the heap; the rest is for the JVM itself. */
    private static final double HEAP_SHARE = 0.6;
    private static final int KILOBYTES = 1024;
    private static final String OUT_OF_MEMORY = "java.lang.OutOfMemoryError";
    private static final Set<String> SCREENS = Set.of("DISPLAY", "WAYLAND_DISPLAY");

    private final Process process;
    private final Set<ProcessHandle> all = new TreeSet<>();
    private final Printed out;
    private final Printed err;
    private boolean tooLong;
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

    private PupilProcess(Process process) {
        this.process = process;
        out = new Printed(process.getInputStream());
        err = new Printed(process.getErrorStream());
    }

    /**
     * Runs a script to its end or to a limit.
     *
     * @param folder working folder
     * @param arguments of {@code sear}
     * @param limit time by the computer's clock, s
     * @param memory limit, MB
     */
    static PupilProcess run(Path folder, List<String> arguments, double limit, int memory) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString()));
        ManagementFactory.getRuntimeMXBean().getInputArguments().stream().filter(PupilProcess::isForAll).forEach(command::add);
        command.addAll(List.of("-Xmx" + (int) (HEAP_SHARE * memory) + "m", "-Xms16m", "-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1",
            "-XX:+ExitOnOutOfMemoryError", "-XX:ActiveProcessorCount=1", "-Djava.awt.headless=true",
            "-Dsear.home=" + System.getProperty("sear.home", "."), "-cp", System.getProperty("java.class.path"), "org.SEAR.cli.SearCommand"));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile());
        builder.environment().keySet().removeAll(SCREENS);
        Process process = builder.start();
        process.getOutputStream().close();
        PupilProcess pupil = new PupilProcess(process);
        try {
            pupil.watch(limit, memory);
        } finally {
            pupil.kill();
        }
        return pupil;
    }

    private static boolean isForAll(String option) {
        return option.startsWith("-XX:SharedArchiveFile") || option.startsWith("-XX:ArchiveRelocation") || option.startsWith("-Xlog:cds")
            || option.equals("-XX:+UnlockDiagnosticVMOptions") || option.startsWith("-XX:+IgnoreUnrecognized")
            || option.startsWith("--sun-misc") || option.startsWith("--enable-native") || option.startsWith("-Dfile.encoding");
    }

    private void watch(double limit, int memory) throws InterruptedException {
        long end = System.nanoTime() + (long) (limit * TimeUnit.SECONDS.toNanos(1));
        while (!process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
            process.descendants().forEach(all::add);
            tooLong = System.nanoTime() > end;
            tooLarge = kilobytes() > (long) memory * KILOBYTES;
            if (tooLong || tooLarge) {
                return;
            }
        }
    }

    /** Returns the memory of the process and the processes that it started, kB; 0 if the system doesn't report it. */
    private long kilobytes() {
        return Stream.concat(Stream.of(process.toHandle()), all.stream()).mapToLong(one -> kilobytes(one.pid())).sum();
    }

    private static long kilobytes(long pid) {
        Path status = Path.of("/proc", Long.toString(pid), "status");
        if (!Files.isReadable(status)) {
            return 0;
        }
        try (Stream<String> lines = Files.lines(status)) {
            return lines.filter(line -> line.startsWith("VmRSS:")).mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
                .findFirst().orElse(0);
        } catch (IOException | java.io.UncheckedIOException e) {
            return 0;       // the process has just ended
        }
    }

    private void kill() throws InterruptedException {
        process.descendants().forEach(all::add);
        process.destroyForcibly();
        all.forEach(ProcessHandle::destroyForcibly);
        process.waitFor();
    }

    /** Returns whether the process was killed for taking too long. */
    boolean isTooLong() {
        return tooLong && !isTooLarge();
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
        return err.text().lines().filter(line -> !line.startsWith("Open this in a browser")).collect(Collectors.joining("\n"));
    }
}
