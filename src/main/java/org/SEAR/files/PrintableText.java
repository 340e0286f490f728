// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import java.io.FilterWriter;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.Writer;

/**
 * Text of files and scripts, made safe for a terminal: its control characters, such as those of escape sequences,
 * become question marks. Any thread.
 */
public final class PrintableText {
    private static final char REPLACEMENT = '?';

    private PrintableText() {
    }

    /** Returns the text with each control character replaced, except tabs and line breaks. */
    public static String of(String text) {
        StringBuilder safe = new StringBuilder(text);
        for (int i = 0; i < safe.length(); i++) {
            char c = safe.charAt(i);
            boolean breaksLine = c == '\n' || c == '\r' && i + 1 < safe.length() && safe.charAt(i + 1) == '\n';
            if (Character.isISOControl(c) && c != '\t' && !breaksLine) {
                safe.setCharAt(i, REPLACEMENT);
            }
        }
        return safe.toString();
    }

    /** Returns the text on one line, with each control character replaced, also tabs and line breaks. */
    public static String line(String text) {
        StringBuilder safe = new StringBuilder(text);
        for (int i = 0; i < safe.length(); i++) {
            if (Character.isISOControl(safe.charAt(i))) {
                safe.setCharAt(i, REPLACEMENT);
            }
        }
        return safe.toString();
    }

    /** Returns a writer that passes printable text on, and flushes after each line. */
    public static PrintWriter writer(Writer to) {
        return new PrintWriter(new FilterWriter(to) {
            @Override
            public void write(int c) throws IOException {
                write(String.valueOf((char) c), 0, 1);
            }

            @Override
            public void write(char[] text, int from, int count) throws IOException {
                write(new String(text), from, count);
            }

            @Override
            public void write(String text, int from, int count) throws IOException {
                out.write(of(text.substring(from, from + count)));
            }
        }, true);
    }
}
