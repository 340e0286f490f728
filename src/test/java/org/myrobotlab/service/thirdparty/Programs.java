// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.junit.rules.TemporaryFolder;

/** Third-party programs that a test runs in its temporary folder; they end with the test. */
final class Programs {
    /** Duration of a driver's run, seconds. */
    static final int SECONDS = Integer.getInteger("sear.driverSeconds", 8);
    /** Timeout for the first output of a driver, seconds. */
    static final int PATIENCE = 60;
    /** Output of MRPT's rawlog-grabber after each logged entry. */
    static final String LOGS = ".*Saved [1-9]\\d* objects.*";
    private static final int TRIES = 3;

    private final TemporaryFolder folder;
    private final List<Process> processes = new ArrayList<>();
    private final List<File> outputs = new ArrayList<>();

    Programs(TemporaryFolder folder) {
        this.folder = folder;
    }

    Process start(ProcessBuilder builder) throws IOException {
        builder.environment().merge("PATH", "/usr/sbin:/sbin", (path, more) -> path + File.pathSeparator + more);
        Process process = builder.redirectErrorStream(true).redirectOutput(folder.newFile())
            .directory(folder.getRoot()).start();
        processes.add(process);
        outputs.add(builder.redirectOutput().file());
        return process;
    }

    /** Returns the output of a process at its end, or after this many seconds. */
    List<String> read(Process process, int seconds) throws Exception {
        process.waitFor(seconds, TimeUnit.SECONDS);
        File file = outputs.get(processes.indexOf(process));
        return Arrays.stream(new String(Files.readAllBytes(file.toPath()), StandardCharsets.ISO_8859_1)
            .split("\r?\n|\r")).collect(Collectors.toList());
    }

    /** Waits until a process has printed a line that matches. */
    void untilItTells(Process process, String pattern) throws Exception {
        assertTrue("no " + pattern + " in " + read(process, 0), tells(process, pattern, PATIENCE));
    }

    /** Returns whether a process prints a line that matches within this many seconds. */
    boolean tells(Process process, String pattern, int seconds) throws Exception {
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(seconds);
        while (read(process, 0).stream().noneMatch(line -> line.matches(pattern))) {
            if (!process.isAlive() || System.nanoTime() > deadline) {
                return false;
            }
            process.waitFor(100, TimeUnit.MILLISECONDS);
        }
        return true;
    }

    /** Returns the output of a process, which must end with status 0. */
    List<String> run(ProcessBuilder builder, List<String> before) throws Exception {
        Process process = start(builder);
        List<String> output = read(process, SECONDS + PATIENCE);
        before.addAll(output);
        assertTrue("it has not ended: " + String.join("\n", before), process.waitFor(0, TimeUnit.SECONDS));
        assertEquals(String.join("\n", before), 0, process.exitValue());
        return output;
    }

    private void forget(String glob) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder.getRoot().toPath(), glob)) {
            for (Path file : files) {
                Files.delete(file);
            }
        }
    }

    /** Returns the first file that matches and contains none of the words, or null. */
    private Path find(String glob, String... without) throws IOException {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder.getRoot().toPath(), glob)) {
            for (Path file : files) {
                if (Arrays.stream(without).noneMatch(file.getFileName().toString()::contains)) {
                    return file;
                }
            }
        }
        return null;
    }

    /** Returns the only file that matches and contains none of the words. */
    Path only(String glob, List<String> output, String... without) throws IOException {
        Path file = find(glob, without);
        assertNotNull("there is no " + glob + " in " + Arrays.toString(folder.getRoot().list()) + "\n"
            + String.join("\n", output), file);
        return file;
    }

    /**
     * Returns some seconds of scans that MRPT's rawlog-grabber logs; its only sensor is a laser scanner with the label
     * LASER. If the machine delays the grabber by a tenth of a second, it ends or continues without the scanner; it is
     * then started again.
     * @param config its configuration, which logs to {@code log} in the temporary folder
     * @param starting timeout of its start, seconds
     * @param seconds duration of logging
     * @return a line for each scan: time, ranges in metres, validity of each range
     */
    List<String[]> grabScans(Path config, int starting, int seconds) throws Exception {
        List<String> output = new ArrayList<>();
        List<String> lines = grab(config, starting, seconds, output);
        for (int i = 1; i < TRIES && lines.size() <= SECONDS; i++) {
            forget("log*.rawlog");
            forget("*LASER*.txt");
            lines = grab(config, starting, seconds, output);
        }
        assertTrue("only " + lines.size() + " scans in " + SECONDS + " s: " + String.join("\n", output),
            lines.size() > SECONDS);
        return lines.stream().skip(1).map(line -> line.trim().split("\\s+")).collect(Collectors.toList());
    }

    /** Returns a running MRPT rawlog-grabber that logs; it is started again if it gave up, as in {@link #grabScans}. */
    Process grabber(Path config) throws Exception {
        Process grabber = start(grabbing(config));
        for (int i = 1; i < TRIES && !tells(grabber, LOGS, PATIENCE / 2); i++) {
            grabber.destroyForcibly().waitFor();
            grabber = start(grabbing(config));
        }
        untilItTells(grabber, LOGS);
        return grabber;
    }

    private static ProcessBuilder grabbing(Path config) {
        return new ProcessBuilder("stdbuf", "-oL", "rawlog-grabber", config.toString());
    }

    /** Returns the lines of the log: a header, then scans; empty if it found no scanner. */
    private List<String> grab(Path config, int starting, int seconds, List<String> output) throws Exception {
        Process grabber = start(grabbing(config));
        if (tells(grabber, LOGS, starting + seconds)) {
            grabber.waitFor(seconds, TimeUnit.SECONDS);
        }
        List<String> said = read(grabber, 0);
        if (!grabber.isAlive()) {
            output.addAll(said);
            return List.of();
        }
        grabber.getOutputStream().write('\n');
        grabber.getOutputStream().flush();
        assertTrue("rawlog-grabber ends at a key", grabber.waitFor(60, TimeUnit.SECONDS));
        output.addAll(read(grabber, 0));
        Path log = only("log*.rawlog", output);
        run(new ProcessBuilder("rawlog-edit", "--export-2d-scans-txt", "-i", log.getFileName().toString(), "--out-dir",
            "."), output);
        Path scans = find("*LASER*.txt", "times");
        return scans == null ? List.of() : Files.readAllLines(scans);
    }

    void end() {
        processes.forEach(Process::destroyForcibly);
    }
}
