// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.problems;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.files.PrintableText;

/** Collects the problems of a project, file by file. */
public final class ProblemList {
    private static final int LONGEST_VALUE = 80;
    /** Largest number of problems; further ones are dropped. */
    private static final int MOST = 1000;

    private final List<Problem> problems = new ArrayList<>();

    /** Adds a problem, with its value shortened. The parameters are those of {@link Problem}. */
    public void add(String file, int line, String field, Object value, String legal) {
        if (!isFull()) {
            problems.add(new Problem(file, line, field, shortened(String.valueOf(value)), legal));
        }
    }

    /** Adds the problems of another list up to the limit. */
    public void addAll(ProblemList others) {
        problems.addAll(others.problems.subList(0, Math.min(others.size(), MOST - size())));
    }

    private static String shortened(String value) {
        boolean isLong = value.codePointCount(0, value.length()) > LONGEST_VALUE;
        return PrintableText.line(isLong ? value.substring(0, value.offsetByCodePoints(0, LONGEST_VALUE))
            + "..." : value);
    }

    public int size() {
        return problems.size();
    }

    /** Returns whether the list drops further problems, so checks can stop. */
    public boolean isFull() {
        return problems.size() >= MOST;
    }

    public boolean isEmpty() {
        return problems.isEmpty();
    }

    @Override
    public String toString() {
        return problems.stream().map(Problem::toString).collect(Collectors.joining("; "));
    }

    /**
     * Throws the problems, if there are any.
     *
     * @throws ProjectException with all problems
     */
    public void throwIfAny() throws ProjectException {
        if (!problems.isEmpty()) {
            throw new ProjectException(problems);
        }
    }
}
