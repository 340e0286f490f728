// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.SEAR.simulator.Simulation;

/** Poses and readings at selected times of a record, for panels that replay it. Immutable; any thread. */
public final class Frames {
    /** Maximum count of numbers in all frames together. */
    private static final int MAX_NUMBERS = 100000;
    private static final int MAX_LIGHTS = 10000;
    private static final int POSE = 7;
    private static final int SPEEDS = RunRecord.ROBOT - POSE;

    /** Simulated seconds since the record began. */
    public final List<Double> times = new ArrayList<>();
    /** By time and robot: x, y, z and the quaternion x, y, z, w. */
    public final List<List<double[]>> robots = new ArrayList<>();
    /** By time and robot: speed in m/s, turn rate in rad/s. */
    public final List<List<double[]>> speeds = new ArrayList<>();
    /** By time and moving object, in the order of {@link #moved}. */
    public final List<List<double[]>> objects = new ArrayList<>();
    /** By time: the numbers of all sensors. */
    public final List<double[]> readings = new ArrayList<>();
    /** By time and light, in the order of {@link #lights}: brightness, 0 to 1. */
    public final List<double[]> brightness = new ArrayList<>();
    /** Numbers of the objects that move in the record. */
    public final List<Integer> moved = new ArrayList<>();
    /** Numbers of robots and their lights, {robot, light}; at most 10000. */
    public final List<int[]> lights = new ArrayList<>();
    /** Numbers of the sensors with pictures, see {@link RecordPictures}. */
    public final Set<Integer> pictured = new TreeSet<>();
    /** False if the record was cut off or is still being written. */
    public final boolean whole;

    private final Map<List<Integer>, Integer> lightPlaces = new HashMap<>();

    private Frames(RunRecord record, int most) throws IOException {
        record.read(new Finder(record.getHeader().objects.size()));
        int robotCount = record.getHeader().robots.size();
        int read = record.getHeader().sizes.stream().mapToInt(Integer::intValue).sum();
        int numbers = RunRecord.ROBOT * robotCount + POSE * moved.size() + read + lights.size() + 1;
        ThinnedList<double[][]> kept = new ThinnedList<>(Math.min(most, MAX_NUMBERS / numbers));
        whole = record.read(new Keeper(kept, robotCount));
        kept.stream().forEach(frame -> {
            times.add(frame[0][0]);
            robots.add(cut(frame[1], POSE));
            objects.add(cut(frame[2], POSE));
            speeds.add(cut(frame[3], SPEEDS));
            readings.add(frame[4]);
            brightness.add(frame[5]);
        });
    }

    private static List<double[]> cut(double[] numbers, int each) {
        List<double[]> all = new ArrayList<>();
        for (int i = 0; i < numbers.length; i += each) {
            all.add(Arrays.copyOfRange(numbers, i, i + each));
        }
        return all;
    }

    /** Finds moving objects, lights and pictures. */
    private final class Finder implements RunRecord.Visitor {
        private final boolean[] moves;
        private final double[] first;
        private boolean begun;

        Finder(int objectCount) {
            moves = new boolean[objectCount];
            first = new double[objectCount * POSE];
        }

        @Override
        public void frame(double[] robotPoses, double[] objectPoses, double[] read) {
            if (!begun) {
                System.arraycopy(objectPoses, 0, first, 0, first.length);
            }
            begun = true;
            for (int i = 0; i < moves.length; i++) {
                if (!moves[i] && !Arrays.equals(first, i * POSE, (i + 1) * POSE, objectPoses, i * POSE,
                    (i + 1) * POSE)) {
                    moves[i] = true;
                    moved.add(i);
                }
            }
        }

        @Override
        public void picture(int sensor, String kind, double time, long offset, int length) {
            pictured.add(sensor);
        }

        @Override
        public void light(int robot, int light, double bright) {
            if (lights.size() < MAX_LIGHTS && lightPlaces.putIfAbsent(List.of(robot, light), lights.size()) == null) {
                lights.add(new int[] {robot, light});
            }
        }
    }

    private final class Keeper implements RunRecord.Visitor {
        private final ThinnedList<double[][]> kept;
        private final int robotCount;
        private final double[] bright = new double[lights.size()];
        private long steps;

        Keeper(ThinnedList<double[][]> kept, int robotCount) {
            this.kept = kept;
            this.robotCount = robotCount;
        }

        @Override
        public void step() {
            steps++;
        }

        @Override
        public void light(int robot, int light, double brightnessNow) {
            Integer place = lightPlaces.get(List.of(robot, light));
            if (place != null) {
                bright[place] = brightnessNow;
            }
        }

        @Override
        public void frame(double[] robotPoses, double[] objectPoses, double[] read) {
            if (!kept.isNextKept()) {
                kept.pass();
                return;
            }
            double[] bodies = new double[robotCount * POSE];
            double[] fast = new double[robotCount * SPEEDS];
            for (int i = 0; i < robotCount; i++) {
                System.arraycopy(robotPoses, i * RunRecord.ROBOT, bodies, i * POSE, POSE);
                System.arraycopy(robotPoses, i * RunRecord.ROBOT + POSE, fast, i * SPEEDS, SPEEDS);
            }
            double[] things = new double[moved.size() * POSE];
            for (int i = 0; i < moved.size(); i++) {
                System.arraycopy(objectPoses, moved.get(i) * POSE, things, i * POSE, POSE);
            }
            kept.add(new double[][] {{steps * Simulation.STEP}, bodies, things, fast, read.clone(), bright.clone()});
        }
    }

    /**
     * Reads the frames of a record.
     *
     * @param most maximum number of frames; above it, every second, fourth ... frame is kept
     */
    public static Frames of(RunRecord record, int most) throws IOException {
        return new Frames(record, most);
    }
}
