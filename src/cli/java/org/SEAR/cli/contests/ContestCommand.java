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
import org.SEAR.project.Project;
import org.SEAR.project.ProjectSwap;
import org.SEAR.project.bundle.Bundle;
import org.SEAR.project.bundle.PercentProgress;
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
    description = "Has each script drive a robot of its own in one world, without a window and in lock-step, asks the contest's referee, and prints"
        + " the scoreboard.",
    footer = "Exit status: 0 when the contest came to its end, 1 when a script has ended the program, 2 when the command, world or referee makes no"
        + " sense.")
public final class ContestCommand implements Callable<Integer> {
    private static final String WORLD = "world.sear";
    private static final String REFEREE = "referee.py";

    @Parameters(index = "0", paramLabel = "FOLDER", description = "The contest: world.sear and referee.py.")
    private Path folder;
    @Parameters(index = "1..*", arity = "1..*", paramLabel = "[NAME=]SCRIPT.py", description = "The entries; each is called as its file, or NAME.")
    private List<String> scripts;
    @Option(names = "--seed", paramLabel = "N", defaultValue = "1", description = "Where the random numbers of the sensors begin. Default: "
        + "${DEFAULT-VALUE}.")
    private long seed;
    @Option(names = "--limit", paramLabel = "SECONDS", defaultValue = "10", description = "How long a script may go on without a simSleep, and a "
        + "function of the referee, by the computer's clock. Default: ${DEFAULT-VALUE}.")
    private double limit;
    @Option(names = "--out", paramLabel = "FOLDER", defaultValue = "result", description = "Where scores.csv, the record contest.searlog and what "
        + "each script has printed go. Default: ${DEFAULT-VALUE}.")
    private Path out;
    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() throws InterruptedException {
        if (!(limit > 0)) {
            throw new ParameterException(spec.commandLine(), "--limit is " + limit + ", legal: above 0");
        }
        PrintWriter err = spec.commandLine().getErr();
        try {
            for (String part : List.of(WORLD, REFEREE)) {
                if (!Files.isRegularFile(folder.resolve(part))) {
                    throw new IOException(folder + " is no contest, it lacks " + part);
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
            String name = one.contains("=") ? one.substring(0, one.indexOf('=')) : script.getFileName().toString().replaceFirst("\\.py$", "");
            if (!Files.isRegularFile(script)) {
                throw new IOException(script + " can't be read: there is no such file");
            }
            if (!name.matches("[\\w][\\w .-]*")) {
                throw new IOException("the name of entry \"" + name + "\" is not legal: letters of English, digits, _, blanks, - and .; NAME="
                    + script + " gives it another");
            }
            if (entered.put(name, script) != null) {
                throw new IOException("two entries are called \"" + name + "\"; NAME=" + script + " gives one another name");
            }
        }
        return entered;
    }

    private void run(Map<String, Path> entered) throws IOException, ProjectException, InterruptedException {
        Path unpacked = Files.createTempDirectory("sear-contest");
        Referee referee = new Referee(folder.resolve(REFEREE), limit);
        try {
            Project project = Bundle.load(folder.resolve(WORLD), unpacked.resolve("SEARproject"),
                new PercentProgress("opening", folder, line -> { }));
            Contest contest = new Contest(project, entered, seed, limit);
            contest.run(referee, out.resolve("contest.searlog"));
            for (Entrant entry : contest.getEntries()) {
                Files.writeString(out.resolve(entry.getName() + ".txt"), entry.printed());
            }
            report(contest, referee.takePrinted());
        } finally {
            referee.close();
            ProjectSwap.delete(unpacked);
        }
    }

    private void report(Contest contest, String said) throws IOException {
        PrintWriter screen = spec.commandLine().getOut();
        StringBuilder csv = new StringBuilder("place,entry,points,time,bumps,why\n");
        screen.print(said);
        screen.printf("%-6s %-16s %8s %8s %6s  %s%n", "place", "entry", "points", "time", "bumps", "why");
        for (Entrant entry : contest.ranking()) {
            String points = number("%.6f", entry.getPoints()).replaceFirst("\\.?0+$", "");
            String why = String.valueOf(entry.getWhy());
            String time = Double.isInfinite(entry.getTime()) ? "" : number("%.2f", entry.getTime());
            screen.printf("%-6d %-16s %8s %8s %6d  %s%n", contest.place(entry), entry.getName(), points, time, entry.getBumps(), why);
            csv.append(contest.place(entry)).append(',').append(entry.getName()).append(',').append(points).append(',').append(time).append(',')
                .append(entry.getBumps()).append(",\"").append(why.replace("\"", "\"\"")).append("\"\n");
        }
        Files.write(out.resolve("scores.csv"), csv.toString().getBytes(StandardCharsets.UTF_8));
        screen.println();
        screen.println("Written: " + out.resolve("scores.csv") + ", contest.searlog to watch it, and what each script has printed");
        screen.flush();
    }

    private static String number(String form, double value) {
        return String.format(Locale.ROOT, form, value);
    }
}
