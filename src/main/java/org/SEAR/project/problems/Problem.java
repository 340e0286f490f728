// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.problems;

/** One problem of a project: location, value and legal values. Immutable. */
public final class Problem {
    public final String file;
    public final int line;
    public final String field;
    public final String value;
    public final String legal;

    /**
     * @param file relative to the project
     * @param line from 1, 0 if unknown
     * @param field may be empty
     * @param legal the legal values, in words
     */
    public Problem(String file, int line, String field, String value, String legal) {
        this.file = file;
        this.line = line;
        this.field = field;
        this.value = value;
        this.legal = legal;
    }

    /** Returns the message: {@code environment/Box1.xml:4: mass is "-1", legal: 0 to 1e6 kg}. */
    @Override
    public String toString() {
        return file + (line > 0 ? ":" + line : "") + ": " + (field.isEmpty() ? value : field + " is \"" + value + "\"")
            + ", legal: " + legal;
    }
}
