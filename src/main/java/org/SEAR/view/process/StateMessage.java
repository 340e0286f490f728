// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.process;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.scene.ReadingTexts;
import org.SEAR.sensors.Reading;
import org.SEAR.simulator.Snapshot;
import org.SEAR.view.link.CameraFrame;
import org.SEAR.view.link.WorldLink;

/**
 * A {@link WorldLink}'s snapshot and settings at one time, as bytes for a window in another process. Immutable, any
 * thread.
 */
public final class StateMessage {
    /** Picture of a message: that of the previous message, none, or a new one that follows. */
    private static final int SAME = 0;
    private static final int NONE = 1;
    private static final int ANOTHER = 2;
    private static final int BYTE = 0xff;

    final Snapshot snapshot;
    final boolean paused;
    final double measuredSpeed;
    final double wantedSpeed;
    final boolean scriptDrives;
    /** The newest picture of a camera, or null. */
    final CameraFrame picture;

    StateMessage(Snapshot snapshot, boolean paused, double measuredSpeed, double wantedSpeed, boolean scriptDrives,
        CameraFrame picture) {
        this.snapshot = snapshot;
        this.paused = paused;
        this.measuredSpeed = measuredSpeed;
        this.wantedSpeed = wantedSpeed;
        this.scriptDrives = scriptDrives;
        this.picture = picture;
    }

    /** Returns the current state of a world after its first step. */
    public static StateMessage of(WorldLink world) {
        return new StateMessage(world.snapshot(), world.isPaused(), world.measuredSpeed(), world.wantedSpeed(),
            world.scriptDrives(), world.picture());
    }

    private interface Writer<T> {
        public void write(T value) throws IOException;
    }

    private interface Reader<T> {
        T read() throws IOException;
    }

    private static <T> void writeAll(DataOutputStream out, Iterable<T> values, int count, Writer<T> writer)
        throws IOException {
        out.writeInt(count);
        for (T value : values) {
            writer.write(value);
        }
    }

    private static <T> List<T> readAll(DataInputStream in, Reader<T> reader) throws IOException {
        int count = in.readInt();
        List<T> values = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            values.add(reader.read());
        }
        return Collections.unmodifiableList(values);
    }

    /** A reading as the window draws it. */
    private static final class DrawnReading implements Reading {
        private final String words;
        private final double[] beams;

        DrawnReading(String words, double[] beams) {
            this.words = words;
            this.beams = beams;
        }

        @Override
        public double[] numbers() {
            return new double[0];
        }

        @Override
        public String words(String unit) {
            return words;
        }

        @Override
        public double[] beams() {
            return beams;
        }
    }

    /**
     * Writes the message.
     * @param before the previous message, whose picture is not repeated; or null
     * @param texts of the project's readings
     */
    public void write(DataOutputStream out, StateMessage before, ReadingTexts texts) throws IOException {
        boolean same = picture == (before == null ? null : before.picture);
        out.writeByte(same ? SAME : picture == null ? NONE : ANOTHER);
        if (!same && picture != null) {
            write(out, picture);
        }
        out.writeBoolean(paused);
        out.writeDouble(measuredSpeed);
        out.writeDouble(wantedSpeed);
        out.writeBoolean(scriptDrives);
        out.writeLong(snapshot.step);
        out.writeDouble(snapshot.time);
        writeAll(out, snapshot.environment, snapshot.environment.size(), pose -> write(out, pose));
        writeAll(out, snapshot.robots, snapshot.robots.size(), robot -> write(out, robot));
        Map<String, String> words = texts.of(snapshot.readings);
        Map<String, double[]> beams = new LinkedHashMap<>();
        for (String sensor : words.keySet()) {
            Reading reading = snapshot.readings.get(sensor);
            if (reading != null && reading.beams() != null) {
                beams.put(sensor, reading.beams());
            }
        }
        writeAll(out, beams.entrySet(), beams.size(), beam -> {
            out.writeUTF(beam.getKey());
            write(out, beam.getValue());
        });
        writeAll(out, words.entrySet(), words.size(), value -> {
            out.writeUTF(value.getKey());
            out.writeUTF(value.getValue());
        });
        writeAll(out, snapshot.contacts, snapshot.contacts.size(), contact -> write(out, contact));
        writeAll(out, snapshot.warnings, snapshot.warnings.size(), out::writeUTF);
    }

    /** @param before the previous message, or null */
    static StateMessage read(DataInputStream in, StateMessage before) throws IOException {
        int pictures = in.readUnsignedByte();
        CameraFrame picture = pictures == ANOTHER ? picture(in) : pictures == SAME && before != null
            ? before.picture : null;
        boolean paused = in.readBoolean();
        double measuredSpeed = in.readDouble();
        double wantedSpeed = in.readDouble();
        boolean scriptDrives = in.readBoolean();
        long step = in.readLong();
        double time = in.readDouble();
        List<Pose> environment = readAll(in, () -> pose(in));
        List<Snapshot.RobotState> robots = readAll(in, () -> robot(in));
        Map<String, double[]> beams = new LinkedHashMap<>();
        readAll(in, () -> beams.put(in.readUTF(), numbers(in)));
        Map<String, Reading> readings = new LinkedHashMap<>();
        readAll(in, () -> {
            String sensor = in.readUTF();
            return readings.put(sensor, new DrawnReading(in.readUTF(), beams.get(sensor)));
        });
        List<double[]> contacts = readAll(in, () -> numbers(in));
        Snapshot snapshot = new Snapshot(step, time, environment, robots,
            Collections.unmodifiableMap(readings), contacts, readAll(in, in::readUTF));
        return new StateMessage(snapshot, paused, measuredSpeed, wantedSpeed, scriptDrives, picture);
    }

    private static void write(DataOutputStream out, CameraFrame picture) throws IOException {
        out.writeUTF(picture.camera);
        out.writeUTF(picture.words);
        out.writeShort(picture.width);
        out.writeShort(picture.height);
        byte[] bytes = new byte[3 * picture.width * picture.height];
        for (int i = 0; i < bytes.length; i += 3) {
            int rgb = picture.pixel(i / 3 % picture.width, i / 3 / picture.width);
            bytes[i] = (byte) (rgb >> 16);
            bytes[i + 1] = (byte) (rgb >> 8);
            bytes[i + 2] = (byte) rgb;
        }
        out.write(bytes);
    }

    private static CameraFrame picture(DataInputStream in) throws IOException {
        String camera = in.readUTF();
        String words = in.readUTF();
        int width = in.readUnsignedShort();
        int height = in.readUnsignedShort();
        if (width > CameraFrame.LONGEST || height > CameraFrame.LONGEST) {
            throw new IOException("a picture of " + width + " x " + height + " was received, legal: at most "
                + CameraFrame.LONGEST + " each way");
        }
        byte[] bytes = new byte[3 * width * height];
        in.readFully(bytes);
        int[] pixels = new int[width * height];
        for (int i = 0; i < pixels.length; i++) {
            pixels[i] = (bytes[3 * i] & BYTE) << 16 | (bytes[3 * i + 1] & BYTE) << 8 | bytes[3 * i + 2] & BYTE;
        }
        return new CameraFrame(camera, words, width, height, pixels);
    }

    private static void write(DataOutputStream out, Snapshot.RobotState robot) throws IOException {
        out.writeUTF(robot.name);
        write(out, robot.pose);
        out.writeDouble(robot.speed);
        out.writeDouble(robot.turnRate);
        writeAll(out, robot.wheels, robot.wheels.size(), wheel -> write(out, wheel));
        writeAll(out, robot.parts, robot.parts.size(), part -> write(out, part));
        writeAll(out, robot.lights, robot.lights.size(), out::writeDouble);
        writeAll(out, robot.devices, robot.devices.size(), device -> out.writeUTF(device.toString()));
    }

    private static Snapshot.RobotState robot(DataInputStream in) throws IOException {
        return new Snapshot.RobotState(in.readUTF(), pose(in), in.readDouble(), in.readDouble(),
            readAll(in, () -> pose(in)),
            readAll(in, () -> pose(in)), readAll(in, in::readDouble), readAll(in, () -> device(in.readUTF())), false);
    }

    private static Snapshot.DeviceState device(String line) {
        String[] nameAndStatus = line.split(": ", 2);
        return new Snapshot.DeviceState(nameAndStatus[0], true, nameAndStatus[1], List.of());
    }

    private static void write(DataOutputStream out, Pose pose) throws IOException {
        for (double value : new double[] {pose.x, pose.y, pose.z, pose.qx, pose.qy, pose.qz, pose.qw}) {
            out.writeDouble(value);
        }
    }

    private static Pose pose(DataInputStream in) throws IOException {
        return new Pose(in.readDouble(), in.readDouble(), in.readDouble(), in.readDouble(), in.readDouble(),
            in.readDouble(), in.readDouble());
    }

    private static void write(DataOutputStream out, double[] numbers) throws IOException {
        out.writeInt(numbers.length);
        for (double number : numbers) {
            out.writeDouble(number);
        }
    }

    private static double[] numbers(DataInputStream in) throws IOException {
        double[] numbers = new double[in.readInt()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = in.readDouble();
        }
        return numbers;
    }
}
