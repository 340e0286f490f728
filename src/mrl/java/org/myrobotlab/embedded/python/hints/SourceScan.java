package org.myrobotlab.embedded.python.hints;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * A script's text, taken apart without Python's grammar, so that it may be wrong: where texts and comments are, which brackets and texts are not
 * closed, which characters Python does not know. Lines count from 1, columns from 0.
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
    /** What ends the text that is being gone through; empty outside of texts. */
    private String end = "";
    private Place textBegins;

    /** One character of the script. */
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
            brackets = "the bracket " + last.character + " of line " + last.line + " is not closed by a " + partner(last.character);
        }
    }

    /** The line with blanks in the place of comments and of what is inside of texts. */
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
            brackets = opened == null ? "the bracket " + place.character + " of line " + place.line + " closes none that is open"
                : "the bracket " + opened.character + " of line " + opened.line + " is closed by a " + place.character + " in line " + place.line;
        }
    }

    private static String partner(String opening) {
        return CLOSING.substring(OPENING.indexOf(opening), OPENING.indexOf(opening) + 1);
    }

    /** As it stands in the script; empty if there is no such line. */
    public String line(int number) {
        return number >= 1 && number <= lines.size() ? lines.get(number - 1) : "";
    }

    /** Its code: texts are empty, comments are gone. */
    public String code(int number) {
        return number >= 1 && number <= code.size() ? code.get(number - 1) : "";
    }

    /** The last line before one that is more than a comment; 0 if there is none. */
    int before(int number) {
        int line = number - 1;
        while (line > 0 && code(line).isBlank()) {
            line--;
        }
        return line;
    }

    /** The first character outside of texts and comments that Python does not know; null if there is none. */
    public Place foreign() {
        return foreign;
    }

    /** Where the first text begins that is not closed; null if all are. */
    Place textLeftOpen() {
        return textLeftOpen;
    }

    /** What is wrong with the brackets until a line; empty if nothing is. */
    String brackets(int line) {
        return bracketsLine <= line ? brackets : "";
    }
}
