package org.SEAR.learning;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.LineSensor;
import org.SEAR.geometry.Pose;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.ColorReading;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Switch;
import org.SEAR.sensors.Truth;
import org.SEAR.simulator.Simulation;

/**
 * Observation of a learner after a step: the readings of sensors, then the relative poses of objects, as from a beacon.
 * A LIDAR contributes each beam, right to left. Each number is a float of four bytes. Simulation thread.
 */
final class Observation {
    private static final double PERCENT = 100;
    private static final double FULL = 255;
    /**
     * Numbers of an object: metres ahead and to the left; cosine and sine of the angle from the robot's forward axis to
     * the object's, + left.
     */
    private static final int PLACE = 4;

    private final Simulation simulation;
    private final Robot robot;
    private final List<Part> parts = new ArrayList<>();
    private final int size;

    /** The numbers of one sensor or object. */
    private static final class Part {
        final String name;
        final int at;
        final int size;
        final double low;
        final double high;
        /** Null for an object. */
        final Sensor<?> sensor;
        final Truth truth;

        Part(String name, int at, int size, double low, double high, Sensor<?> sensor, Truth truth) {
            this.name = name;
            this.at = at;
            this.size = size;
            this.low = low;
            this.high = high;
            this.sensor = sensor;
            this.truth = truth;
        }
    }

    /** @throws IllegalArgumentException for an unknown sensor or object, or a camera */
    Observation(Simulation simulation, Robot robot, List<String> sensors, List<String> things) {
        this.simulation = simulation;
        this.robot = robot;
        int at = 0;
        for (String name : sensors) {
            at += add(simulation.getSensor(name), name, at);
        }
        for (String name : things) {
            simulation.getPose(name);
            parts.add(new Part(name, at, PLACE, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, null, null));
            at += PLACE;
        }
        size = at;
    }

    private int add(Sensor<?> sensor, String name, int at) {
        Robot carrier = simulation.getRobots().stream().filter(one -> one.getSensors().contains(sensor)).findFirst().orElseThrow();
        Reading reading = sensor.read(carrier.getTruth());
        if (reading.picture() != null) {
            throw new IllegalArgumentException("sensor " + name + " can't be observed, it takes pictures; legal: "
                + String.join(", ", numeric(carrier)));
        }
        double[] range = range(sensor, reading);
        parts.add(new Part(name, at, reading.scan() == null ? reading.numbers().length : reading.scan().size(), range[0], range[1], sensor,
            carrier.getTruth()));
        return parts.get(parts.size() - 1).size;
    }

    /** Returns the names of a robot's sensors that can be observed, in the order of its components. */
    static List<String> numeric(Robot robot) {
        return robot.getSensors().stream().filter(one -> one.read(robot.getTruth()).picture() == null).map(Sensor::getName)
            .collect(Collectors.toList());
    }

    /** Returns the lowest and highest reading of a sensor. */
    private static double[] range(Sensor<?> sensor, Reading reading) {
        if (reading.scan() != null) {
            return new double[] {0, reading.scan().getMaxRange()};
        } else if (reading instanceof DistanceReading) {
            return new double[] {0, ((DistanceReading) reading).getPattern().getMaxRange()};
        } else if (reading instanceof ColorReading) {
            return new double[] {0, FULL};
        } else if (reading instanceof Switch) {
            return new double[] {0, 1};
        }
        return sensor.getParameters() instanceof LineSensor ? new double[] {0, PERCENT}
            : new double[] {Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY};
    }

    int size() {
        return size;
    }

    List<String> names() {
        return parts.stream().map(part -> part.name).collect(Collectors.toList());
    }

    int[] sizes() {
        return parts.stream().mapToInt(part -> part.size).toArray();
    }

    double[] lows() {
        return parts.stream().mapToDouble(part -> part.low).toArray();
    }

    double[] highs() {
        return parts.stream().mapToDouble(part -> part.high).toArray();
    }

    /**
     * Initialises the numbers before the first step, for those that drop out in it: 0, limited to the sensor's range.
     */
    void clear(ByteBuffer to, int start) {
        for (Part part : parts) {
            for (int i = 0; i < part.size; i++) {
                put(to, start, part.at + i, Math.max(part.low, Math.min(part.high, 0)));
            }
        }
    }

    /**
     * Writes the present observation. A number that drops out keeps its previous value.
     *
     * @param start the byte of the first number
     */
    void write(ByteBuffer to, int start) {
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            if (part.sensor == null) {
                place(part, to, start);
                continue;
            }
            Reading reading = part.sensor.read(part.truth);
            LidarScan scan = reading.scan();
            if (scan == null) {
                double[] numbers = reading.numbers();
                for (int k = 0; k < part.size; k++) {
                    put(to, start, part.at + k, numbers[k]);
                }
            } else {
                for (int beam = 0; beam < part.size; beam++) {
                    put(to, start, part.at + beam, Math.min(scan.range(beam), part.high));
                }
            }
        }
    }

    private void place(Part part, ByteBuffer to, int start) {
        Pose pose = robot.getPose();
        Pose thing = simulation.getPose(part.name);
        double[] from = pose.rotateBack(thing.x - pose.x, thing.y - pose.y, thing.z - pose.z);
        double[] along = thing.rotate(0, 0, 1);
        double[] turned = pose.rotateBack(along[0], along[1], along[2]);
        double length = Math.hypot(turned[0], turned[2]);
        put(to, start, part.at, from[2]);
        put(to, start, part.at + 1, from[0]);
        put(to, start, part.at + 2, length == 0 ? 1 : turned[2] / length);
        put(to, start, part.at + 3, length == 0 ? 0 : turned[0] / length);
    }

    private static void put(ByteBuffer to, int start, int number, double value) {
        if (!Double.isNaN(value)) {
            to.putFloat(start + number * Float.BYTES, (float) value);
        }
    }
}
