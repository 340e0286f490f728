package org.SEAR.project.xml;

import java.util.Map;

/** An object as it was read, with the lines on which its elements stand. Immutable. */
public final class ParsedObject {
    /** The object; null if it is broken. */
    public final Object object;
    /** As problems name it. */
    public final String file;
    private final int rootLine;
    private final Map<String, Integer> lines;

    ParsedObject(Object object, String file, int rootLine, Map<String, Integer> lines) {
        this.object = object;
        this.file = file;
        this.rootLine = rootLine;
        this.lines = lines;
    }

    /** A file whose problems have been reported. */
    public static ParsedObject broken(String file, int rootLine) {
        return new ParsedObject(null, file, rootLine, Map.of());
    }

    /** Whether its problems have been reported. */
    public boolean isBroken() {
        return object == null;
    }

    /** Line of an element, else of the root element. Entries of a list are {@code component#2}, counted from 0. */
    public int line(String element) {
        return lines.getOrDefault(element, rootLine);
    }
}
