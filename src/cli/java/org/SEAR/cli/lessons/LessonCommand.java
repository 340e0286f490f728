// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code sear lesson NAME FOLDER}: copies a lesson for a pupil. */
@Command(name = "lesson", mixinStandardHelpOptions = true,
    description = "Copies a lesson to a folder: its page README.md, its world SEARproject and its initial "
    + "script NAME.py.",
    footer = "Exit status: 0, or 2 if it can't be copied.")
public final class LessonCommand implements Callable<Integer> {
    @Parameters(index = "0", paramLabel = "NAME", description = "A lesson that sear lessons lists, or the folder of a "
        + "teacher's own lesson.")
    private String name;
    @Parameters(index = "1", paramLabel = "FOLDER", arity = "0..1", description = "Created if missing. Default: NAME.")
    private Path folder;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        PrintWriter out = spec.commandLine().getOut();
        try {
            Lesson lesson = Lesson.find(name);
            Path to = folder == null ? Path.of(lesson.getName()) : folder;
            lesson.handOut(to);
            String script = lesson.script().getFileName().toString();
            out.println(lesson.title() + " is in " + to + ". Read " + to.resolve("README.md")
                + ", then, in that folder:");
            out.println("  sear " + script + "          runs the script, with a window and tabs");
            out.println("  sear grade " + script + "    says what it lacks");
            out.flush();
            return ExitCode.OK;
        } catch (IOException | ProjectException e) {
            spec.commandLine().getErr().println("sear lesson: " + FileReasons.of(e));
            return ExitCode.USAGE;
        }
    }
}
