package org.SEAR.cli.contests;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.record.Recorder;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;
import picocli.CommandLine.ExitCode;

/**
 * One simulation in which each script drives its own robot, in lock-step: before each step the scripts whose time has come go on one after the
 * other, in the order of the entries, each until it waits. So the same scripts and seed give the same contest. Public because referees in Python
 * call it; the contest's thread.
 */
public final class Contest {
    private static final Comparator<Entrant> BETTER = Comparator.comparing(Entrant::isDisqualified)
        .thenComparing(Comparator.comparingDouble(Entrant::getPoints).reversed()).thenComparingDouble(Entrant::getTime);

    private final Simulation world;
    private final List<Entrant> entries = new ArrayList<>();
    private final double timeout;
    private String over;

    /**
     * A contest that has not begun.
     *
     * @param scripts by the entrants' names; each gets the next robot of the world
     * @param patience how long a script may go on without waiting, seconds of the computer's clock
     * @throws IOException if there are too many for the robots
     */
    Contest(Project project, Map<String, Path> scripts, long seed, double patience) throws IOException, ProjectException {
        this.timeout = patience;
        if (scripts.size() > project.getRobots().size()) {
            throw new IOException("there are " + scripts.size() + " scripts, but the world has " + project.getRobots().size() + " robots");
        }
        world = Simulation.of(project, seed);
        List<Robot> robots = world.getRobots();
        scripts.forEach((name, script) -> entries.add(new Entrant(name, script, world, robots.get(entries.size()))));
    }

    /**
     * Runs it to its end.
     *
     * @param record where it is recorded
     * @throws IOException with the error of the referee
     */
    void run(Referee referee, Path record) throws IOException, InterruptedException {
        Files.createDirectories(record.toAbsolutePath().getParent());
        List<String> reported = new ArrayList<>();
        Recorder recorder = Recorder.begin(world, record, Recorder.LIMIT, reported::add);
        Thread exit = new Thread(this::reportExits);
        Runtime.getRuntime().addShutdownHook(exit);
        try {
            referee.call("positions", this);
            checkRobots();
            entries.forEach(Entrant::begin);
            referee.call("started", this);
            while (over == null && entries.stream().anyMatch(Entrant::isDriving) && world.getTime() < referee.getSeconds()) {
                for (Entrant entry : entries) {
                    entry.go(timeout);
                }
                world.step();
                entries.forEach(Entrant::look);
                referee.call("stepped", this);
            }
            entries.forEach(entry -> entry.timeIsOver(over == null ? "the time was over" : over));
            referee.call("finished", this);
        } finally {
            Runtime.getRuntime().removeShutdownHook(exit);
            recorder.leave();
            recorder.end();
            for (Entrant entry : entries) {
                entry.end();
            }
            world.close();
        }
    }

    /** The process ends in the middle of the contest: if a script has called for that, nobody shall take it for a contest that came to its end. */
    private void reportExits() {
        entries.stream().filter(Entrant::exits).findFirst().ifPresent(entry -> {
            System.err.printf(Locale.ROOT, "sear contest: the script of %s has ended the whole program at %.1f s, so there are no scores;"
                + " hold the contest without it, or have it end with sys.exit() in place of os._exit()%n", entry.getName(), world.getTime());
            System.err.flush();
            Runtime.getRuntime().halt(ExitCode.SOFTWARE);
        });
    }

    private void checkRobots() throws IOException {
        if (entries.stream().map(Entrant::getRobot).distinct().count() < entries.size()) {
            throw new IOException("the referee has given one robot to two entries");
        }
    }

    /** All who take part, in the order in which they were entered. */
    public List<Entrant> getEntries() {
        return entries;
    }

    /** Simulated seconds since the start. */
    public double getTime() {
        return world.getTime();
    }

    /** Ends the contest after this step. */
    public void end(String words) {
        over = words;
    }

    /** The best first. */
    List<Entrant> ranking() {
        List<Entrant> all = new ArrayList<>(entries);
        all.sort(BETTER);
        return all;
    }

    /** From 1 on; who is as good as another has the same place. */
    int place(Entrant entry) {
        return 1 + (int) entries.stream().filter(one -> BETTER.compare(one, entry) < 0).count();
    }
}
