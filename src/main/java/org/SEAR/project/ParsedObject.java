package org.SEAR.project;

import java.util.Map;

/** An object as it was read, with the lines on which its elements stand. Immutable. */
final class ParsedObject {
    final Object object;
    final String file;
    private final int rootLine;
    private final Map<String, Integer> lines;

    ParsedObject(Object object, String file, int rootLine, Map<String, Integer> lines) {
        this.object = object;
        this.file = file;
        this.rootLine = rootLine;
        this.lines = lines;
    }

    /** A file whose problems have been reported. */
    static ParsedObject broken(String file, int rootLine) {
        return new ParsedObject(null, file, rootLine, Map.of());
    }

    boolean isBroken() {
        return object == null;
    }

    /** Line of an element, else of the root element. Entries of a list are {@code component#2}, counted from 0. */
    int line(String element) {
        return lines.getOrDefault(element, rootLine);
    }
}
