// SPDX-License-Identifier: Apache-2.0
package org.SEAR.learning;

import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.SEAR.POJOs.LineSensor;
import org.SEAR.geometry.Pose;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.ColorReading;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.sensors.GpsFix;
import org.SEAR.sensors.GpsSensor;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Picture;
import org.SEAR.sensors.Reading;
import org.SEAR.sensors.Sensor;
import org.SEAR.sensors.Switch;
import org.SEAR.sensors.Truth;
import org.SEAR.simulator.Simulation;

/**
 * Observation of a learner after a step: the readings of sensors and joints, then the relative poses of objects, as
 * from a beacon. A LIDAR contributes each beam, right to left; a GPS metres north, up and east of the world's origin,
 * because degrees don't fit into a float. Each number is a float of four bytes. The pictures of cameras follow the
 * numbers: red, green and blue of each pixel, a byte each, row by row from the top left. Simulation thread.
 */
final class Observation {
    private static final double PERCENT = 100;
    private static final double FULL = 255;
    /** Red, green and blue. */
    private static final int CHANNELS = 3;
    /**
     * Numbers of an object: metres ahead and to the left; cosine and sine of the angle from the robot's forward axis to
     * the object's, + left.
     */
    private static final int PLACE = 4;

    private final Simulation simulation;
    private final Robot robot;
    private final List<Part> parts = new ArrayList<>();
    private final List<Camera> cameras = new ArrayList<>();
    private final int size;
    private int pictureBytes;

    /** A camera, and the byte of its picture behind the numbers. */
    private static final class Camera {
        final Sensor<?> sensor;
        final Truth truth;
        final int at;
        final int width;
        final int height;

        Camera(Sensor<?> sensor, Truth truth, int at, Picture picture) {
            this.sensor = sensor;
            this.truth = truth;
            this.at = at;
            width = picture.getWidth();
            height = picture.getHeight();
        }
    }

    /** The numbers of one sensor, joint or object. */
    private static final class Part {
        final String name;
        final int at;
        final int size;
        final double low;
        final double high;
        /** Null for a joint or object. */
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

    /** @throws IllegalArgumentException for an unknown sensor or object, or without any */
    Observation(Simulation simulation, Robot robot, List<String> sensors, List<String> things) {
        this.simulation = simulation;
        this.robot = robot;
        if (sensors.isEmpty() && things.isEmpty()) {
            String names = robot.getSensors().stream().map(Sensor::getName).collect(Collectors.joining(", "));
            throw new IllegalArgumentException("robot " + robot.getObject().getName() + " observes nothing: sensors "
                + "and things are empty, legal: "
                + (names.isEmpty() ? "names of objects in things, because the robot has no sensors"
                    : "sensors of " + names + ", or names of objects in things"));
        }
        int at = 0;
        for (String name : sensors) {
            at += simulation.getJoints().isRead(name) ? addJoint(name, at) : add(simulation.getSensor(name), name, at);
        }
        for (String name : things) {
            simulation.getPose(name);
            parts.add(new Part(name, at, PLACE, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, null, null));
            at += PLACE;
        }
        size = at;
    }

    private int addJoint(String name, int at) {
        int count = simulation.read(name).numbers().length;
        parts.add(new Part(name, at, count, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, null, null));
        return count;
    }

    private int add(Sensor<?> sensor, String name, int at) {
        Robot carrier = simulation.getRobots().stream().filter(one -> one.getSensors().contains(sensor)).findFirst()
            .orElseThrow();
        Reading reading = sensor.read(carrier.getTruth());
        Picture picture = reading.picture();
        if (picture != null) {
            cameras.add(new Camera(sensor, carrier.getTruth(), pictureBytes, picture));
            pictureBytes += picture.getWidth() * picture.getHeight() * CHANNELS;
            return 0;
        }
        double[] range = range(sensor, reading);
        parts.add(new Part(name, at, reading.scan() == null ? reading.numbers().length : reading.scan().size(),
            range[0], range[1], sensor, carrier.getTruth()));
        return parts.get(parts.size() - 1).size;
    }

    /** Returns the names of a robot's sensors except cameras, or of its cameras if it has no others. */
    static List<String> usual(Robot robot) {
        Map<Boolean, List<String>> names = robot.getSensors().stream().collect(Collectors.partitioningBy(
            one -> one.read(robot.getTruth()).picture() == null,
                Collectors.mapping(Sensor::getName, Collectors.toList())));
        return names.get(names.get(true).isEmpty() ? Boolean.FALSE : Boolean.TRUE);
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

    /** Returns the size of all numbers and pictures in bytes. */
    int bytes() {
        return size * Float.BYTES + pictureBytes;
    }

    /** Returns the count of the numbers. */
    int size() {
        return size;
    }

    List<String> pictureNames() {
        return cameras.stream().map(one -> one.sensor.getName()).collect(Collectors.toList());
    }

    /** Returns width and height of each camera's picture, pixels. */
    int[] pictureSizes() {
        return cameras.stream().flatMapToInt(one -> IntStream.of(one.width, one.height)).toArray();
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
        writePictures(to, start + size * Float.BYTES);
        for (int i = 0; i < parts.size(); i++) {
            Part part = parts.get(i);
            if (part.sensor == null && simulation.getJoints().isRead(part.name)) {
                double[] numbers = simulation.read(part.name).numbers();
                for (int k = 0; k < part.size; k++) {
                    put(to, start, part.at + k, numbers[k]);
                }
                continue;
            } else if (part.sensor == null) {
                place(part, to, start);
                continue;
            }
            Reading reading = part.sensor.read(part.truth);
            LidarScan scan = reading.scan();
            if (scan == null) {
                double[] numbers = part.sensor instanceof GpsSensor ? ((GpsSensor) part.sensor)
                    .metres((GpsFix) reading, part.truth) : reading.numbers();
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

    private void writePictures(ByteBuffer to, int start) {
        for (Camera camera : cameras) {
            int at = start + camera.at;
            for (int pixel : camera.sensor.read(camera.truth).picture().getPixels()) {
                to.put(at++, (byte) (pixel >> 16));
                to.put(at++, (byte) (pixel >> 8));
                to.put(at++, (byte) pixel);
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
