package org.SEAR.lessons;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.record.Rerun;
import org.SEAR.record.RunRecord;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.RunListener;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * What a check has of a pupil's run, and where it says what it finds. Of a record only the commands are believed: they are given to a world of the
 * lesson's own, and where the robots come to in that is what counts. Public because checks in Python call it. One thread.
 */
public final class LessonRun {
    /** A record of more bytes is not of a lesson. */
    private static final long LARGEST_RECORD = 1L << 26;
    private static final long LARGEST_FILE = 1L << 20;

    private final Map<String, Trail> trails = new LinkedHashMap<>();
    private final List<String> byHand = new ArrayList<>();
    private final List<String> missing = new ArrayList<>();
    private final Map<String, Double> measures = new LinkedHashMap<>();
    private final Path folder;
    private final String script;
    private final String printed;
    private double seconds;
    private int asked;

    /**
     * One in which nothing has happened yet.
     *
     * @param folder in which the script ran
     * @param script its text
     * @param printed what it printed
     */
    public LessonRun(Project project, Path folder, String script, String printed) {
        this.folder = folder;
        this.script = script;
        this.printed = printed;
        for (SEARrobot robot : project.getRobots()) {
            trails.put(robot.getName(), new Trail(robot.getName()));
        }
    }

    /**
     * Gives the commands of a record to a new world.
     *
     * @param most simulated seconds that count; what comes later is left out
     * @throws IOException if the record can't be run again, for example since it is of another world
     */
    public void follow(Path record, Project project, double most) throws IOException, ProjectException {
        if (Files.size(record) > LARGEST_RECORD) {
            throw new IOException("the record of the run has " + Files.size(record) + " bytes, legal: at most " + LARGEST_RECORD);
        }
        try {
            Rerun.of(RunRecord.open(record), project, new Watcher(most));
        } catch (EndOfTime e) {
            seconds = most;
        }
    }

    /** What counts has been seen. */
    private static final class EndOfTime extends RuntimeException {
        private static final long serialVersionUID = 1L;

        EndOfTime() {
            super("", null, false, false);
        }
    }

    /** Sees the world after each step. */
    private final class Watcher implements java.util.function.Consumer<Simulation>, RunListener {
        private final double most;
        private boolean begun;
        private double last;

        Watcher(double most) {
            this.most = most;
        }

        @Override
        public void accept(Simulation world) {
            if (!begun) {
                begun = true;
                world.setThreads(1);
                world.setListener(this, true);
            } else if (world.getTime() <= last) {
                trails.values().forEach(Trail::clear);
                byHand.clear();
            }
            last = world.getTime();
            if (last > most) {
                throw new EndOfTime();
            }
            seconds = last;
            for (Robot robot : world.getRobots()) {
                trails.get(robot.getObject().getName()).add(last, robot.getPose(), last > 0 && robot.getTruth().isTouched(null));
            }
        }

        @Override
        public void order(BodyOrder order) {
            hand(order.name + " was pushed or given a velocity");
        }

        @Override
        public void moved(String name, Pose start, Pose to) {
            hand(name + " was put elsewhere");
        }

        private void hand(String what) {
            byHand.add(String.format(Locale.ROOT, "%s at %.1f s", what, last));
        }
    }

    /** Simulated seconds since the start, or since the last reset. */
    public double getSeconds() {
        return seconds;
    }

    /** What the only robot did, or the first of several. */
    public Trail getRobot() {
        return trails.values().iterator().next();
    }

    /** What a robot did; null if there is none of that name. */
    public Trail trail(String name) {
        return trails.get(name);
    }

    /** What was moved by pushes, velocities and edits instead of being driven, each with its time. */
    public List<String> getByHand() {
        return byHand;
    }

    /** The text of the script. */
    public String getScript() {
        return script;
    }

    /** All that the script printed. */
    public String getPrinted() {
        return printed;
    }

    /** A text file that the script wrote in its folder; None if there is none, or one of more than a megabyte. */
    public String file(String name) throws IOException {
        Path file = folder.resolve(name);
        if (!file.normalize().startsWith(folder.normalize()) || !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                || Files.size(file) > LARGEST_FILE) {
            return null;
        }
        return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    }

    /**
     * Asks for one thing.
     *
     * @param isThere whether it is there
     * @param words what is said if it is not: what was measured and what is wanted
     * @return isThere
     */
    public boolean ask(boolean isThere, String words) {
        asked++;
        if (!isThere) {
            missing.add(words);
        }
        return isThere;
    }

    /** Keeps a number for the table of marks. */
    public void measure(String what, double number) {
        measures.put(what, number);
    }

    /** How many things were asked for. */
    public int getAsked() {
        return asked;
    }

    /** What is said of those that are not there. */
    public List<String> getMissing() {
        return missing;
    }

    /** The numbers that were kept, by what they are. */
    public Map<String, Double> getMeasures() {
        return measures;
    }
}
