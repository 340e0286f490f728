// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import picocli.CommandLine.Command;

/** {@code sear script FOLDER_OR_FILE.sear}: the Python script that makes a project. */
@Command(name = "script", mixinStandardHelpOptions = true,
    description = "Prints a Python script that creates a project's objects; with the same assets it creates "
    + "the same files.",
    footer = "Exit status: 0, or 2 after printing the project's problems.")
final class ScriptCommand extends ProjectCommand {
    @Override
    String doing() {
        return "reading";
    }

    @Override
    List<String> look(Project project) {
        return List.of(ProjectScript.of(project));
    }

    @Override
    void print(List<String> found, Path of, PrintWriter out) {
        out.print(found.get(0));
        out.flush();
    }

    @Override
    void print(ProjectException problems, Path of, PrintWriter out, PrintWriter err) {
        problems.getProblems().forEach(err::println);
    }
}
