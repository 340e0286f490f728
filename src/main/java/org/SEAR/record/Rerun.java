// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.Interrupts;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.RunListener;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Snapshot;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * Runs the commands of a record in a fresh world of the same project, and compares port bytes and poses. The world is
 * separate: it needs no ports and disturbs no running simulation. One use, one thread.
 */
public final class Rerun implements RunRecord.Visitor {
    private final RunRecord record;
    private final Simulation world;
    private final List<Consumer<Simulation>> commands = new ArrayList<>();
    private final MessageDigest[] recorded;
    private final MessageDigest[] again;
    private final long[] counts;
    private final Consumer<Simulation> watcher;
    private long steps;
    private double apart;
    /** Largest distance from the poses of the last frame, metres, and that frame's poses. */
    private double unlike;
    private double[] unlikeRobots;
    private double[] unlikeObjects;

    private Rerun(RunRecord record, Simulation world, Consumer<Simulation> watcher) {
        this.record = record;
        this.world = world;
        this.watcher = watcher;
        recorded = digests(world.getLines().size());
        again = digests(world.getLines().size());
        counts = new long[recorded.length];
    }

    /** Result of a rerun. */
    public static final class Result {
        /** Whether all port bytes and poses match. */
        public final boolean same;
        /** False if the record was cut off or is still being written. */
        public final boolean whole;
        /** Simulated seconds. */
        public final double seconds;
        /** By port: the bytes sent in the record, and whether the rerun sent the same. */
        public final Map<String, String> ports;
        /** Largest distance of a robot or object from its recorded position, metres. */
        public final double apart;

        Result(boolean whole, boolean same, double seconds, Map<String, String> ports, double apart) {
            this.whole = whole;
            this.same = same;
            this.seconds = seconds;
            this.ports = ports;
            this.apart = apart;
        }

        @Override
        public String toString() {
            return String.format(Locale.ROOT, "%.3f s, %s: %s, %s m apart", seconds, same ? "the same" : "not the same",
                ports, apart);
        }
    }

    /**
     * Runs a record's commands.
     *
     * @param project the recorded project
     * @throws IOException if the record cannot be rerun: another project, or no start at step 0
     */
    public static Result of(RunRecord record, Project project) throws IOException, ProjectException {
        return of(record, project, world -> { });
    }

    /**
     * Runs a record's commands.
     *
     * @param project the recorded project
     * @param watcher receives the world before the first step and after each step
     * @throws IOException if the record cannot be rerun: another project, or no start at step 0
     */
    public static Result of(RunRecord record, Project project, Consumer<Simulation> watcher)
        throws IOException, ProjectException {
        RecordHeader header = record.getHeader();
        if (header.firstStep != 0) {
            throw new RecordException(record.getPath() + " begins at step " + header.firstStep
                + " of its run and can't be run again: begin the record before the start, or after reset()");
        }
        if (!header.project.equals(Recorder.fingerprint(project))) {
            throw new RecordException(record.getPath() + " is of another project than " + project.getFolder()
                + ", or the project has changed since: open the recorded project");
        }
        try (Simulation world = Simulation.of(project, header.origin)) {
            if (world.getLines().size() != header.lines.size()) {
                throw new RecordException(record.getPath() + " has " + header.lines.size() + " ports, the project has "
                    + world.getLines().size());
            }
            return new Rerun(record, world, watcher).run();
        }
    }

    private static MessageDigest[] digests(int count) {
        MessageDigest[] all = new MessageDigest[count];
        try {
            for (int i = 0; i < count; i++) {
                all[i] = MessageDigest.getInstance("SHA-256");
            }
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
        return all;
    }

    private Result run() throws IOException {
        world.setListener(new Listener(), true);
        watcher.accept(world);
        boolean whole = record.read(this);
        lookAgain();
        boolean same = true;
        Map<String, String> ports = new LinkedHashMap<>();
        for (int i = 0; i < recorded.length; i++) {
            boolean equal = Arrays.equals(recorded[i].digest(), again[i].digest());
            same &= equal;
            ports.put(record.getHeader().lines.get(i), counts[i] + " bytes, " + (equal ? "the same" : "different"));
        }
        return new Result(whole, same && apart == 0, steps * Simulation.STEP, ports, apart);
    }

    @Override
    public void frame(double[] robots, double[] objects, double[] readings) {
        unlike = distance(robots, objects);
        if (unlike > 0) {
            unlikeRobots = robots.clone();
            unlikeObjects = objects.clone();
        }
    }

    /** Returns the largest distance from the poses of a frame, metres. */
    private double distance(double[] robots, double[] objects) {
        Snapshot now = world.snapshot();
        double most = 0;
        for (int i = 0; i < now.robots.size(); i++) {
            most = Math.max(most, distance(now.robots.get(i).pose, robots, i * RunRecord.ROBOT));
        }
        for (int i = 0; i < now.environment.size(); i++) {
            most = Math.max(most, distance(now.environment.get(i), objects, i * RunRecord.POSE));
        }
        return most;
    }

    private static double distance(Pose now, double[] then, int at) {
        double dx = now.x - then[at];
        double dy = now.y - then[at + 1];
        double dz = now.z - then[at + 2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    /**
     * Compares with the last frame again. A move during the delivery of a step's outputs is already in the step's
     * frame, although its event follows the frame.
     */
    private void lookAgain() {
        if (unlike > 0) {
            apart = Math.max(apart, Math.min(unlike, distance(unlikeRobots, unlikeObjects)));
            unlike = 0;
        }
    }

    @Override
    public void step() {
        Interrupts.check();
        execute();
        world.step();
        steps++;
        watcher.accept(world);
    }

    @Override
    public void devicesServiced(int part) {
        execute();
        if (part == 0) {
            world.answer();
        } else {
            world.serviceDevices(part);
        }
    }

    private void execute() {
        commands.forEach(command -> command.accept(world));
        commands.clear();
        lookAgain();
    }

    private SerialLine line(int number) {
        return world.getLines().get(number);
    }

    @Override
    public void heard(int line, byte[] bytes) {
        commands.add(run -> line(line).write(bytes));
    }

    @Override
    public void said(int line, byte[] bytes) {
        commands.add(run -> {
            recorded[line].update(bytes);
            counts[line] += bytes.length;
        });
    }

    @Override
    public void baud(int line, int baud) {
        commands.add(run -> line(line).setHostBaud(baud));
    }

    @Override
    public void lineClosed(int line) {
        commands.add(run -> line(line).hangUp());
    }

    @Override
    public void opened(int line) {
        commands.add(run -> line(line).open());
    }

    @Override
    public void drive(DriveCommand command) {
        commands.add(run -> run.post(command));
    }

    @Override
    public void order(ActuatorOrder order) {
        commands.add(run -> run.order(order));
    }

    @Override
    public void order(BodyOrder order) {
        commands.add(run -> run.order(order));
    }

    @Override
    public void power(String device, boolean on) {
        commands.add(run -> run.power(device, on));
    }

    @Override
    public void moved(String name, Pose start, Pose to) {
        commands.add(run -> run.move(name, start, to));
    }

    @Override
    public void reset() {
        commands.add(Simulation::reset);
    }

    /** Hashes what the devices send in the rerun. */
    private final class Listener implements RunListener {
        @Override
        public void said(SerialLine line, byte[] bytes) {
            again[world.getLines().indexOf(line)].update(bytes);
        }
    }
}
