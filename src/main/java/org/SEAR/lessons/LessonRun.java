// SPDX-License-Identifier: Apache-2.0
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
 * Run of a pupil's script as a lesson's check sees it; takes the check's findings. It trusts only the commands of a
 * record: they run in the lesson's own world, and the robots' positions there count. Public because checks in Python
 * call it. One thread.
 */
public final class LessonRun {
    /** Maximum size of a lesson's record, bytes. */
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
    private boolean begun = true;

    /**
     * Creates a run without data.
     *
     * @param folder in which the script ran
     * @param script its text
     * @param printed its output
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
     * Runs the commands of a record in a new world.
     *
     * @param most simulated seconds that count; later events are ignored
     * @throws IOException if the record cannot be rerun, for example from another world
     */
    public void follow(Path record, Project project, double most) throws IOException, ProjectException {
        if (Files.size(record) > LARGEST_RECORD) {
            throw new IOException("the record of the run has " + Files.size(record) + " bytes, legal: at most "
                + LARGEST_RECORD);
        }
        try {
            Rerun.of(RunRecord.open(record), project, new Watcher(most));
        } catch (EndOfTime e) {
            seconds = most;
        }
    }

    /** Ends the rerun when the time that counts is over. */
    private static final class EndOfTime extends RuntimeException {
        private static final long serialVersionUID = 1L;

        EndOfTime() {
            super("", null, false, false);
        }
    }

    /** Receives the world after each step. */
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
                trails.get(robot.getObject().getName())
                    .add(last, robot.getPose(), last > 0 && robot.getTruth().isTouched(null));
            }
        }

        @Override
        public void order(BodyOrder order) {
            hand(order.kind == BodyOrder.Kind.GRAVITY ? "gravity was changed"
                : order.name + " was pushed or given a velocity");
        }

        @Override
        public void moved(String name, Pose start, Pose to) {
            hand(name + " was moved by an edit");
        }

        private void hand(String what) {
            byHand.add(String.format(Locale.ROOT, "%s at %.1f s", what, last));
        }
    }

    /** Returns simulated seconds since the start or last reset. */
    public double getSeconds() {
        return seconds;
    }

    /** Returns the trail of the first or only robot. */
    public Trail getRobot() {
        return trails.values().iterator().next();
    }

    /** Returns a robot's trail; null for an unknown name. */
    public Trail trail(String name) {
        return trails.get(name);
    }

    /** Returns what forces, velocities and edits moved instead of driving, each with its time. */
    public List<String> getByHand() {
        return byHand;
    }

    /** Returns the script's text. */
    public String getScript() {
        return script;
    }

    /** Returns the script's complete output. */
    public String getPrinted() {
        return printed;
    }

    /** Returns a text file that the script wrote in its folder; None if missing or above a megabyte. */
    public String file(String name) throws IOException {
        Path file = folder.resolve(name);
        if (!file.normalize().startsWith(folder.normalize()) || !Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS)
                || Files.size(file) > LARGEST_FILE) {
            return null;
        }
        return new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
    }

    /**
     * Checks one requirement.
     *
     * @param isThere whether it is met
     * @param words report if it is not met: the measured and the required value
     * @return isThere
     */
    public boolean ask(boolean isThere, String words) {
        asked++;
        if (!isThere) {
            missing.add(words);
        }
        return isThere;
    }

    /**
     * Checks a precondition, which is no requirement itself: as long as it is not met, no requirement counts as met. So
     * a script that does nothing gets no points for not bumping.
     *
     * @param isThere whether it is met
     * @param words report if it is not met: the measured and the needed value
     * @return isThere
     */
    public boolean need(boolean isThere, String words) {
        if (!isThere) {
            begun = false;
            missing.add(words);
        }
        return isThere;
    }

    /** Stores a number for the table of marks. */
    public void measure(String what, double number) {
        measures.put(what, number);
    }

    /** Returns the number of requirements checked. */
    public int getAsked() {
        return asked;
    }

    /** Returns the number of requirements met; 0 if a precondition is not met. */
    public int getMet() {
        return begun ? asked - missing.size() : 0;
    }

    /** Returns the reports of preconditions and requirements that were not met. */
    public List<String> getMissing() {
        return missing;
    }

    /** Returns the stored numbers by name. */
    public Map<String, Double> getMeasures() {
        return measures;
    }
}
