// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.xml;

import java.util.Map;

/** An object that was read, with the line numbers of its elements. Immutable. */
public final class ParsedObject {
    /** The object; null if it is invalid. */
    public final Object object;
    /** Name of the file in problems. */
    public final String file;
    private final int rootLine;
    private final Map<String, Integer> lines;

    ParsedObject(Object object, String file, int rootLine, Map<String, Integer> lines) {
        this.object = object;
        this.file = file;
        this.rootLine = rootLine;
        this.lines = lines;
    }

    /** Returns the result for an invalid file, whose problems have been reported. */
    public static ParsedObject broken(String file, int rootLine) {
        return new ParsedObject(null, file, rootLine, Map.of());
    }

    /** Returns whether the file was invalid; its problems have been reported. */
    public boolean isBroken() {
        return object == null;
    }

    /**
     * Returns the line of an element, or that of the root element if unknown. Entries of a list are
     * {@code component#2}, counted from 0.
     */
    public int line(String element) {
        return lines.getOrDefault(element, rootLine);
    }
}
