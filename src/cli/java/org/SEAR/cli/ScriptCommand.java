package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.SEAR.project.Project;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.Problem;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code sear script FOLDER_OR_FILE.sear}: the Python script that makes a project. */
@Command(name = "script", mixinStandardHelpOptions = true,
    description = "Prints the Python script that makes a project's objects; run in a project with the same assets, it gives the same files.",
    footer = "Exit status: 0, or 2 when the project has problems, which are printed.")
final class ScriptCommand implements Callable<Integer> {
    private static final int PROBLEMS = 2;
    private static final String PROJECT = "SEARproject";

    @Parameters(paramLabel = "FOLDER_OR_FILE.sear", arity = "0..1", defaultValue = PROJECT,
        description = "A SEARproject folder, the folder that it lies in, or a bundle. Default: ${DEFAULT-VALUE}.")
    private Path path;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter err = spec.commandLine().getErr();
        if (!Files.exists(path)) {
            err.println("sear script: " + path + " can't be read: there is no such file or folder");
            return PROBLEMS;
        }
        try {
            Path inside = path.resolve(PROJECT);
            List<String> script = Files.isDirectory(path) ? look(Project.read(Files.isDirectory(inside) ? inside : path))
                : Bundle.check(path, new PercentProgress("reading", path, err::println), ScriptCommand::look);
            spec.commandLine().getOut().print(script.get(0));
            spec.commandLine().getOut().flush();
            return ExitCode.OK;
        } catch (ProjectException e) {
            for (Problem problem : e.getProblems()) {
                err.println(problem);
            }
        } catch (IOException e) {
            err.println("sear script: " + path + " can't be read: " + FileReasons.of(e));
        }
        return PROBLEMS;
    }

    private static List<String> look(Project project) {
        return List.of(ProjectScript.of(project));
    }
}
