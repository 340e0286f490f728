// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.contests;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.SEAR.cli.lessons.ScratchFolder;
import org.SEAR.files.AtomicFile;
import org.SEAR.project.Project;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
import org.SEAR.files.PrintableText;
import org.SEAR.project.problems.FileReasons;
import org.SEAR.project.problems.ProjectException;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code sear contest FOLDER SCRIPT.py...}: runs a contest of robots. */
@Command(name = "contest", mixinStandardHelpOptions = true,
    description = "Runs a contest: each script drives its own robot in one world, without a window and in lock-step."
        + " Prints the referee's scoreboard.",
    footer = "Exit status: 0 when the contest is complete, 1 when a script ended the program, 2 for an invalid "
        + "command, world or referee.")
public final class ContestCommand implements Callable<Integer> {
    private static final String WORLD = "world.sear";
    private static final String REFEREE = "referee.py";

    @Parameters(index = "0", paramLabel = "FOLDER", description = "Folder of the contest, with world.sear "
        + "and referee.py.")
    private Path folder;
    @Parameters(index = "1..*", arity = "1..*", paramLabel = "[NAME=]SCRIPT.py",
        description = "The entries, named after their files, or NAME.")
    private List<String> scripts;
    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "Seed of the sensors' random "
        + "numbers. Default: ${DEFAULT-VALUE}.")
    private long seed;
    @Option(names = "--limit", paramLabel = "SECONDS", defaultValue = "10",
        description = "Time limit of a script without a simSleep, and of each "
        + "function of the referee, by the computer's clock. Default: ${DEFAULT-VALUE}.")
    private double limit;
    @Option(names = "--out", paramLabel = "FOLDER", defaultValue = "result", description = "Folder for scores.csv, the "
        + "recording contest.searlog and each script's output. Default: ${DEFAULT-VALUE}.")
    private Path out;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        if (!(limit > 0)) {
            throw new ParameterException(spec.commandLine(), "--limit is " + limit + ", legal: above 0");
        }
        PrintWriter err = PrintableText.writer(spec.commandLine().getErr());
        try {
            for (String part : List.of(WORLD, REFEREE)) {
                if (!Files.isRegularFile(folder.resolve(part))) {
                    throw new IOException(folder + " is not a contest: it lacks " + part);
                }
            }
            run(entered());
            return ExitCode.OK;
        } catch (IOException e) {
            err.println("sear contest: " + FileReasons.of(e));
        } catch (ProjectException e) {
            e.getProblems().forEach(err::println);
        }
        return ExitCode.USAGE;
    }

    private Map<String, Path> entered() throws IOException {
        Map<String, Path> entered = new LinkedHashMap<>();
        for (String one : scripts) {
            Path script = Path.of(one.substring(one.indexOf('=') + 1));
            String name = one.contains("=") ? one.substring(0, one.indexOf('=')) : script.getFileName().toString()
                .replaceFirst("\\.py$", "");
            if (!Files.isRegularFile(script)) {
                throw new IOException(script + " can't be read: there is no such file");
            }
            if (!name.matches("[\\w][\\w .-]*")) {
                throw new IOException("the name of entry \"" + name + "\" is invalid, legal: letters A to Z, digits, "
                    + "_, spaces, - and .; NAME=" + script + " gives it another");
            }
            if (entered.put(name, script) != null) {
                throw new IOException("two entries are called \"" + name + "\"; NAME=" + script
                    + " gives one another name");
            }
        }
        return entered;
    }

    private void run(Map<String, Path> entered) throws IOException, ProjectException, InterruptedException {
        try (ScratchFolder unpacked = ScratchFolder.create("sear-contest")) {
            Referee referee = new Referee(folder.resolve(REFEREE), limit);
            try {
                Project project = Bundle.load(folder.resolve(WORLD), unpacked.path().resolve("SEARproject"),
                    new PercentProgress("opening", folder, line -> { }));
                Contest contest = new Contest(project, entered, seed, limit);
                contest.run(referee, out.resolve("contest.searlog"), unpacked::close);
                for (Entrant entry : contest.getEntries()) {
                    AtomicFile.write(out.resolve(entry.getName() + ".txt"), entry.printed()
                        .getBytes(StandardCharsets.UTF_8));
                }
                report(contest, referee.takePrinted());
            } finally {
                referee.close();
            }
        }
    }

    private void report(Contest contest, String said) throws IOException {
        PrintWriter screen = PrintableText.writer(spec.commandLine().getOut());
        StringBuilder csv = new StringBuilder("place,entry,points,time,bumps,why\n");
        screen.print(said);
        screen.printf("%-6s %-16s %8s %8s %6s  %s%n", "place", "entry", "points", "time", "bumps", "why");
        for (Entrant entry : contest.ranking()) {
            String points = number("%.6f", entry.getPoints()).replaceFirst("\\.?0+$", "");
            String why = PrintableText.of(String.valueOf(entry.getWhy()));
            String time = Double.isInfinite(entry.getTime()) ? "" : number("%.2f", entry.getTime());
            screen.printf("%-6d %-16s %8s %8s %6d  %s%n", contest.place(entry), entry.getName(), points, time,
                entry.getBumps(), why);
            csv.append(contest.place(entry)).append(',').append(entry.getName()).append(',').append(points).append(',')
                .append(time).append(',')
                .append(entry.getBumps()).append(",\"").append(why.replace("\"", "\"\"")).append("\"\n");
        }
        AtomicFile.write(out.resolve("scores.csv"), csv.toString().getBytes(StandardCharsets.UTF_8));
        screen.println();
        screen.println("Written: " + out.resolve("scores.csv") + ", contest.searlog to watch it, and each "
            + "script's output");
        screen.flush();
    }

    private static String number(String form, double value) {
        return String.format(Locale.ROOT, form, value);
    }
}
