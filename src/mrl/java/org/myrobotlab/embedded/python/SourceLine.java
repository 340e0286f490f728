// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.python.core.PyException;
import org.python.core.PyTraceback;

/** Text of the line at which a script has failed. Any thread. */
final class SourceLine {
    /** Source of code that was run, by its name in tracebacks. */
    private static final Map<String, List<String>> RUN = new ConcurrentHashMap<>();

    private SourceLine() {
    }

    /** Keeps the source of code that is about to run. */
    static void remember(String name, byte[] code) {
        RUN.put(name, List.of(new String(code, StandardCharsets.UTF_8).replaceFirst("^\\uFEFF", "").split("\r\n|\r|\n", -1)));
    }

    /** Returns the innermost line of the error; empty if unknown. */
    static String of(PyException e) {
        PyTraceback last = e.traceback;
        while (last != null && last.tb_next instanceof PyTraceback) {
            last = (PyTraceback) last.tb_next;
        }
        if (last == null || last.tb_frame.f_code == null) {
            return "";
        }
        List<String> lines = lines(last.tb_frame.f_code.co_filename);
        int number = last.tb_lineno;
        return number >= 1 && number <= lines.size() ? lines.get(number - 1).trim() : "";
    }

    /** Returns the lines of code that was run under this name, or of the file; empty if unknown. */
    static List<String> lines(String file) {
        List<String> lines = RUN.getOrDefault(file, List.of());
        try {
            Path path = lines.isEmpty() ? Paths.get(file) : null;
            return path != null && Files.isRegularFile(path) ? Files.readAllLines(path, StandardCharsets.UTF_8) : lines;
        } catch (IOException | RuntimeException unreadable) {
            return List.of(); // not a path, or a file in another encoding: no hints
        }
    }
}
