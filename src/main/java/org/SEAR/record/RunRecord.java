// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.BufferedInputStream;
import java.io.DataInputStream;
import java.io.EOFException;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.Arrays;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.orders.BodyOrder;

/**
 * A record on disk. It is read from beginning to end, one event at a time, so that memory stays small for any size or
 * content. A record that was cut off is read up to its last complete event. Immutable; any thread.
 */
public final class RunRecord {
    private static final int BUFFER = 1 << 16;
    /** Bytes of a picture that are skipped at once. */
    private static final int PASSED = 1 << 13;
    /** Count of numbers of an object in a frame. */
    static final int POSE = 7;
    /** Maximum lights of a robot; it cannot have more components. */
    private static final int MAX_LIGHTS = 1000;
    private static final ActuatorOrder.Kind[] ORDERS = ActuatorOrder.Kind.values();
    private static final BodyOrder.Kind[] BODY_ORDERS = BodyOrder.Kind.values();
    /** Maximum deviation of a quaternion's length from 1. */
    private static final double ROUNDED = 1e-3;

    private final Path path;
    private final RecordHeader header;
    private final boolean written;

    private RunRecord(Path path, RecordHeader header, boolean written) {
        this.path = path;
        this.header = header;
        this.written = written;
    }

    /** Receives the events of a record; each method does nothing by default. */
    public interface Visitor {
        /**
         * Present poses and readings. The arrays are reused.
         *
         * @param robots nine numbers each: x, y, z, quaternion x, y, z, w, speed, turn rate
         * @param objects seven numbers each
         * @param readings the numbers of all sensors
         */
        default void frame(double[] robots, double[] objects, double[] readings) {
        }

        /** A step has ended. */
        default void step() {
        }

        default void heard(int line, byte[] bytes) {
        }

        default void said(int line, byte[] bytes) {
        }

        default void baud(int line, int baud) {
        }

        default void lineClosed(int line) {
        }

        default void opened(int line) {
        }

        /** See {@link org.SEAR.simulator.RunListener#devicesServiced}. */
        default void devicesServiced(int part) {
        }

        default void drive(DriveCommand command) {
        }

        default void order(ActuatorOrder order) {
        }

        default void order(BodyOrder order) {
        }

        default void power(String device, boolean on) {
        }

        default void moved(String name, Pose start, Pose to) {
        }

        default void reset() {
        }

        /**
         * A light has this brightness from the next frame on.
         *
         * @param light its number among the robot's lights
         * @param brightness 0 to 1
         */
        default void light(int robot, int light, double brightness) {
        }

        /**
         * A camera picture has been kept. It may be some frames older.
         *
         * @param sensor number of the camera
         * @param kind the camera's kind, as in its object
         * @param time when it was taken, simulated seconds since the record began
         * @param offset start of the picture file in the record, see {@link org.SEAR.sensors.PixelGrid#file}
         * @param length bytes
         */
        default void picture(int sensor, String kind, double time, long offset, int length) {
        }
    }

    /** Count of numbers of a robot in a frame. */
    public static final int ROBOT = 9;

    static boolean isRecord(Path path) throws IOException {
        if (!Files.isRegularFile(path, LinkOption.NOFOLLOW_LINKS)) {
            return false;
        }
        try (InputStream in = Files.newInputStream(path)) {
            return Arrays.equals(in.readNBytes(RecordHeader.MAGIC.length), RecordHeader.MAGIC);
        }
    }

    /**
     * Opens a record.
     *
     * @throws IOException with what is wrong with the file
     */
    public static RunRecord open(Path path) throws IOException {
        if (!Files.isRegularFile(path)) {
            throw new RecordException(path + " is no record of a run: there is no such file");
        }
        boolean written = WriteLock.isOn(path);
        try (DataInputStream in = stream(path)) {
            return new RunRecord(path, RecordHeader.read(in), written);
        } catch (EOFException e) {
            throw new RecordException(path + " can't be read as a record: it ends in the middle of its header"
                + (written ? ", which is still being written" : ""));
        } catch (RecordException e) {
            throw new RecordException(path + " can't be read as a record: " + e.getMessage());
        }
    }

    private static DataInputStream stream(Path path) throws IOException {
        return new DataInputStream(counted(path));
    }

    private static Counted counted(Path path) throws IOException {
        return new Counted(new BufferedInputStream(Files.newInputStream(path), BUFFER));
    }

    /** Counts the bytes read. */
    private static final class Counted extends FilterInputStream {
        private long count;

        Counted(InputStream in) {
            super(in);
        }

        @Override
        public int read() throws IOException {
            int one = super.read();
            count += one < 0 ? 0 : 1;
            return one;
        }

        @Override
        public int read(byte[] into, int from, int most) throws IOException {
            int got = super.read(into, from, most);
            count += Math.max(0, got);
            return got;
        }
    }

    public Path getPath() {
        return path;
    }

    public RecordHeader getHeader() {
        return header;
    }

    /**
     * Returns whether this or another program was writing the record when it was opened. It then continues after the
     * part that is read.
     */
    public boolean isBeingWritten() {
        return written;
    }

    /**
     * Reads all events.
     *
     * @return whether it is complete; false if it was cut off or is being written
     * @throws RecordException for impossible values
     */
    public boolean read(Visitor visitor) throws IOException {
        try (Counted counted = counted(path); DataInputStream in = new DataInputStream(counted)) {
            RecordHeader.read(in);
            Events events = new Events(counted, in, visitor);
            while (events.next()) {
                // the visitor receives each event
            }
            return events.whole;
        } catch (RecordException e) {
            throw new RecordException(path + " can't be read as a record: " + e.getMessage());
        }
    }

    private final class Events {
        private final Counted counted;
        private final DataInputStream in;
        private final Visitor visitor;
        private final byte[] passed = new byte[PASSED];
        private final double[] robots = new double[header.robots.size() * ROBOT];
        private final double[] objects = new double[header.objects.size() * POSE];
        private final double[] readings = new double[header.sizes.stream().mapToInt(Integer::intValue).sum()];
        private long steps;
        private boolean begun;
        private boolean whole;

        Events(Counted counted, DataInputStream in, Visitor visitor) {
            this.counted = counted;
            this.in = in;
            this.visitor = visitor;
        }

        boolean next() throws IOException {
            int kind = in.read();
            if (kind < 0) {
                return false;
            }
            try {
                return event(kind);
            } catch (EOFException e) {
                return false;
            }
        }

        private boolean event(int kind) throws IOException {
            switch (kind) {
                case EventKind.STEP:
                    steps++;
                    visitor.step();
                    return true;
                case EventKind.FRAME:
                    frame();
                    return true;
                case EventKind.HEARD:
                    visitor.heard(line(), bytes());
                    return true;
                case EventKind.SAID:
                    visitor.said(line(), bytes());
                    return true;
                case EventKind.BAUD:
                    visitor.baud(line(), baud());
                    return true;
                case EventKind.LINE_CLOSED:
                    visitor.lineClosed(line());
                    return true;
                case EventKind.OPENED:
                    visitor.opened(line());
                    return true;
                case EventKind.DEVICES_SERVICED:
                    visitor.devicesServiced(in.readUnsignedByte());
                    return true;
                case EventKind.DRIVE:
                    visitor.drive(command());
                    return true;
                case EventKind.ORDER:
                    visitor.order(order());
                    return true;
                case EventKind.BODY_ORDER:
                    visitor.order(bodyOrder());
                    return true;
                case EventKind.POWER:
                    boolean on = in.readBoolean();
                    visitor.power(RecordHeader.readText(in), on);
                    return true;
                case EventKind.MOVED:
                    String name = RecordHeader.readText(in);
                    if (!header.robots.contains(name) && !header.objects.contains(name)) {
                        throw new RecordException("after " + steps + " steps \"" + name
                            + "\" is moved, legal: a robot or object in its header");
                    }
                    visitor.moved(name, pose(), pose());
                    return true;
                case EventKind.RESET:
                    visitor.reset();
                    return true;
                case EventKind.LIGHT:
                    light();
                    return true;
                case EventKind.PICTURE:
                    picture();
                    return true;
                case EventKind.END:
                    whole = in.readLong() == steps;
                    return false;
                default:
                    throw new RecordException("after " + steps + " steps comes an event " + kind + ", legal: 1 to "
                        + EventKind.MOST);
            }
        }

        private void frame() throws IOException {
            read(robots, 0, robots.length);
            int moved = in.readUnsignedShort();
            for (int i = 0; i < moved; i++) {
                int object = in.readUnsignedShort();
                if (object >= header.objects.size()) {
                    throw illegal("object", object, header.objects.size());
                }
                read(objects, object * POSE, POSE);
            }
            read(readings, 0, readings.length);
            if (begun) {
                steps++;
                visitor.step();
            }
            begun = true;
            visitor.frame(robots, objects, readings);
        }

        private void read(double[] into, int from, int count) throws IOException {
            for (int i = from; i < from + count; i++) {
                into[i] = in.readDouble();
            }
        }

        private int line() throws IOException {
            int line = in.readUnsignedShort();
            if (line >= header.lines.size()) {
                throw illegal("port", line, header.lines.size());
            }
            return line;
        }

        private Pose pose() throws IOException {
            double[] numbers = new double[POSE];
            read(numbers, 0, POSE);
            for (double number : numbers) {
                if (!Double.isFinite(number)) {
                    throw new RecordException("after " + steps + " steps an object is moved to " + number
                        + ", legal: a finite number");
                }
            }
            double length = Math.sqrt(numbers[3] * numbers[3] + numbers[4] * numbers[4] + numbers[5] * numbers[5]
                + numbers[6] * numbers[6]);
            if (!(Math.abs(length - 1) < ROUNDED)) {
                throw new RecordException("after " + steps + " steps an object is rotated by a quaternion of length "
                    + length + ", legal: 1");
            }
            return new Pose(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5], numbers[6]);
        }

        private byte[] bytes() throws IOException {
            int count = in.readInt();
            if (count < 1 || count > Recorder.LONGEST_BYTES) {
                throw new RecordException("after " + steps + " steps come " + count + " bytes at once, legal: 1 to "
                    + Recorder.LONGEST_BYTES);
            }
            byte[] bytes = new byte[count];
            in.readFully(bytes);
            return bytes;
        }

        private int baud() throws IOException {
            int baud = in.readInt();
            if (baud < 0) {
                throw new RecordException("after " + steps + " steps a port is set to " + baud
                    + " baud, legal: 0 or more");
            }
            return baud;
        }

        private void light() throws IOException {
            int robot = robot();
            int light = in.readUnsignedShort();
            if (light >= MAX_LIGHTS) {
                throw illegal("light", light, MAX_LIGHTS);
            }
            double brightness = in.readDouble();
            if (!(brightness >= 0 && brightness <= 1)) {
                throw new RecordException("after " + steps + " steps a light has the brightness " + brightness
                    + ", legal: 0 to 1");
            }
            visitor.light(robot, light, brightness);
        }

        private void picture() throws IOException {
            int sensor = in.readUnsignedShort();
            if (sensor >= header.sensors.size()) {
                throw illegal("sensor", sensor, header.sensors.size());
            }
            int kind = in.readUnsignedByte();
            if (kind >= PictureKeeper.KINDS.size()) {
                throw illegal("kind of pictures", kind, PictureKeeper.KINDS.size());
            }
            double time = in.readDouble();
            int length = in.readInt();
            if (!(time >= 0 && time <= steps * Simulation.STEP + ROUNDED) || length < 1
                || length > PictureKeeper.LONGEST_PICTURE) {
                throw new RecordException("after " + steps + " steps comes a picture of " + time + " s with " + length
                    + " bytes, legal: 0 s to then, 1 to " + PictureKeeper.LONGEST_PICTURE + " bytes");
            }
            long offset = counted.count;
            for (int left = length; left > 0; left -= Math.min(left, PASSED)) {
                in.readFully(passed, 0, Math.min(left, PASSED));
            }
            visitor.picture(sensor, PictureKeeper.KINDS.get(kind), time, offset, length);
        }

        private int robot() throws IOException {
            int robot = in.readUnsignedShort();
            if (robot >= header.robots.size()) {
                throw illegal("robot", robot, header.robots.size());
            }
            return robot;
        }

        private DriveCommand command() throws IOException {
            int robot = robot();
            boolean wheels = in.readBoolean();
            double first = in.readDouble();
            double second = in.readDouble();
            return wheels ? DriveCommand.wheels(robot, first, second) : DriveCommand.circle(robot, first, second);
        }

        private ActuatorOrder order() throws IOException {
            int kind = in.readUnsignedByte();
            if (kind >= ORDERS.length) {
                throw illegal("order", kind, ORDERS.length);
            }
            double value = in.readDouble();
            return new ActuatorOrder(ORDERS[kind], RecordHeader.readText(in), value);
        }

        private BodyOrder bodyOrder() throws IOException {
            int kind = in.readUnsignedByte();
            if (kind >= BODY_ORDERS.length) {
                throw illegal("order to a body", kind, BODY_ORDERS.length);
            }
            double[] numbers = new double[4];
            read(numbers, 0, numbers.length);
            String name = RecordHeader.readText(in);
            try {
                return new BodyOrder(BODY_ORDERS[kind], name, numbers[0], numbers[1], numbers[2], numbers[3]);
            } catch (IllegalArgumentException e) {
                throw new RecordException("after " + steps + " steps: " + e.getMessage());
            }
        }

        private RecordException illegal(String what, int number, int count) {
            return new RecordException("after " + steps + " steps it names " + what + " " + number
                + ", legal: below " + count);
        }
    }
}
