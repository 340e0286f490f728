// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.sensors.Reading;
import org.SEAR.simulator.RunOrigin;

/**
 * The beginning of a record: its project and run, and the names of robots, objects, sensors and ports. Immutable; any
 * thread.
 */
public final class RecordHeader {
    static final byte[] MAGIC = "SEARLOG1".getBytes(StandardCharsets.US_ASCII);
    /** Maximum number of robots, objects, sensors or ports of a record. */
    static final int MAX_NAMES = 10000;
    /** Maximum count of numbers of one reading. */
    static final int MAX_VALUES = 127;
    /** Added to the count when the numbers' names follow. */
    private static final int NAMED = 128;
    private static final int LONGEST_NAME = 1000;
    private static final int LONGEST_INTERVAL = 3600;

    /** Everything besides project and commands that determines the run. */
    public final RunOrigin origin;
    /** Step of the simulation at which the record begins. Only a record from step 0 can be rerun. */
    public final long firstStep;
    /** Steps from one frame of poses and readings to the next. */
    public final int interval;
    /** SHA-256 of the project's objects, hexadecimal. */
    public final String project;
    public final List<String> robots;
    public final List<String> objects;
    public final List<String> sensors;
    /** Names of the numbers of each sensor's reading, see {@link Reading#names}. */
    public final List<List<String>> numbers;
    /** Count of numbers of each sensor's reading. */
    public final List<Integer> sizes;
    /** Object and user port of each serial line: {@code myLidar at /dev/SEAR_LIDAR_01}. */
    public final List<String> lines;

    RecordHeader(RunOrigin origin, long firstStep, int interval, String project, List<String> robots,
        List<String> objects, List<String> sensors, List<List<String>> numbers, List<String> lines) {
        this.origin = origin;
        this.firstStep = firstStep;
        this.interval = interval;
        this.project = project;
        this.robots = Collections.unmodifiableList(robots);
        this.objects = Collections.unmodifiableList(objects);
        this.sensors = Collections.unmodifiableList(sensors);
        this.numbers = Collections.unmodifiableList(numbers);
        this.sizes = numbers.stream().map(List::size).collect(Collectors.toUnmodifiableList());
        this.lines = Collections.unmodifiableList(lines);
    }

    void write(DataOutputStream out) throws IOException {
        out.write(MAGIC);
        out.writeLong(origin.seed);
        out.writeLong(origin.epochMillis);
        out.writeBoolean(origin.groundVisible);
        out.writeLong(firstStep);
        out.writeInt(interval);
        writeText(out, project);
        for (List<String> names : Arrays.asList(robots, objects, sensors, lines)) {
            out.writeShort(names.size());
            for (String name : names) {
                writeText(out, name);
            }
        }
        for (List<String> called : numbers) {
            boolean named = !called.equals(Reading.names(called.size()));
            out.writeByte(named ? called.size() + NAMED : called.size());
            for (String name : named ? called : List.<String>of()) {
                writeText(out, name);
            }
        }
    }

    private static void writeText(DataOutputStream out, String text) throws IOException {
        byte[] bytes = text.getBytes(StandardCharsets.UTF_8);
        out.writeShort(bytes.length);
        out.write(bytes);
    }

    /** @throws RecordException for an impossible header */
    static RecordHeader read(DataInputStream in) throws IOException {
        byte[] magic = new byte[MAGIC.length];
        int got = in.readNBytes(magic, 0, magic.length);
        if (got < magic.length || !Arrays.equals(magic, MAGIC)) {
            throw new RecordException("it is no record of a run: it does not begin with \"SEARLOG1\"");
        }
        RunOrigin origin = new RunOrigin(in.readLong(), in.readLong(), in.readBoolean());
        long firstStep = in.readLong();
        int interval = in.readInt();
        if (firstStep < 0 || interval < 1 || interval > LONGEST_INTERVAL) {
            throw new RecordException("its first step is " + firstStep + " and its interval " + interval
                + ", legal: 0 or more, and 1 to " + LONGEST_INTERVAL);
        }
        String project = readText(in);
        List<List<String>> names = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            names.add(readNames(in));
        }
        List<List<String>> numbers = new ArrayList<>();
        for (int i = 0; i < names.get(2).size(); i++) {
            int size = in.readUnsignedByte();
            numbers.add(size < NAMED ? Reading.names(size) : readTexts(in, size - NAMED));
        }
        return new RecordHeader(origin, firstStep, interval, project, names.get(0), names.get(1), names.get(2), numbers,
            names.get(3));
    }

    private static List<String> readNames(DataInputStream in) throws IOException {
        int count = in.readUnsignedShort();
        if (count > MAX_NAMES) {
            throw new RecordException("it has " + count + " names of one kind, legal: at most " + MAX_NAMES);
        }
        return readTexts(in, count);
    }

    private static List<String> readTexts(DataInputStream in, int count) throws IOException {
        List<String> texts = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            texts.add(readText(in));
        }
        return texts;
    }

    static String readText(DataInputStream in) throws IOException {
        int length = in.readUnsignedShort();
        if (length > LONGEST_NAME) {
            throw new RecordException("a name has " + length + " bytes, legal: at most " + LONGEST_NAME);
        }
        byte[] bytes = new byte[length];
        in.readFully(bytes);
        return new String(bytes, StandardCharsets.UTF_8);
    }
}
