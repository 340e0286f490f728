// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.ProjectCheck;
import picocli.CommandLine.Command;

/** {@code sear check FOLDER_OR_FILE.sear}: 0, or 2 and every problem. */
@Command(name = "check", mixinStandardHelpOptions = true,
    description = "Reads a project or bundle and prints every problem: file, line, field, value and what is legal.",
    footer = "Exit status: 0 without problems, 2 with problems.")
final class CheckCommand extends ProjectCommand {
    @Override
    String doing() {
        return "checking";
    }

    @Override
    List<String> look(Project project) throws ProjectException {
        return ProjectCheck.warnings(project);
    }

    @Override
    void print(List<String> found, Path of, PrintWriter out) {
        found.forEach(warning -> out.println("warning: " + warning));
        out.println(of + ": no problems");
    }

    @Override
    void print(ProjectException problems, Path of, PrintWriter out, PrintWriter err) {
        problems.getProblems().forEach(out::println);
        err.println(of + ": problems: " + problems.getProblems().size());
    }
}
