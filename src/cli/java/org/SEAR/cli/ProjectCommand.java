// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.SEAR.files.LongWork;
import org.SEAR.files.PrintableText;
import org.SEAR.project.Project;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import org.myrobotlab.service.sear.files.ExampleBundles;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** A command that reads a project from a folder or a bundle. Exit status 0, or 2 with every problem printed. */
abstract class ProjectCommand implements Callable<Integer> {
    private static final int PROBLEMS = 2;
    private static final String PROJECT = "SEARproject";

    @Parameters(paramLabel = "FOLDER_OR_FILE.sear", arity = "0..1", defaultValue = PROJECT,
        description = "A SEARproject folder, its parent folder, or a bundle; examples are found from any folder. "
            + "Default: ${DEFAULT-VALUE}.")
    private Path path;
    @Spec
    private CommandSpec spec;

    /** Returns the word for progress messages, such as {@code checking}. */
    abstract String doing();

    /** Returns the lines to print for a project. */
    abstract List<String> look(Project project) throws ProjectException;

    /** Prints the result. */
    abstract void print(List<String> found, Path of, PrintWriter out);

    /** Prints the problems. */
    abstract void print(ProjectException problems, Path of, PrintWriter out, PrintWriter err);

    @Override
    public Integer call() {
        PrintWriter out = PrintableText.writer(spec.commandLine().getOut());
        PrintWriter err = PrintableText.writer(spec.commandLine().getErr());
        String unreadable = "sear " + spec.name() + ": " + path + " can't be read: ";
        Runnable reported = LongWork.listen(err::println);
        try {
            print(ExampleBundles.with(path, found -> read(found, err)), path, out);
            return ExitCode.OK;
        } catch (NoSuchFileException e) {
            err.println(unreadable + "there is no such file or folder");
        } catch (ProjectException e) {
            print(e, path, out, err);
        } catch (IOException e) {
            err.println(unreadable + FileReasons.of(e));
        } finally {
            reported.run();
        }
        return PROBLEMS;
    }

    private List<String> read(Path found, PrintWriter err) throws IOException, ProjectException {
        if (!Files.exists(found)) {
            throw new NoSuchFileException(found.toString());
        }
        Path inside = found.resolve(PROJECT);
        return Files.isDirectory(found) ? look(Project.read(Files.isDirectory(inside) ? inside : found))
            : Bundle.check(found, new PercentProgress(doing(), path, err::println), this::look);
    }
}
