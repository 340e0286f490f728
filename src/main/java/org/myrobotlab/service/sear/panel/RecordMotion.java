// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.record.Rerun;
import org.SEAR.record.RunRecord;
import org.SEAR.record.ThinnedList;
import org.SEAR.simulator.Simulation;

/**
 * Motion that a record itself lacks and its replay needs: rotations of wheels and servos, and beams of sensors. Reruns
 * the record's commands in a separate world to compute it. One use, one thread.
 */
public final class RecordMotion {
    /** Steps per frame, the rate at which panels see a running world. */
    private static final int EVERY = 6;
    /** Limits of frames, numbers and beams per message; beyond one, only every second, fourth ... frame is kept. */
    private static final int MAX_FRAMES = 2000;
    private static final int MAX_NUMBERS = 60000;
    private static final int MAX_BEAMS = 150000;
    /** Most beams of a scanner; of more, only every second, third ... is kept. */
    private static final int WIDEST = 181;
    private static final int POSE = 6;
    private static final double CENTIMETRES = 100;
    private static final double FINE = 1e4;
    private static final int NOTHING = 0xffff;

    private final WorldJson json = new WorldJson(new LookTable());
    private final Answer answer = new Answer();
    /** Indices of the sensors with visible beams. */
    private int[] seeing;
    /** Indices of the kept beams, for each of these sensors. */
    private List<int[]> beams;
    private ThinnedList<Frame> kept;
    private long steps;

    private RecordMotion() {
    }

    /** The answer to panels. */
    private static final class Answer extends JsonForm {
        String path;
        /** The reason why there is no motion; null if there is motion. */
        String why;
        List<String> robots;
        /** Sensors with visible beams, see {@link WorldState.Probe}. */
        List<WorldState.Probe> sensors;
        List<Frame> frames;
    }

    /** One moment. */
    private static final class Frame extends JsonForm {
        /** Simulated seconds since the record began. */
        double time;
        /** By robot, see {@link WorldState.Mover}. */
        Object[] wheels;
        Object[] turned;
        Object[] leds;
        /** Pose of each sensor. */
        double[][] poses;
        /**
         * Ranges of a scanner, else null: centimetres of each beam in 16 bits, low byte first, in base64; 65535 without
         * a hit.
         */
        String[] ranges;
        /** Nearest hit of the beams; null if there is none. */
        double[][] hits;
    }

    /**
     * Returns the motion of a record.
     *
     * <pre>
     * {"path": .., "why": "reason why there is none", "robots": [name, ..],
     *  "sensors": [{"name": .., "type": .., "robot": .., "cones": .., "fan": ..}, ..], "frames": [{"time": ..,
     *  "wheels": [[[x, y, z, rx, ry, rz] of each wheel, ..] of each robot, ..],
     *  "turned": likewise, of the parts of a robot with servos, "leds": likewise,
     *  "poses": [of each sensor, ..], "ranges": [text, ..], "hits": [[x, y, z], ..]}, ..]}
     * </pre>
     *
     * @param project the recorded project
     */
    public static Map<String, Object> of(String path, RunRecord record, Path project) throws IOException {
        RecordMotion motion = new RecordMotion();
        motion.answer.path = path;
        try {
            Rerun.of(record, Project.read(project), motion::see);
            motion.answer.frames = motion.kept.stream().collect(Collectors.toList());
        } catch (IOException | ProjectException e) {
            motion.answer.why = e.getMessage();
        }
        return motion.answer.map();
    }

    private void see(Simulation world) {
        if (kept == null) {
            begin(json.whole(world, new WorldState()));
        }
        if (steps % EVERY == 0) {
            if (kept.isNextKept()) {
                kept.add(frame(json.moving(world, new WorldState())));
            } else {
                kept.pass();
            }
        }
        steps++;
    }

    private void begin(WorldState whole) {
        answer.robots = whole.robots.stream().map(robot -> robot.name).collect(Collectors.toList());
        seeing = IntStream.range(0, whole.sensors.size()).filter(i -> isSeen(whole.sensors.get(i))).toArray();
        answer.sensors = Arrays.stream(seeing).mapToObj(whole.sensors::get).map(RecordMotion::form)
            .collect(Collectors.toList());
        beams = Arrays.stream(seeing).mapToObj(whole.sensors::get).map(RecordMotion::beams)
            .collect(Collectors.toList());
        for (int i = 0; i < seeing.length; i++) {
            int[] some = beams.get(i);
            List<float[]> fan = answer.sensors.get(i).fan;
            answer.sensors.get(i).fan = fan == null ? null : Arrays.stream(some).mapToObj(fan::get)
                .map(RecordMotion::rounded).collect(Collectors.toList());
        }
        int poses = seeing.length + whole.robots.stream().mapToInt(RecordMotion::poses).sum();
        int rays = beams.stream().mapToInt(some -> some.length).sum();
        kept = new ThinnedList<>(Math.min(
            MAX_FRAMES, Math.min(MAX_NUMBERS / (1 + POSE * poses), MAX_BEAMS / (1 + rays))));
    }

    private static int poses(WorldState.Mover robot) {
        return robot.wheels.size() + (robot.turned == null ? 0 : robot.turned.size())
            + (robot.turnedLeds == null ? 0 : robot.turnedLeds.size());
    }

    private static boolean isSeen(WorldState.Probe sensor) {
        return sensor.cones != null || sensor.hit != null || sensor.ranges != null && sensor.fan != null;
    }

    /** Returns the constant fields of a sensor. */
    private static WorldState.Probe form(WorldState.Probe sensor) {
        WorldState.Probe form = new WorldState.Probe();
        form.name = sensor.name;
        form.type = sensor.type;
        form.robot = sensor.robot;
        form.cones = sensor.cones;
        form.fan = sensor.fan;
        return form;
    }

    private static int[] beams(WorldState.Probe sensor) {
        int count = sensor.ranges == null ? 0 : sensor.ranges.size();
        int each = Math.max(1, (int) Math.ceil((count - 1) / (WIDEST - 1.0)));
        return IntStream.range(0, count).filter(i -> i % each == 0).toArray();
    }

    private static float[] rounded(float[] direction) {
        float[] shorter = new float[direction.length];
        for (int i = 0; i < shorter.length; i++) {
            shorter[i] = (float) JsonNumbers.rounded(direction[i], FINE);
        }
        return shorter;
    }

    private Frame frame(WorldState now) {
        Frame frame = new Frame();
        frame.time = JsonNumbers.rounded(steps * Simulation.STEP, FINE);
        frame.wheels = poses(now, robot -> robot.wheels);
        frame.turned = poses(now, robot -> robot.turned);
        frame.leds = poses(now, robot -> robot.turnedLeds);
        frame.poses = new double[seeing.length][];
        frame.ranges = new String[seeing.length];
        frame.hits = new double[seeing.length][];
        for (int i = 0; i < seeing.length; i++) {
            WorldState.Probe sensor = now.sensors.get(seeing[i]);
            frame.poses[i] = JsonNumbers.numbers(sensor.pose);
            frame.ranges[i] = sensor.ranges == null ? null : packed(sensor.ranges, beams.get(i));
            frame.hits[i] = sensor.hit == null ? null : sensor.hit.orElse(null);
        }
        return frame;
    }

    private static Object[] poses(WorldState now, Function<WorldState.Mover, List<Pose>> of) {
        return now.robots.stream().map(of).map(JsonForm::plain).toArray();
    }

    private static String packed(ScanRanges ranges, int[] some) {
        ByteBuffer bytes = ByteBuffer.allocate(2 * some.length).order(ByteOrder.LITTLE_ENDIAN);
        for (int beam : some) {
            double metres = ranges.get(beam);
            bytes.putShort((short) (ScanRanges.isHit(metres) ? Math.min(NOTHING - 1, Math.round(metres * CENTIMETRES))
                : NOTHING));
        }
        return Base64.getEncoder().encodeToString(bytes.array());
    }
}
