// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.problems;

import java.util.List;
import java.util.stream.Collectors;

/** Thrown for an invalid project, object or bundle, with all its problems. */
public class ProjectException extends Exception {
    private static final long serialVersionUID = 1L;
    private final transient List<Problem> problems;

    public ProjectException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** Returns all problems, at least one. */
    public List<Problem> getProblems() {
        return problems;
    }
}
