// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.Properties;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.problems.ProjectException;
import org.myrobotlab.service.Runtime;
import org.python.util.PythonInterpreter;

/**
 * Makes the example projects: runs each script of examples/ in an empty project and saves the project.
 * {@code gradle examples} calls it.
 */
public final class ExampleMaker {
    private ExampleMaker() {
    }

    /** @param args the folder of the scripts */
    public static void main(String[] args) throws IOException, ProjectException {
        Path folder = Paths.get(args[0]);
        for (Path script : scripts(folder)) {
            Path project = Files.createTempDirectory("sear-example").resolve("SEARproject");
            System.setProperty("sear.project", project.toString());
            run(script);
            Bundle.save(project, bundle(script));
            ProjectSwap.delete(project.getParent());
        }
    }

    static List<Path> scripts(Path folder) throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.filter(f -> f.toString().endsWith(".py")).sorted().collect(Collectors.toList());
        }
    }

    static Path bundle(Path script) {
        return script.resolveSibling(script.getFileName().toString().replace(".py", ".sear"));
    }

    /** Runs a script in the present project as MyRobotLab's Python service does. */
    static void run(Path script) {
        Properties settings = new Properties();
        settings.setProperty("python.import.site", "false");
        settings.setProperty("python.cachedir.skip", "true");
        PythonInterpreter.initialize(System.getProperties(), settings, new String[0]);
        try (PythonInterpreter python = new PythonInterpreter()) {
            python.exec("from org.myrobotlab.service import Runtime");
            python.execfile(script.toString());
        } finally {
            Runtime.releaseService("sear");
        }
    }
}
