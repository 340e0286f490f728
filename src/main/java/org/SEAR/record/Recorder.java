// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Iterator;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.xml.Xml;
import org.SEAR.sensors.Reading;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.RunListener;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Snapshot;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * Writes a run to a file while it goes on: each step and all inputs and outputs, and at every second step all poses and
 * readings. {@link Simulation#ask} creates and ends it. Simulation thread.
 */
public final class Recorder implements RunListener {
    /** Default maximum size of a record, bytes. */
    public static final long LIMIT = 1L << 29;
    /** Steps from one frame to the next. */
    private static final int INTERVAL = 2;
    /** Real time after which buffered events go to the disk, ns. */
    private static final long FLUSH_NANOS = 1_000_000_000L;
    /** Maximum bytes of a line event; longer data becomes several events. */
    static final int LONGEST_BYTES = 1 << 16;

    private final Simulation simulation;
    private final Path path;
    private final long limit;
    private final Consumer<String> reported;
    private final LogBuffer out;
    private final List<String> sensors;
    private final List<List<String>> numbers = new ArrayList<>();
    private final List<String> withNumbers = new ArrayList<>();
    private final Pose[] seen;
    /** Null if no pictures are kept. */
    private final PictureKeeper pictures;
    /** Brightness of each robot's lights at the last frame. */
    private final List<List<Double>> lit = new ArrayList<>();
    private long steps;
    private long flushed;
    private boolean ended;

    private Recorder(Simulation simulation, Path path, long limit, double rate, Consumer<String> told)
        throws IOException {
        this.simulation = simulation;
        this.path = path;
        this.limit = limit;
        this.reported = told;
        sensors = simulation.getJoints().after(simulation.getSensorNames());
        for (String name : sensors) {
            List<String> kept = names(name, simulation.read(name));
            numbers.add(kept);
            if (!kept.isEmpty()) {
                withNumbers.add(name);
            }
        }
        seen = new Pose[simulation.snapshot().environment.size()];
        simulation.snapshot().robots.forEach(robot -> lit.add(List.of()));
        byte[] header = header();
        out = new LogBuffer(path);
        out.putBytes(header, header.length);
        pictures = rate > 0 ? new PictureKeeper(simulation, sensors, rate, out) : null;
    }

    /**
     * Begins a record. Simulation thread.
     *
     * @param path a new file, or a record to replace
     * @param limit bytes at which it ends by itself
     * @param told receives, on the simulation thread, the reason if it ends by itself
     * @throws IOException if another file has this name, or the file cannot be written
     */
    public static Recorder begin(Simulation simulation, Path path, long limit, Consumer<String> told)
        throws IOException {
        return begin(simulation, path, limit, 0, told);
    }

    /**
     * Begins a record with pictures of cameras.
     *
     * @param rate maximum pictures per camera and simulated second; 0 for none
     */
    public static Recorder begin(Simulation simulation, Path path, long limit, double rate, Consumer<String> told)
        throws IOException {
        check(path);
        Recorder recorder = new Recorder(simulation, path, limit, rate, told);
        recorder.frame(simulation.snapshot());
        recorder.flush();
        simulation.setListener(recorder, true);
        return recorder;
    }

    /** @throws IOException if a file of that name is no record */
    public static void check(Path path) throws IOException {
        if (Files.exists(path) && !RunRecord.isRecord(path)) {
            throw new IOException(path + " exists and is no record of a run; choose another name");
        }
    }

    /** Returns the SHA-256 of a project's objects as SEAR writes them. */
    static String fingerprint(Project project) {
        try {
            MessageDigest digest = MessageDigest.getInstance("SHA-256");
            List<SearObject> all = new ArrayList<>(project.getEnvironment());
            all.addAll(project.getJoints());
            for (SEARrobot robot : project.getRobots()) {
                all.add(robot);
                all.addAll(robot.getComponents());
            }
            all.forEach(object -> digest.update(Xml.write(object).getBytes(StandardCharsets.UTF_8)));
            StringBuilder hex = new StringBuilder();
            for (byte each : digest.digest()) {
                hex.append(Character.forDigit(each >> 4 & 15, 16)).append(Character.forDigit(each & 15, 16));
            }
            return hex.toString();
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** @throws IllegalArgumentException if the names do not fit the numbers */
    static List<String> names(String sensor, Reading reading) {
        List<String> names = reading.names();
        int size = reading.numbers().length;
        if (names.size() != size || size > RecordHeader.MAX_VALUES) {
            throw new IllegalArgumentException("a reading of sensor " + sensor + " has " + size + " numbers and "
                + names.size() + " names, legal: as many names as numbers, at most " + RecordHeader.MAX_VALUES
                + "; numbers() and names() of " + reading.getClass().getName() + " define them");
        }
        return names;
    }

    private byte[] header() throws IOException {
        Project project = simulation.getProject();
        RecordHeader header = new RecordHeader(simulation.getOrigin(), simulation.getStep(), INTERVAL,
            fingerprint(project), project.getRobots().stream().map(SearObject::getName).collect(Collectors.toList()),
            project.getEnvironment().stream().map(SearObject::getName).collect(Collectors.toList()), sensors, numbers,
            simulation.getLines().stream().map(line -> line.getObjectName() + " at " + line.getUserPort())
                .collect(Collectors.toList()));
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        header.write(new DataOutputStream(bytes));
        return bytes.toByteArray();
    }

    private void lights(Snapshot snapshot) {
        for (int i = 0; i < snapshot.robots.size(); i++) {
            List<Double> now = snapshot.robots.get(i).lights;
            List<Double> before = lit.get(i);
            for (int k = 0; k < now.size(); k++) {
                if (k >= before.size() || !now.get(k).equals(before.get(k))) {
                    out.put(EventKind.LIGHT).putShort(i).putShort(k).putDouble(now.get(k));
                }
            }
            lit.set(i, now);
        }
    }

    private void frame(Snapshot snapshot) {
        lights(snapshot);
        out.put(EventKind.FRAME);
        for (Snapshot.RobotState robot : snapshot.robots) {
            put(robot.pose);
            out.putDouble(robot.speed).putDouble(robot.turnRate);
        }
        int moved = 0;
        for (int i = 0; i < seen.length; i++) {
            moved += seen[i] == snapshot.environment.get(i) ? 0 : 1;
        }
        out.putShort(moved);
        for (int i = 0; i < seen.length; i++) {
            Pose pose = snapshot.environment.get(i);
            if (pose != seen[i]) {
                seen[i] = pose;
                out.putShort(i);
                put(pose);
            }
        }
        Iterator<Reading> readings = simulation.read(withNumbers).iterator();
        for (int i = 0; i < sensors.size(); i++) {
            int size = numbers.get(i).size();
            double[] now = size == 0 ? null : readings.next().numbers();
            for (int k = 0; k < size; k++) {
                out.putDouble(k < now.length ? now[k] : Double.NaN);
            }
        }
        if (pictures != null) {
            pictures.look(getSeconds());
        }
    }

    private void put(Pose pose) {
        out.putDouble(pose.x).putDouble(pose.y).putDouble(pose.z).putDouble(pose.qx).putDouble(pose.qy)
            .putDouble(pose.qz).putDouble(pose.qw);
    }

    @Override
    public void devicesServiced(int part) {
        out.put(EventKind.DEVICES_SERVICED).put(part);
    }

    @Override
    public void stepped(Simulation stepping) {
        steps++;
        if (steps % INTERVAL == 0) {
            frame(stepping.snapshot());
        } else {
            out.put(EventKind.STEP);
        }
        idle();
        if (out.size() >= limit || out.failure() != null) {
            leave();
            reported.accept("the record " + path + " has ended at " + getSeconds() + " s: "
                + (out.failure() == null ? "it reached its maximum size, " + limit + " bytes" : out.failure()));
        }
    }

    @Override
    public void idle() {
        if (System.nanoTime() - flushed > FLUSH_NANOS) {
            flush();
        }
    }

    /** Flushes whole events, so that a killed process loses only the events since then. */
    private void flush() {
        out.flush();
        flushed = System.nanoTime();
    }

    private void bytes(int kind, SerialLine line, byte[] bytes, int count) {
        for (int at = 0; at < count; at += LONGEST_BYTES) {
            int part = Math.min(LONGEST_BYTES, count - at);
            out.put(kind).putShort(simulation.getLines().indexOf(line)).putInt(part);
            if (at == 0) {
                out.putBytes(bytes, part);
            } else {
                out.putBytes(Arrays.copyOfRange(bytes, at, at + part), part);
            }
        }
    }

    @Override
    public void heard(SerialLine line, byte[] bytes, int count) {
        bytes(EventKind.HEARD, line, bytes, count);
    }

    @Override
    public void said(SerialLine line, byte[] bytes) {
        bytes(EventKind.SAID, line, bytes, bytes.length);
    }

    @Override
    public void baud(SerialLine line, int baud) {
        out.put(EventKind.BAUD).putShort(simulation.getLines().indexOf(line)).putInt(baud);
    }

    @Override
    public void lineClosed(SerialLine line) {
        out.put(EventKind.LINE_CLOSED).putShort(simulation.getLines().indexOf(line));
    }

    @Override
    public void opened(SerialLine line) {
        out.put(EventKind.OPENED).putShort(simulation.getLines().indexOf(line));
    }

    @Override
    public void drive(DriveCommand command) {
        out.put(EventKind.DRIVE).putShort(command.robot).put(command.wheels ? 1 : 0).putDouble(command.first)
            .putDouble(command.second);
    }

    @Override
    public void order(ActuatorOrder order) {
        text(out.put(EventKind.ORDER).put(order.kind.ordinal()).putDouble(order.value), order.name);
    }

    @Override
    public void order(BodyOrder order) {
        out.put(EventKind.BODY_ORDER).put(order.kind.ordinal()).putDouble(order.x).putDouble(order.y).putDouble(order.z)
            .putDouble(order.seconds);
        text(out, order.name);
    }

    @Override
    public void power(String device, boolean on) {
        text(out.put(EventKind.POWER).put(on ? 1 : 0), device);
    }

    private static void text(LogBuffer out, String text) {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.putShort(bytes.length).putBytes(bytes, bytes.length);
    }

    @Override
    public void moved(String name, Pose start, Pose to) {
        text(out.put(EventKind.MOVED), name);
        put(start);
        put(to);
    }

    @Override
    public void reset() {
        out.put(EventKind.RESET);
    }

    /** Ends the record of this run; {@link #end} completes the file. Simulation thread. */
    public void leave() {
        if (!ended) {
            ended = true;
            simulation.setListener(this, false);
            if (pictures != null) {
                pictures.end();
            }
            out.put(EventKind.END).putLong(steps);
        }
    }

    /**
     * Ends the record and waits until it is written. Simulation thread; any thread once the simulation has ended, or
     * after {@link #leave}.
     *
     * @throws IOException if the record could not be written completely
     */
    public void end() throws IOException {
        leave();
        out.close();
    }

    /** Returns the recorded simulated seconds. */
    public double getSeconds() {
        return steps * Simulation.STEP;
    }
}
