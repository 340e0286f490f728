// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.python.core.PyObject;
import org.python.core.PyUnicode;

/** Texts of scripts, for hints; in Python a function from a file's name to its text. Any thread. */
final class SourceText extends PyObject {
    private static final long serialVersionUID = 1L;
    /** Source of code that was run, by its name in tracebacks. */
    private static final Map<String, String> RUN = new ConcurrentHashMap<>();

    /** Keeps the source of code that is about to run. */
    static void remember(String name, byte[] code) {
        RUN.put(name, new String(code, StandardCharsets.UTF_8));
    }

    /** Returns the code that was run under this name, or the file's text; empty if unknown. */
    static String of(String file) {
        String code = RUN.getOrDefault(file, "");
        try {
            Path path = code.isEmpty() ? Paths.get(file) : null;
            return path != null && Files.isRegularFile(path) ? Files.readString(path) : code;
        } catch (IOException | RuntimeException unreadable) {
            return ""; // not a path, or a file in another encoding: no hints
        }
    }

    @Override
    public PyObject __call__(PyObject[] values, String[] names) {
        return new PyUnicode(of(values[0].toString()));
    }
}
