// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.contests;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.cli.lessons.ExitHook;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.record.Recorder;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;
import picocli.CommandLine.ExitCode;

/**
 * One simulation in lock-step in which each script drives its own robot. Before each step the scripts that are due run
 * one after the other, in the order of the entries, each until it waits. So the same scripts and seed give the same
 * contest. Public for referees in Python; the contest's thread.
 */
public final class Contest {
    private static final Comparator<Entrant> BETTER = Comparator.comparing(Entrant::isDisqualified)
        .thenComparing(Comparator.comparingDouble(Entrant::getPoints).reversed()).thenComparingDouble(Entrant::getTime);

    private final Simulation world;
    private final List<Entrant> entries = new ArrayList<>();
    private final double timeout;
    private String over;

    /**
     * Prepares a contest.
     *
     * @param scripts by the entrants' names; each gets the next robot of the world
     * @param patience time limit of a script without waiting, by the computer's clock, s
     * @throws IOException if there are more scripts than robots
     */
    Contest(Project project, Map<String, Path> scripts, long seed, double patience)
        throws IOException, ProjectException {
        this.timeout = patience;
        if (scripts.size() > project.getRobots().size()) {
            throw new IOException("there are " + scripts.size() + " scripts, but the world has " + project.getRobots()
                .size() + " robots");
        }
        world = Simulation.of(project, seed);
        List<Robot> robots = world.getRobots();
        scripts.forEach((name, script) -> entries.add(new Entrant(name, script, world, robots.get(entries.size()))));
    }

    /**
     * Runs the contest.
     *
     * @param record file of the recording
     * @param atExit called if a script ends this process
     * @throws IOException with an error of the referee
     */
    void run(Referee referee, Path record, Runnable atExit) throws IOException, InterruptedException {
        Files.createDirectories(record.toAbsolutePath().getParent());
        List<String> reported = new ArrayList<>();
        Recorder recorder = Recorder.begin(world, record, Recorder.LIMIT, reported::add);
        ExitHook exit = new ExitHook(() -> reportExits(atExit));
        try {
            referee.call("positions", this);
            checkRobots();
            entries.forEach(Entrant::begin);
            referee.call("started", this);
            while (over == null && entries.stream().anyMatch(Entrant::isDriving)
                && world.getTime() < referee.getSeconds()) {
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
            exit.cancel();
            recorder.leave();
            recorder.end();
            for (Entrant entry : entries) {
                entry.end();
            }
            world.close();
        }
    }

    /** Reports a script that ends the process during the contest, so that the contest does not look finished. */
    private void reportExits(Runnable atExit) {
        entries.stream().filter(Entrant::exits).findFirst().ifPresent(entry -> {
            System.err.printf(Locale.ROOT, "sear contest: the script of %s ended the whole program at %.1f s, so there "
                + "are no scores."
                + " Run the contest without it, or let it end with sys.exit() instead of os._exit()%n", entry.getName(),
                    world.getTime());
            System.err.flush();
            atExit.run();
            Runtime.getRuntime().halt(ExitCode.SOFTWARE);
        });
    }

    private void checkRobots() throws IOException {
        if (entries.stream().map(Entrant::getRobot).distinct().count() < entries.size()) {
            throw new IOException("the referee has given one robot to two entries");
        }
    }

    /** Returns all entrants in their order of entry. */
    public List<Entrant> getEntries() {
        return entries;
    }

    /** Returns the simulated time since the start, s. */
    public double getTime() {
        return world.getTime();
    }

    /** Ends the contest after this step. */
    public void end(String words) {
        over = words;
    }

    /** Returns the entrants, the best first. */
    List<Entrant> ranking() {
        List<Entrant> all = new ArrayList<>(entries);
        all.sort(BETTER);
        return all;
    }

    /** Returns the place from 1 on; equal entrants share a place. */
    int place(Entrant entry) {
        return 1 + (int) entries.stream().filter(one -> BETTER.compare(one, entry) < 0).count();
    }
}
