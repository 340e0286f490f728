// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.lessons;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.SEAR.files.PrintableText;
import org.SEAR.project.problems.FileReasons;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code sear grade SCRIPT.py} for a pupil, {@code sear grade FOLDER} for a teacher. */
@Command(name = "grade", mixinStandardHelpOptions = true,
    description = "Marks a script and says what it lacks to pass its lesson; or marks all scripts in a folder, or in "
    + "its subfolders named after "
        + "pupils. Each script runs in its own process, without a window and in lock-step.",
    footer = "Exit status: 0 when all have passed, 1 when not, 2 for an invalid command.")
public final class GradeCommand implements Callable<Integer> {
    private static final int MIN_MEMORY = 128;

    @Parameters(paramLabel = "SCRIPT.py|FOLDER", description = "The script or folder to mark.")
    private Path path;
    @Option(names = "--lesson", paramLabel = "NAME|FOLDER", description = "Lesson of all scripts. Default: each "
        + "script's name, as square.py.")
    private String lesson;
    @Option(names = "--limit", paramLabel = "SECONDS", defaultValue = "60",
        description = "Limit of a script's processor time, and of the time "
        + "in which it does nothing; ten times as long by the computer's clock. Default: ${DEFAULT-VALUE}.")
    private double limit;
    @Option(names = "--memory", paramLabel = "MB", defaultValue = "512", description = "Memory limit of a script with "
        + "all processes that it starts. "
        + " Default: ${DEFAULT-VALUE}.")
    private int memory;
    @Option(names = "--jobs", paramLabel = "N", description = "Scripts to run in parallel. Default: the number "
        + "of processors.")
    private Integer jobs;
    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "Seed of the sensors' random "
        + "numbers, the same for all "
        + "scripts. Default: ${DEFAULT-VALUE}.")
    private long seed;
    @Option(names = "--python3", description = "Run all scripts with Python 3; otherwise only those whose first line "
        + "is #!/usr/bin/env python3.")
    private boolean python3;
    @Option(names = "--out", paramLabel = "FOLDER", description = "Folder for marks.csv, marks.txt and marks.xml "
        + "(JUnit). Default: marks for a "
        + "folder, none for a script.")
    private Path out;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        check(limit > 0, "--limit is " + limit + ", legal: seconds above 0");
        check(memory >= MIN_MEMORY, "--memory is " + memory + ", legal: " + MIN_MEMORY + " megabytes or more");
        check(jobs == null || jobs > 0, "--jobs is " + jobs + ", legal: 1 or more");
        PrintWriter err = PrintableText.writer(spec.commandLine().getErr());
        try {
            List<Submission> all = Submission.in(path, lesson == null ? null : Lesson.find(lesson));
            boolean isOne = Files.isRegularFile(path);
            Path to = out == null && !isOne ? Path.of("marks") : out;
            if (to != null) {
                MarkTables.write(List.of(), to);
            }
            List<Mark> marks = new Marking(limit, memory, seed, python3)
                .all(all, jobs == null ? Runtime.getRuntime().availableProcessors() : jobs,
                (mark, ready) -> {
                    if (!isOne) {
                        err.println(ready.size() + " of " + all.size() + ": " + mark.pupil + ", " + mark.lesson + ": "
                            + mark.kind.words);
                    }
                    store(ready, to, err);
                });
            if (to != null) {
                MarkTables.write(marks, to);
            }
            report(marks, isOne, to);
            return marks.stream().allMatch(Mark::isPassed) ? ExitCode.OK : ExitCode.SOFTWARE;
        } catch (IOException e) {
            err.println("sear grade: " + FileReasons.of(e));
            return ExitCode.USAGE;
        }
    }

    /** Writes the marks that are ready, so that they outlive this program; a failure may pass before the last mark. */
    private static void store(List<Mark> ready, Path to, PrintWriter err) {
        if (to == null) {
            return;
        }
        try {
            MarkTables.write(ready, to);
        } catch (IOException e) {
            err.println("sear grade: the marks could not be written: " + FileReasons.of(e));
        }
    }

    private void check(boolean isLegal, String what) {
        if (!isLegal) {
            throw new ParameterException(spec.commandLine(), what);
        }
    }

    private void report(List<Mark> marks, boolean isOne, Path to) {
        PrintWriter screen = PrintableText.writer(spec.commandLine().getOut());
        if (isOne) {
            Mark mark = marks.get(0);
            screen.println(mark.isPassed() ? "Passed: all " + mark.asked + " of " + mark.asked
                + " requirements of lesson " + mark.lesson + "."
                : "Not yet: " + (mark.asked == 0 ? "" : mark.got + " of " + mark.asked + " requirements of ")
                    + "lesson " + mark.lesson + ".");
            mark.missing.forEach(what -> screen.println("- " + what));
        } else {
            screen.print(MarkTables.text(marks));
        }
        if (to != null) {
            screen.println();
            screen.println("Written: " + to.resolve("marks.csv") + ", marks.txt, marks.xml");
        }
        screen.flush();
    }
}
