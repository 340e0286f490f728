// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Stream;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;

/** Project in its own folder, and its simulation. */
final class BenchmarkProject implements AutoCloseable {
    private final Path folder;
    private final boolean temporary;
    private final Simulation simulation;

    /**
     * Writes the project if it is missing, and reads it.
     * @param kept folder that keeps the project; null for a temporary folder
     * @param build adds the objects to the present project
     */
    BenchmarkProject(Path kept, Runnable build) {
        try {
            temporary = kept == null;
            folder = temporary ? Files.createTempDirectory("sear-benchmark") : kept;
            Path project = folder.resolve("SEARproject");
            System.setProperty("sear.project", project.toString());
            if (!Files.exists(project)) {
                build.run();
            }
            simulation = Simulation.of(Project.read(Project.presentFolder()), 1);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (ProjectException e) {
            throw new IllegalStateException(e);
        }
    }

    Simulation getSimulation() {
        return simulation;
    }

    @Override
    public void close() {
        simulation.close();
        if (!temporary) {
            return;
        }
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : (Iterable<Path>) files.sorted(Comparator.reverseOrder())::iterator) {
                Files.delete(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
