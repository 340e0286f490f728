// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.classroom;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Snapshot of this computer's processes, on Linux; elsewhere empty. */
final class ProcessTable {
    private static final Path PROC = Path.of("/proc");
    private static final int KB_A_MB = 1024;

    private final Map<Long, List<Long>> children = new HashMap<>();
    private final Map<Long, Long> kilobytes = new HashMap<>();

    /** Takes a snapshot. */
    static ProcessTable now() {
        ProcessTable table = new ProcessTable();
        if (Files.isDirectory(PROC)) {
            try (DirectoryStream<Path> all = Files.newDirectoryStream(PROC, "[0-9]*")) {
                all.forEach(table::add);
            } catch (IOException e) {
                return new ProcessTable();
            }
        }
        return table;
    }

    private void add(Path folder) {
        try {
            long id = Long.parseLong(folder.getFileName().toString());
            for (String line : Files.readAllLines(folder.resolve("status"))) {
                if (line.startsWith("PPid:")) {
                    children.computeIfAbsent(number(line), parent -> new ArrayList<>()).add(id);
                } else if (line.startsWith("VmRSS:")) {
                    kilobytes.put(id, number(line));
                }
            }
        } catch (IOException | NumberFormatException e) {
            return;    // the process has just ended
        }
    }

    private static long number(String line) {
        return Long.parseLong(line.replaceAll("\\D", ""));
    }

    /** Returns a process and its descendants. */
    List<Long> tree(long id) {
        List<Long> tree = new ArrayList<>();
        Deque<Long> next = new ArrayDeque<>(List.of(id));
        while (!next.isEmpty()) {
            long one = next.pop();
            tree.add(one);
            next.addAll(children.getOrDefault(one, List.of()));
        }
        return tree;
    }

    /** Returns the memory of a process and its descendants, MB; 0 if unknown. */
    long megabytes(long id) {
        return tree(id).stream().mapToLong(one -> kilobytes.getOrDefault(one, 0L)).sum() / KB_A_MB;
    }
}
