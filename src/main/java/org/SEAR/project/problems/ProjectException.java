package org.SEAR.project.problems;

import java.util.List;
import java.util.stream.Collectors;

/** A project, object or bundle that can't be used; names every problem at once. */
public class ProjectException extends Exception {
    private static final long serialVersionUID = 1L;
    private final transient List<Problem> problems;

    public ProjectException(List<Problem> problems) {
        super(problems.stream().map(Problem::toString).collect(Collectors.joining("\n")));
        this.problems = List.copyOf(problems);
    }

    /** All problems, at least one. */
    public List<Problem> getProblems() {
        return problems;
    }
}
