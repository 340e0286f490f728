// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import com.sun.management.OperatingSystemMXBean;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import picocli.CommandLine;

/**
 * Runs {@code sear check} for each folder in a folder and prints a line for each, separated by tabs: name, exit status,
 * CPU time in ms, and the lines of its file {@code expected} that are missing in the output.
 */
final class CheckEach {
    private CheckEach() {
    }

    /** @param arguments the folder of the folders */
    public static void main(String[] arguments) throws Exception {
        OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
        List<Path> folders;
        try (Stream<Path> all = Files.list(Path.of(arguments[0]))) {
            folders = all.sorted().collect(Collectors.toList());
        }
        for (Path folder : folders) {
            StringWriter said = new StringWriter();
            CommandLine line = SearCommand.commandLine().setOut(new PrintWriter(said)).setErr(new PrintWriter(said));
            long before = system.getProcessCpuTime();
            int status = line.execute("check", folder.toString());
            long millis = TimeUnit.NANOSECONDS.toMillis(system.getProcessCpuTime() - before);
            String missing = Files.readAllLines(folder.resolve("expected")).stream()
                .filter(text -> !said.toString().contains(text)).collect(Collectors.joining(" and "));
            String words = missing.isEmpty() ? "" : "not said: " + missing + ", but: " + said.toString()
                .replaceAll("\\s+", " ");
            System.out.println(folder.getFileName() + "\t" + status + "\t" + millis + "\t" + words);
        }
    }
}
