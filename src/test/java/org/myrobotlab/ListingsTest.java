// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import org.junit.Test;

/**
 * Scripts of the dissertation's listings equal the printed ones ({@code org/SEAR/dissertation}, wrapped lines joined).
 * A comment {@code # SEAR:} on the line explains each difference. Only code counts, without comments and blanks.
 * ScriptsTest runs the scripts.
 */
public class ListingsTest {
    private static final Path SCRIPTS = Paths.get(System.getProperty("sear.root", ".")).resolve("scripts");
    private static final String REPAIR = "# SEAR: ";

    /** A line of code without comment and blanks. */
    private static final class Line {
        private final String text;
        private final String code;
        private final boolean repaired;

        Line(String text) {
            this.text = text;
            code = text.replaceAll("#.*$", "").replaceAll("\\s+", "");
            repaired = text.contains(REPAIR);
        }
    }

    private static List<Line> code(String text) {
        List<Line> lines = new ArrayList<>();
        for (String line : text.split("\n")) {
            Line parsed = new Line(line);
            if (!parsed.code.isEmpty()) {
                lines.add(parsed);
            }
        }
        return lines;
    }

    private static String printed(int... numbers) throws IOException {
        StringBuilder all = new StringBuilder();
        for (int number : numbers) {
            try (InputStream in = ListingsTest.class.getResourceAsStream(
                String.format("/org/SEAR/dissertation/listing%02d.txt", number))) {
                all.append(new String(in.readAllBytes(), StandardCharsets.UTF_8)).append('\n');
            }
        }
        return all.toString();
    }

    /** Returns the lengths of the longest common subsequences from line i of one and line k of the other on. */
    private static int[][] common(List<Line> one, List<Line> other) {
        int[][] length = new int[one.size() + 1][other.size() + 1];
        for (int i = one.size() - 1; i >= 0; i--) {
            for (int k = other.size() - 1; k >= 0; k--) {
                length[i][k] = one.get(i).code.equals(other.get(k).code) ? length[i + 1][k + 1] + 1
                    : Math.max(length[i + 1][k], length[i][k + 1]);
            }
        }
        return length;
    }

    /** Returns unexplained differences, and explanations without a difference. */
    private static List<String> faults(List<Line> print, List<Line> script) {
        List<String> faults = new ArrayList<>();
        List<String> missing = new ArrayList<>();
        boolean repaired = false;
        int[][] length = common(print, script);
        int i = 0;
        for (int k = 0; k <= script.size();) {
            boolean printLeft = i < print.size();
            if (k < script.size() && printLeft && print.get(i).code.equals(script.get(k).code)) {
                if (script.get(k).repaired) {
                    faults.add("as printed, but named as repaired: " + script.get(k).text);
                }
                faults.addAll(repaired ? List.of() : missing);
                missing.clear();
                repaired = false;
                i++;
                k++;
            } else if (k < script.size() && (!printLeft || length[i][k + 1] >= length[i + 1][k])) {
                repaired |= script.get(k).repaired;
                if (!script.get(k).repaired) {
                    faults.add("not in the print, and no comment says why: " + script.get(k).text);
                }
                k++;
            } else if (printLeft) {
                missing.add("printed, but left out: " + print.get(i).text);
                i++;
            } else {
                k++;
            }
        }
        faults.addAll(repaired ? List.of() : missing);
        return faults;
    }

    private static void assertAsPrinted(int number, int... printed) throws IOException {
        String script = Files.readString(SCRIPTS.resolve(String.format("listing%02d.py", number)));
        assertEquals("Listing " + number, "", String.join("\n", faults(code(printed(printed)), code(script))));
    }

    @Test
    public void everyDeviationIsNamedOnItsLine() throws IOException {
        for (int number : new int[] {1, 2, 3, 5, 6, 8, 10}) {
            assertAsPrinted(number, number);
        }
        assertAsPrinted(4, 2, 4);
        assertAsPrinted(7, 2, 4, 7);
        assertAsPrinted(9, 9);
    }

    @Test
    public void unexplainedDifferencesAreFound() {
        List<Line> print = code("a = 1\nb = 2\nc = 3\n");
        assertEquals("[]", faults(print,
            code("a = 1  # comment\nb = 4  # SEAR: printed 2\nc = 3\nd()  # SEAR: added\n")).toString());
        assertEquals(2, faults(print, code("a = 1\nb = 4\nc = 3\n")).size());
        assertTrue(faults(print, code("a = 1\nb = 2\n")).toString().contains("printed, but left out: c = 3"));
        assertTrue(faults(print, code("a = 1  # SEAR: changed\nb = 2\nc = 3\n")).toString()
            .contains("as printed, but named"));
    }
}
