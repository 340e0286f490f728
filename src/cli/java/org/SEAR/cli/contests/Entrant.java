// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli.contests;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.SearObject;
import org.SEAR.cli.lessons.ErrorWords;
import org.SEAR.geometry.Pose;
import org.SEAR.lessons.Trail;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.embedded.python.PythonEngine;
import org.myrobotlab.embedded.python.ScriptResult;
import org.myrobotlab.embedded.python3.Python3Script;
import org.myrobotlab.service.SEAR;

/**
 * An entrant of a contest: a script, its robot, and the referee's judgement. The script runs only during its turn,
 * which ends when it waits for simulated time. Public for referees in Python; the public methods belong to the
 * contest's thread.
 */
public final class Entrant {
    private static final double ROUNDING = 1e-6;
    private static final int MAX_PRINTED = 200_000;
    private static final long GRACE_MILLIS = 2000;
    private static final long KNOCK_MILLIS = 20;

    private final String name;
    private final Path script;
    private final Simulation world;
    private final Printed printed = new Printed();
    private final PythonEngine engine;
    private final Thread thread;
    private final Semaphore turn = new Semaphore(0);
    private final Semaphore back = new Semaphore(0);
    private Robot robot;
    private double wakes;
    /** Whether the script's calls are rejected. Guarded by this. */
    private boolean out;
    /** Null while the script runs. Written during the script's turn. */
    private ScriptResult ended;
    private String unreadable;
    private boolean judged;
    private boolean disqualified;
    private double time = Double.POSITIVE_INFINITY;
    private String why = "";
    private double points;
    private final Trail trail;

    /** Output of the script; keeps its beginning. */
    private static final class Printed extends OutputStream {
        private final ByteArrayOutputStream kept = new ByteArrayOutputStream();

        @Override
        public synchronized void write(int value) {
            if (kept.size() < MAX_PRINTED) {
                kept.write(value);
            }
        }

        synchronized String text() {
            return new String(kept.toByteArray(), StandardCharsets.UTF_8);
        }
    }

    Entrant(String name, Path script, Simulation world, Robot robot) {
        this.name = name;
        this.script = script;
        this.world = world;
        this.robot = robot;
        trail = new Trail(name);
        engine = new PythonEngine("contest " + name, printed, printed);
        EntrantSear sear = new EntrantSear(this);
        engine.set("sear", sear);
        engine.set("Runtime", new EntrantSear.Services(sear));
        thread = new Thread(this::runScript, "contest " + name);
        thread.setDaemon(true);
    }

    // ---- the script's thread ---------------------------------------------------------------------------------------

    private void runScript() {
        try {
            turn.acquire();
            if (Python3Script.is(Files.readAllBytes(script))) {
                throw new IOException("it is Python 3, but contests use Python 2.7");
            }
            ended = engine.runFile(script.toString());
        } catch (IOException e) {
            unreadable = "its script can't be run: " + e.getMessage();
        } catch (InterruptedException e) {
            unreadable = "it did not start";
        } finally {
            back.release();
        }
    }

    /** Runs an action in the world for the script. */
    <T> T call(Function<Simulation, T> what) {
        synchronized (this) {
            if (out) {
                throw new IllegalStateException("the contest is over for " + name);
            }
            if (Thread.currentThread() != thread) {
                throw new IllegalStateException("in a contest only the script's own thread may call SEAR");
            }
            return what.apply(world);
        }
    }

    /** Makes the script wait. */
    void sleep(double seconds) {
        call(simulation -> {
            double now = simulation.getTime();
            // counts from the end of the last sleep, so that rounding to steps does not add up
            double from = wakes <= now && wakes > now - Simulation.STEP ? wakes : now;
            wakes = from + seconds;
            return wakes;
        });
        if (seconds == 0) {
            return;
        }
        back.release();
        try {
            turn.acquire();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("the contest is over for " + name, e);
        }
    }

    /** Returns the names of the robot's sensors. */
    List<String> sensors() {
        return robot.getSensors().stream().map(one -> one.getParameters().getName()).sorted()
            .collect(Collectors.toList());
    }

    /** Returns a sensor's name in the world. */
    String sensor(String given) {
        return own("sensor", sensors(), given);
    }

    /** Returns the name in the world of the robot's motor, servo or light. */
    String part(Class<?> type, String given) {
        return own(type.getSimpleName().toLowerCase(Locale.ROOT), robot.getObject().getComponents().stream()
            .filter(type::isInstance)
            .map(SearObject::getName).sorted().collect(Collectors.toList()), given);
    }

    private String own(String kind, List<String> names, String given) {
        String prefix = getRobot() + "/";
        String name = given != null && given.startsWith(prefix) ? given.substring(prefix.length()) : given;
        if (!names.contains(name)) {
            throw new IllegalArgumentException("no " + kind + " of your robot is called \"" + given + "\", legal: "
                + (names.isEmpty() ? "none, it has no " + kind : String.join(", ", names)));
        }
        return prefix + name;
    }

    Robot robot() {
        return robot;
    }

    int number() {
        return world.getRobots().indexOf(robot);
    }

    // ---- the contest's thread --------------------------------------------------------------------------------------

    void begin() {
        thread.start();
    }

    /**
     * Runs the script until it waits, if it is due.
     *
     * @param timeout limit of one turn by the computer's clock, s
     */
    void go(double timeout) throws InterruptedException {
        if (!isDriving() || wakes - ROUNDING > world.getTime()) {
            return;
        }
        turn.release();
        if (!back.tryAcquire((long) (timeout * TimeUnit.SECONDS.toNanos(1)), TimeUnit.NANOSECONDS)) {
            leave(String.format(Locale.ROOT, "its script hung at %.1f s: it ran for %.3g s without a simSleep",
                world.getTime(), timeout));
            breakOff();
        } else if (ended != null || unreadable != null) {
            leave(ended());
        }
    }

    private String ended() {
        String at = String.format(Locale.ROOT, " at %.1f s", world.getTime());
        if (unreadable != null || ended.getTraceback() == null) {
            return unreadable != null ? unreadable : "its script ended" + at;
        }
        ErrorWords error = new ErrorWords(inContest(ended.getTraceback()), script.getFileName().toString());
        return "its script failed" + at + (error.line.isEmpty() ? "" : ", line " + error.line) + ": "
            + withoutReferees(error.words);
    }

    /** Explains a call that only scripts outside of contests have. */
    private static String withoutReferees(String words) {
        Matcher missing = Pattern.compile("in a contest sear has no attribute '(\\w+)'").matcher(words);
        boolean isReferees = missing.find()
            && Stream.of(SEAR.class.getMethods()).anyMatch(one -> one.getName().equals(missing.group(1)));
        return isReferees ? words.substring(0, missing.end()) + ": a script knows only its robot's sensors, such as"
            + " getDistanceResult and getOdomResult, and its commands (docs/contests.md)" : words;
    }

    /** Replaces class names in an error by the names that the script uses. */
    private static String inContest(String traceback) {
        return traceback.replace("'" + EntrantSear.Services.class.getName() + "' object", "in a contest Runtime")
            .replace("'" + EntrantSear.class.getName() + "' object", "in a contest sear");
    }

    /** Ends the script's turns and stops the robot. */
    private synchronized void leave(String words) {
        if (!out) {
            out = true;
            why = words;
            world.post(DriveCommand.wheels(number(), 0, 0));
        }
    }

    /** Returns whether the script is ending the whole process. */
    boolean exits() {
        return Stream.of(thread.getStackTrace()).anyMatch(frame -> frame.getClassName().equals("java.lang.Runtime")
            && frame.getMethodName()
            .equals("exit"));
    }

    /** Ends the entrant at the end of the contest. */
    void timeIsOver(String words) {
        leave(words);
    }

    /** Records the robot's state after a step. */
    void look() {
        trail.add(world.getTime(), robot.getPose(), isTouching());
    }

    /** Ends the script and closes its interpreter. */
    void end() throws InterruptedException {
        breakOff();
        engine.close();
    }

    /** Interrupts the script repeatedly; abandons its thread if it does not end in time. */
    private void breakOff() throws InterruptedException {
        long until = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(GRACE_MILLIS);
        while (thread.isAlive() && System.nanoTime() < until) {
            engine.interrupt();
            thread.join(KNOCK_MILLIS);
        }
    }

    String printed() {
        return printed.text() + (ended == null || ended.getTraceback() == null ? ""
            : inContest(ended.getTraceback()) + "\n");
    }

    // ---- for the referee -------------------------------------------------------------------------------------------

    /** Returns the entrant's name. */
    public String getName() {
        return name;
    }

    /** Returns the name of the robot. */
    public String getRobot() {
        return robot.getObject().getName();
    }

    /**
     * Assigns another of the world's robots, before the start.
     *
     * @throws IllegalArgumentException if there is no such robot
     */
    public void setRobot(String robotName) {
        beforeStart("setRobot");
        robot = world.getRobots().stream().filter(one -> one.getObject().getName().equals(robotName)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("there is no robot \"" + robotName + "\"; the robots are "
                + world.getRobots().stream()
                .map(one -> one.getObject().getName()).collect(Collectors.joining(", "))));
    }

    /**
     * Moves the robot to its start; its height stays.
     *
     * @param x metres north
     * @param z metres east
     * @param heading degrees clockwise from north
     */
    public void place(double x, double z, double heading) {
        beforeStart("place");
        if (!Double.isFinite(x) || !Double.isFinite(z) || !Double.isFinite(heading)) {
            throw new IllegalArgumentException("place of " + name + " is x " + x + ", z " + z + ", heading " + heading
                + ", legal: numbers");
        }
        Pose to = Pose.ofDegrees(x, robot.getPose().y, z, 0, 90 - heading, 0);
        world.move(getRobot(), to, to);
    }

    private void beforeStart(String what) {
        if (world.getStep() > 0 || thread.isAlive()) {
            throw new IllegalStateException(what + ": the contest has started, legal: in positions(contest)");
        }
    }

    /** Returns the position north, m. */
    public double getX() {
        return robot.getPose().x;
    }

    /** Returns the position up, m. */
    public double getY() {
        return robot.getPose().y;
    }

    /** Returns the position east, m. */
    public double getZ() {
        return robot.getPose().z;
    }

    /** Returns the heading clockwise from north, degrees, (-180, 180]. */
    public double getHeading() {
        return robot.getPose().heading();
    }

    /** Returns the robot's pose after each step. */
    public Trail getTrail() {
        return trail;
    }

    /** Returns the distance to a position, m. */
    public double distance(double x, double z) {
        return Math.hypot(getX() - x, getZ() - z);
    }

    /** Returns whether a part other than the wheels touches something now. */
    public boolean isTouching() {
        return world.getStep() > 0 && robot.getTruth().isTouched(null);
    }

    /** Returns the number of collisions so far. */
    public int getBumps() {
        return trail.getBumps().size();
    }

    /** Returns whether the script may still drive. */
    public synchronized boolean isDriving() {
        return !out;
    }

    public double getPoints() {
        return points;
    }

    public void setPoints(double points) {
        if (!Double.isFinite(points)) {
            throw new IllegalArgumentException("points of " + name + " are " + points + ", legal: a number");
        }
        this.points = points;
    }

    /** Marks the task as done: records the time, ends the script and stops the robot. An earlier judgement stays. */
    public void finish(String words) {
        judge(words, world.getTime());
    }

    /** Disqualifies: last place, ends the script and stops the robot. An earlier judgement stays. */
    public void disqualify(String words) {
        if (!judged) {
            disqualified = true;
            judge("disqualified: " + words, Double.POSITIVE_INFINITY);
        }
    }

    private void judge(String words, double at) {
        if (!judged) {
            judged = true;
            time = at;
            leave(words);
            why = words;
        }
    }

    /** Returns when the entrant finished, s; infinity if it did not. */
    public double getTime() {
        return time;
    }

    /** Returns whether the entrant was disqualified. */
    public boolean isDisqualified() {
        return disqualified;
    }

    /** Returns how the entrant ended, in words. */
    public String getWhy() {
        return why;
    }
}
