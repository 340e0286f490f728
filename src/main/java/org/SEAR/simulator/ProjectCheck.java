package org.SEAR.simulator;

import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/** What a start of a project would say, without one. Any thread. */
public final class ProjectCheck {
    private ProjectCheck() {
    }

    /**
     * Builds a world of a project and takes a step in it: a model that can't be loaded, a robot without Dynamics and one that tips over are found
     * only then.
     *
     * @return what the start would warn of
     * @throws ProjectException with what keeps it from starting
     */
    public static List<String> warnings(Project project) throws ProjectException {
        try (Simulation world = Simulation.of(project, 0)) {
            world.step();
            return world.snapshot().warnings;
        } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
            throw new ProjectException(List.of(new Problem(project.getFolder().getFileName().toString(), 0, "", "its world can't be made (" + e + ")",
                "objects that a world can be made of; take objects away until it starts, and tell SEAR's makers of the last one")));
        }
    }
}
