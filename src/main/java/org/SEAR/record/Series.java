// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.Interrupts;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;

/**
 * Values of a record over time: readings, positions, commands, bytes on the ports. Immutable except for its arrays; any
 * thread.
 */
public final class Series {
    private static final List<String> ROBOT = Arrays.asList(".x", ".y", ".z", ".heading", ".speed", ".turnRate",
        " speed wanted", " radius wanted", " left wanted", " right wanted");
    private static final List<String> OBJECT = Arrays.asList(".x", ".y", ".z");
    private static final List<String> LINE = Arrays.asList(" received", " sent");
    private static final int COMMANDS = 6;
    private static final int POSE = 7;

    public final List<String> names;
    /** Simulated seconds since the record began. */
    public final double[] times;
    /** By name and time; NaN where there is no number. */
    public final double[][] values;

    /** False if the record was cut off or is still being written. */
    public final boolean whole;

    private Series(boolean whole, List<String> names, double[] times, double[][] values) {
        this.whole = whole;
        this.names = names;
        this.times = times;
        this.values = values;
    }

    private static Map<String, int[]> places(RecordHeader header) {
        Map<String, int[]> places = new LinkedHashMap<>();
        for (int i = 0; i < header.robots.size(); i++) {
            for (int k = 0; k < ROBOT.size(); k++) {
                add(places, header.robots.get(i) + ROBOT.get(k), 0, i, k);
            }
        }
        int at = 0;
        for (int i = 0; i < header.sensors.size(); i++) {
            for (String number : header.numbers.get(i)) {
                add(places, header.sensors.get(i) + number, 1, at++, 0);
            }
        }
        for (int i = 0; i < header.lines.size(); i++) {
            for (int k = 0; k < LINE.size(); k++) {
                add(places, header.lines.get(i) + LINE.get(k), 2, i, k);
            }
        }
        for (int i = 0; i < header.objects.size(); i++) {
            for (int k = 0; k < OBJECT.size(); k++) {
                add(places, header.objects.get(i) + OBJECT.get(k), 3, i, k);
            }
        }
        return places;
    }

    /** Numbers a second value of the same name, for example from a sensor called {@code rover.x}. */
    private static void add(Map<String, int[]> places, String name, int... place) {
        String free = name;
        for (int i = 2; places.putIfAbsent(free, place) != null; i++) {
            free = name + " " + i;
        }
    }

    /**
     * Returns the names of the values: {@code rover.x}, {@code rover.heading}, {@code rover speed wanted},
     * {@code ping}, {@code accel.x}, {@code crate.y}, {@code lidar at /dev/SEAR_LIDAR_01 sent} (bytes so far).
     */
    public static Collection<String> names(RecordHeader header) {
        return Collections.unmodifiableCollection(places(header).keySet());
    }

    /**
     * Reads values of a record.
     *
     * @param most maximum number of frames; above it, every second, fourth ... is returned
     * @throws IllegalArgumentException with all legal names if one is unknown
     */
    public static Series of(RunRecord record, List<String> names, int most) throws IOException {
        Map<String, int[]> places = places(record.getHeader());
        List<int[]> wanted = new ArrayList<>();
        for (String name : names) {
            if (!places.containsKey(name)) {
                throw new IllegalArgumentException("no value is called \"" + name + "\", legal: "
                    + String.join(", ", places.keySet()));
            }
            wanted.add(places.get(name));
        }
        Collector collector = new Collector(record.getHeader(), wanted, most);
        boolean whole = record.read(collector);
        double[] times = collector.rows.stream().mapToDouble(row -> row[0]).toArray();
        double[][] values = new double[names.size()][times.length];
        for (int i = 0; i < times.length; i++) {
            for (int k = 0; k < values.length; k++) {
                values[k][i] = collector.rows.get(i)[k + 1];
            }
        }
        return new Series(whole, List.copyOf(names), times, values);
    }

    /** Returns the values as a table: the names, then a line for each time; empty where there is no number. */
    public String csv() {
        StringBuilder text = new StringBuilder("time (s)");
        names.forEach(name -> text.append(',')
            .append(name.matches("[^\",\n\r]*") ? name : '"' + name.replace("\"", "\"\"") + '"'));
        for (int i = 0; i < times.length; i++) {
            Interrupts.check();
            text.append('\n').append(String.format(Locale.ROOT, "%.4f", times[i]));
            for (double[] column : values) {
                text.append(',').append(Double.isNaN(column[i]) || Double.isInfinite(column[i]) ? ""
                    : Double.toString(column[i]));
            }
        }
        return text.append('\n').toString();
    }

    /** Returns the heading of a body with forward axis z, degrees clockwise from north, (-180, 180]. */
    static double heading(double[] robots, int at) {
        return new Pose(0, 0, 0, robots[at + 3], robots[at + 4], robots[at + 5], robots[at + 6]).heading();
    }

    private static final class Collector implements RunRecord.Visitor {
        private final List<int[]> wanted;
        private final double[][] commands;
        private final double[][] bytes;
        private final ThinnedList<double[]> rows;
        private long steps;

        Collector(RecordHeader header, List<int[]> wanted, int most) {
            this.wanted = wanted;
            commands = new double[header.robots.size()][ROBOT.size() - COMMANDS];
            for (double[] each : commands) {
                Arrays.fill(each, Double.NaN);
            }
            bytes = new double[header.lines.size()][LINE.size()];
            rows = new ThinnedList<>(most);
        }

        @Override
        public void step() {
            steps++;
        }

        @Override
        public void frame(double[] robots, double[] objects, double[] readings) {
            if (rows.isNextKept()) {
                double[] row = new double[wanted.size() + 1];
                row[0] = steps * Simulation.STEP;
                for (int i = 0; i < wanted.size(); i++) {
                    row[i + 1] = value(wanted.get(i), robots, objects, readings);
                }
                rows.add(row);
            } else {
                rows.pass();
            }
        }

        private double value(int[] place, double[] robots, double[] objects, double[] readings) {
            switch (place[0]) {
                case 0:
                    int at = place[1] * RunRecord.ROBOT;
                    if (place[2] >= COMMANDS) {
                        return commands[place[1]][place[2] - COMMANDS];
                    }
                    return place[2] < 3 ? robots[at + place[2]] : place[2] == 3 ? heading(robots, at)
                        : robots[at + POSE + place[2] - 4];
                case 1:
                    return readings[place[1]];
                case 2:
                    return bytes[place[1]][place[2]];
                default:
                    return objects[place[1] * POSE + place[2]];
            }
        }

        @Override
        public void drive(DriveCommand command) {
            double[] now = commands[command.robot];
            boolean same = command.wheels && command.first == command.second;
            now[0] = command.wheels ? (command.first + command.second) / 2 : command.first;
            now[1] = command.wheels ? same ? Double.POSITIVE_INFINITY : Double.NaN : command.second;
            now[2] = command.wheels ? command.first : Double.NaN;
            now[3] = command.wheels ? command.second : Double.NaN;
        }

        @Override
        public void heard(int line, byte[] sent) {
            bytes[line][0] += sent.length;
        }

        @Override
        public void said(int line, byte[] sent) {
            bytes[line][1] += sent.length;
        }
    }
}
