// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python.hints;

import java.util.TreeSet;

/** Hints about wrong indentation. Any thread. */
final class Indents {
    private Indents() {
    }

    /**
     * Returns a hint for an error in a line.
     *
     * @param said Jython's message
     * @return empty if the indentation is right
     */
    static String hint(SourceScan scan, int line, String said) {
        int before = scan.before(line);
        if (before == 0) {
            return blanks(scan, line).isEmpty() ? "" : "the first line of a script starts without spaces";
        }
        String own = blanks(scan, line);
        String former = blanks(scan, before);
        boolean opens = scan.code(before).strip().endsWith(":");
        if (mixes(own, former)) {
            return "line " + line + " starts with " + counted(own) + ", line " + before + " with " + counted(former)
                + ": indent with spaces only, four for each block";
        }
        if (opens && own.length() <= former.length()) {
            return "the lines of a block are indented: four spaces more than the line with the colon";
        }
        if (!opens && own.length() > former.length()) {
            return "line " + line + " starts with " + counted(own) + ", line " + before + " with " + counted(former)
                + ": lines of one block have the same indentation, and only a line that ends with a colon starts a new block";
        }
        TreeSet<Integer> legal = legal(scan, before);
        return own.length() < former.length() && !legal.contains(own.length()) && said.contains("DENT") || !legal.contains(own.length()) && !opens
            ? "line " + line + " starts with " + counted(own) + ", legal here: " + legal.toString().replaceAll("[\\[\\]]", "") : "";
    }

    /** Returns the legal indentations after a line that opens no block, in characters. */
    private static TreeSet<Integer> legal(SourceScan scan, int line) {
        TreeSet<Integer> legal = new TreeSet<>();
        int least = Integer.MAX_VALUE;
        for (int i = line; i > 0; i = scan.before(i)) {
            int own = blanks(scan, i).length();
            if (own < least) {
                least = own;
                legal.add(own);
            }
        }
        return legal;
    }

    private static String blanks(SourceScan scan, int number) {
        String line = scan.line(number);
        return line.substring(0, line.length() - line.stripLeading().length());
    }

    private static boolean mixes(String one, String other) {
        return one.contains("\t") && other.contains(" ") || one.contains(" ") && other.contains("\t") || one.contains("\t") && one.contains(" ");
    }

    private static String counted(String blanks) {
        long tabs = blanks.chars().filter(c -> c == '\t').count();
        long plain = blanks.length() - tabs;
        String written = plain == 0 && tabs > 0 ? "" : plain == 1 ? "1 space" : plain + " spaces";
        return written + (plain > 0 && tabs > 0 ? " and " : "") + (tabs == 0 ? "" : tabs == 1 ? "a tab" : tabs + " tabs");
    }
}
