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
import org.SEAR.simulator.ProjectCheck;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code sear check FOLDER_OR_FILE.sear}: 0, or 2 and every problem. */
@Command(name = "check", mixinStandardHelpOptions = true,
    description = "Reads a project or bundle and prints everything that is wrong with it: file, line, field, value, what is legal.",
    footer = "Exit status: 0 when all is well, 2 when there are problems.")
final class CheckCommand implements Callable<Integer> {
    private static final int PROBLEMS = 2;
    private static final String PROJECT = "SEARproject";

    @Parameters(paramLabel = "FOLDER_OR_FILE.sear", arity = "0..1", defaultValue = PROJECT,
        description = "A SEARproject folder, the folder that it lies in, or a bundle. Default: ${DEFAULT-VALUE}.")
    private Path path;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        PrintWriter err = spec.commandLine().getErr();
        if (!Files.exists(path)) {
            err.println("sear check: " + path + " can't be read: there is no such file or folder");
            return PROBLEMS;
        }
        try {
            List<String> warnings = Files.isDirectory(path) ? ProjectCheck.warnings(Project.read(project()))
                : Bundle.check(path, new PercentProgress("checking", path, err::println), ProjectCheck::warnings);
            warnings.forEach(warning -> out.println("warning: " + warning));
            out.println(path + ": no problems");
            return ExitCode.OK;
        } catch (ProjectException e) {
            for (Problem problem : e.getProblems()) {
                out.println(problem);
            }
            err.println(path + ": problems: " + e.getProblems().size());
        } catch (IOException e) {
            err.println("sear check: " + path + " can't be read: " + FileReasons.of(e));
        }
        return PROBLEMS;
    }

    private Path project() {
        Path inside = path.resolve(PROJECT);
        return Files.isDirectory(inside) ? inside : path;
    }
}
