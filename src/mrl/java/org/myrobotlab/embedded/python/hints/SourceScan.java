// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded.python.hints;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * Scans a script without Python's grammar, so it also takes invalid scripts: finds strings, comments, unclosed brackets
 * and strings, and characters that Python doesn't know. Lines count from 1, columns from 0.
 */
public final class SourceScan {
    private static final String OPENING = "([{";
    private static final String CLOSING = ")]}";
    private static final String THREE = "\"\"\"";

    private final List<String> lines;
    private final List<String> code = new ArrayList<>();
    private final Deque<Place> open = new ArrayDeque<>();
    private Place foreign;
    private Place textLeftOpen;
    private String brackets = "";
    private int bracketsLine;
    /** Closing marks of the current string; empty outside strings. */
    private String end = "";
    private Place textBegins;

    /** A character of the script. */
    public static final class Place {
        public final int line;
        public final int column;
        public final String character;

        public Place(int line, int column, String character) {
            this.line = line;
            this.column = column;
            this.character = character;
        }
    }

    public SourceScan(List<String> lines) {
        this.lines = lines;
        for (int i = 0; i < lines.size(); i++) {
            code.add(codeOf(lines.get(i), i + 1));
        }
        if (!end.isEmpty() && textLeftOpen == null) {
            textLeftOpen = textBegins;
        }
        if (brackets.isEmpty() && !open.isEmpty()) {
            Place last = open.getLast();
            bracketsLine = last.line;
            brackets = "the bracket " + last.character + " in line " + last.line + " has no closing " + partner(last.character);
        }
    }

    /** Returns the line with comments removed and the contents of strings replaced by spaces. */
    private String codeOf(String line, int number) {
        StringBuilder plain = new StringBuilder();
        int i = 0;
        while (i < line.length()) {
            if (!end.isEmpty()) {
                i = inText(line, i, plain);
            } else if (line.charAt(i) == '#') {
                break;
            } else {
                i = outside(line, i, number, plain);
            }
        }
        if (end.length() == 1 && !line.endsWith("\\")) {
            textLeftOpen = textLeftOpen == null ? textBegins : textLeftOpen;
            end = "";
        }
        return plain.toString();
    }

    private int inText(String line, int i, StringBuilder plain) {
        if (line.charAt(i) == '\\') {
            plain.append("  ");
            return i + 2;
        }
        if (line.startsWith(end, i)) {
            int length = end.length();
            plain.append(end);
            end = "";
            return i + length;
        }
        plain.append(' ');
        return i + 1;
    }

    private int outside(String line, int i, int number, StringBuilder plain) {
        int point = line.codePointAt(i);
        String character = new String(Character.toChars(point));
        Place place = new Place(number, i, character);
        if (point == '"' || point == '\'') {
            end = line.startsWith(THREE.replace("\"", character), i) ? THREE.replace("\"", character) : character;
            textBegins = place;
            plain.append(end);
            return i + end.length();
        }
        if (point > '~' && foreign == null) {
            foreign = place;
        }
        if (OPENING.contains(character)) {
            open.addLast(place);
        } else if (CLOSING.contains(character)) {
            close(place);
        }
        plain.append(character);
        return i + character.length();
    }

    private void close(Place place) {
        Place opened = open.pollLast();
        if (brackets.isEmpty() && (opened == null || !partner(opened.character).equals(place.character))) {
            bracketsLine = place.line;
            brackets = opened == null ? "the bracket " + place.character + " in line " + place.line + " has no opening bracket"
                : "the bracket " + opened.character + " in line " + opened.line + " is closed by " + place.character + " in line " + place.line;
        }
    }

    private static String partner(String opening) {
        return CLOSING.substring(OPENING.indexOf(opening), OPENING.indexOf(opening) + 1);
    }

    /** Returns the line as it is in the script; empty if there is no such line. */
    public String line(int number) {
        return number >= 1 && number <= lines.size() ? lines.get(number - 1) : "";
    }

    /** Returns the line without comments and string contents; empty if there is no such line. */
    public String code(int number) {
        return number >= 1 && number <= code.size() ? code.get(number - 1) : "";
    }

    /** Returns the number of the last line with code before the given one; 0 if there is none. */
    int before(int number) {
        int line = number - 1;
        while (line > 0 && code(line).isBlank()) {
            line--;
        }
        return line;
    }

    /** Returns the first character outside strings and comments that Python doesn't know; null if there is none. */
    public Place foreign() {
        return foreign;
    }

    /** Returns the start of the first unclosed string; null if all are closed. */
    Place textLeftOpen() {
        return textLeftOpen;
    }

    /** Returns the first bracket mistake up to a line, as text; empty if there is none. */
    String brackets(int line) {
        return bracketsLine <= line ? brackets : "";
    }
}
