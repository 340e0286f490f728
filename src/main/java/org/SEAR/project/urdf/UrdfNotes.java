// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.urdf;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.SEAR.files.PrintableText;

/** Notes of an import about what it leaves out or changes, each with its lines in the file. One thread. */
final class UrdfNotes {
    private static final int LINES_SHOWN = 4;

    private final Map<String, TreeSet<Integer>> lines = new LinkedHashMap<>();

    /** @param line of the file; 0 for none */
    void add(String text, int line) {
        TreeSet<Integer> of = lines.computeIfAbsent(PrintableText.line(text), key -> new TreeSet<>());
        if (line > 0) {
            of.add(line);
        }
    }

    /** Returns the notes in the order of the work. */
    List<String> all() {
        List<String> all = new ArrayList<>();
        lines.forEach((text, at) -> all.add(at.isEmpty() ? text : text + " (" + places(at) + ")"));
        return all;
    }

    private static String places(TreeSet<Integer> at) {
        String shown = at.stream().limit(LINES_SHOWN).map(String::valueOf).collect(Collectors.joining(", "));
        return (at.size() == 1 ? "line " : "lines ") + shown
            + (at.size() > LINES_SHOWN ? " and " + (at.size() - LINES_SHOWN) + " more" : "");
    }
}
