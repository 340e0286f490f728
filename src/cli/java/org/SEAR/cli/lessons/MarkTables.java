// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.SEAR.files.AtomicFile;

/** Marks as files: CSV, text, and JUnit's XML. */
final class MarkTables {
    private MarkTables() {
    }

    /** Writes marks.csv, marks.txt and marks.xml, each completely or not at all. */
    static void write(List<Mark> marks, Path folder) throws IOException {
        Files.createDirectories(folder);
        AtomicFile.write(folder.resolve("marks.csv"), csv(marks).getBytes(StandardCharsets.UTF_8));
        AtomicFile.write(folder.resolve("marks.txt"), text(marks).getBytes(StandardCharsets.UTF_8));
        AtomicFile.write(folder.resolve("marks.xml"), xml(marks).getBytes(StandardCharsets.UTF_8));
    }

    /** Returns a row for each mark, with a column for each measure of any check. */
    static String csv(List<Mark> marks) {
        Set<String> measures = new LinkedHashSet<>();
        marks.forEach(mark -> measures.addAll(mark.measures.keySet()));
        List<String> head = new ArrayList<>(List.of("pupil", "lesson", "result", "points", "of"));
        head.addAll(measures);
        head.add("missing");
        StringBuilder all = new StringBuilder(line(head));
        for (Mark mark : marks) {
            List<String> cells = new ArrayList<>(
                List.of(mark.pupil, mark.lesson, mark.kind.words, "" + mark.got, "" + mark.asked));
            for (String measure : measures) {
                Double number = mark.measures.get(measure);
                cells.add(number == null ? "" : String.format(Locale.ROOT, "%.3f", number));
            }
            cells.add(String.join(" ", mark.missing));
            all.append(line(cells));
        }
        return all.toString();
    }

    private static String line(List<String> cells) {
        return cells.stream().map(MarkTables::cell).collect(Collectors.joining(",")) + "\n";
    }

    /** Protects text that a spreadsheet would take for a formula. */
    private static String cell(String text) {
        String safe = text.matches("(?s)[=+@\\t\\r].*|-(?![0-9.]+$).*") ? "'" + text : text;
        return safe.matches("(?s).*[\",\\n\\r].*") ? "\"" + safe.replace("\"", "\"\"") + "\"" : safe;
    }

    /** Returns a table for readers, followed by what each script lacks. */
    static String text(List<Mark> marks) {
        int width = marks.stream().mapToInt(mark -> mark.pupil.length()).max().orElse(0);
        int lessons = marks.stream().mapToInt(mark -> mark.lesson.length()).max().orElse(0);
        String form = "%-" + Math.max(width, 5) + "s  %-" + Math.max(lessons, 6) + "s  %2d of %-2d  %s%n";
        StringBuilder all = new StringBuilder();
        for (Mark mark : marks) {
            all.append(String.format(Locale.ROOT, form, mark.pupil, mark.lesson, mark.got, mark.asked,
                mark.kind.words));
        }
        all.append(String.format(Locale.ROOT, "%d of %d have passed%n", marks.stream().filter(Mark::isPassed).count(),
            marks.size()));
        for (Mark mark : marks) {
            if (!mark.isPassed()) {
                all.append(String.format("%n%s, %s: %s%n", mark.pupil, mark.lesson, mark.kind.words));
                mark.missing.forEach(what -> all.append("  - ").append(what).append('\n'));
            }
        }
        return all.toString();
    }

    /** Returns JUnit's format: a test suite with a test case for each mark. */
    static String xml(List<Mark> marks) {
        StringBuilder all = new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
        long failed = marks.stream().filter(mark -> mark.kind == Mark.Kind.NOT_YET || mark.kind == Mark.Kind.NOTHING)
            .count();
        long errors = marks.stream().filter(mark -> !mark.isPassed()).count() - failed;
        all.append(String.format("<testsuite name=\"sear grade\" tests=\"%d\" failures=\"%d\" errors=\"%d\" "
            + "skipped=\"0\">%n", marks.size(), failed, errors));
        for (Mark mark : marks) {
            all.append(String.format("  <testcase classname=\"%s\" name=\"%s\"", escaped(mark.lesson),
                escaped(mark.pupil)));
            if (mark.isPassed()) {
                all.append("/>\n");
            } else {
                String kind = mark.kind == Mark.Kind.NOT_YET || mark.kind == Mark.Kind.NOTHING ? "failure" : "error";
                all.append(String.format(">%n    <%s message=\"%s\">%s</%s>%n  </testcase>%n", kind,
                    escaped(mark.kind.words), escaped(String.join("\n", mark.missing)), kind));
            }
        }
        return all.append("</testsuite>\n").toString();
    }

    /** Replaces characters that XML can't contain by a question mark. */
    private static String escaped(String text) {
        StringBuilder safe = new StringBuilder();
        text.codePoints().forEach(c -> {
            if (c == '<' || c == '>' || c == '&' || c == '"') {
                safe.append("&#").append(c).append(';');
            } else {
                boolean legal = c == '\n' || c == '\t' || c >= ' ' && c < 0xD800 || c >= 0xE000 && c < 0xFFFE
                    || c > 0xFFFF;
                safe.appendCodePoint(legal ? c : '?');
            }
        });
        return safe.toString();
    }
}
