// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;

/** Checks whether a project would start, and with which warnings. Any thread. */
public final class ProjectCheck {
    private ProjectCheck() {
    }

    /**
     * Builds the world of a project and takes one step in it. Only that finds a model that can't be loaded, a robot
     * without Dynamics, or one that tips over.
     *
     * @return the warnings of a start
     * @throws ProjectException with the problems that prevent a start
     */
    public static List<String> warnings(Project project) throws ProjectException {
        try (Simulation world = Simulation.of(project, 0)) {
            world.step();
            return world.snapshot().warnings;
        } catch (RuntimeException | StackOverflowError | OutOfMemoryError e) {
            throw new ProjectException(List.of(new Problem(project.getFolder().getFileName().toString(), 0, "",
                "SEAR can't build its world (" + e + ")",
                "objects that SEAR can simulate; remove objects until the project starts, and report the "
                    + "last one removed")));
        }
    }
}
