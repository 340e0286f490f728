package org.SEAR.benchmark;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Random;
import java.util.stream.Stream;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectException;
import org.SEAR.simulator.SerialLine;
import org.SEAR.simulator.Simulation;

/**
 * The world of the step benchmark: a walled room of 10 m x 10 m with fixed rotated boxes of 0.25 to 1 m outside of a ring, on which a robot with four
 * wheels drives in circles of 1 m radius. A LIDAR of 361 beams is read ten times a simulated second.
 */
public final class StepWorld implements AutoCloseable {
    private static final double SIDE = 10;
    private static final double WALL = 0.1;
    private static final double WALL_HEIGHT = 2;
    /** Boxes keep this far from the middle, metres. */
    private static final double CLEAR = 2.3;
    private static final double CIRCLE = 1;
    private static final double SPEED = 0.4;
    private static final int SCAN_EVERY = 6;
    private static final double STEPS_A_SECOND = 60;
    /** LMS200: send all scans (operating mode 0x24). */
    private static final int[] ALL_SCANS = {0x02, 0x00, 0x02, 0x00, 0x20, 0x24, 0x34, 0x08};
    /** Roomba: start, full mode, drive at 400 mm/s on a radius of 1000 mm, stream packet group 3, distance, angle and bumps. */
    private static final int[] STREAM = {128, 132, 137, 1, 0x90, 3, 0xE8, 148, 4, 3, 19, 20, 7};

    private final Simulation simulation;
    private final Path folder;
    private final boolean lidar;
    private final boolean all;

    /**
     * Fills a folder of its own with the objects.
     *
     * @param lidar whether there is one
     * @param all whether the robot has every sensor, and devices that send all the time
     */
    public StepWorld(int boxes, boolean lidar, boolean all) {
        this.lidar = lidar;
        this.all = all;
        try {
            folder = Files.createTempDirectory("sear-benchmark");
            System.setProperty("sear.project", folder.resolve("SEARproject").toString());
            room(boxes);
            robot();
            simulation = Simulation.of(Project.read(Project.presentFolder()), 1);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (ProjectException e) {
            throw new IllegalStateException(e);
        }
        if (all) {
            for (SerialLine line : simulation.getLines()) {
                line.setSink(bytes -> { });
                write(line, line.getObjectType().equals("LIDAR") ? ALL_SCANS : line.getObjectType().equals("Dynamics") ? STREAM : new int[0]);
            }
        }
        if (!all) {
            simulation.post(world -> world.getRobots().get(0).drive(SPEED, CIRCLE));
        }
    }

    private static void write(SerialLine line, int[] values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) values[i];
        }
        line.write(bytes);
    }

    private static void room(int boxes) {
        new Floor("floor", SIDE, SIDE);
        for (int wall = 0; wall < 4; wall++) {
            double at = (wall % 2 == 0 ? 1 : -1) * (SIDE + WALL) / 2;
            Box box = new Box("wall" + wall, wall < 2 ? SIDE : WALL, wall < 2 ? WALL : SIDE, WALL_HEIGHT, 0);
            box.move(wall < 2 ? 0 : at, WALL_HEIGHT / 2, wall < 2 ? at : 0);
        }
        Random random = new Random(2026);
        for (int i = 0; i < boxes; i++) {
            double x;
            double z;
            do {
                x = (random.nextDouble() - 0.5) * (SIDE - 1);
                z = (random.nextDouble() - 0.5) * (SIDE - 1);
            } while (Math.hypot(x, z) < CLEAR);
            Box box = new Box("box" + i, size(random), size(random), size(random), 0);
            box.move(x, 0.5, z);
            box.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
        }
    }

    private static double size(Random random) {
        return 0.25 + 0.75 * random.nextDouble();
    }

    private void robot() {
        SEARrobot robot = new SEARrobot("roomba");
        Dynamics dynamics = new Dynamics("dynamics", 40, 60, 0.3, 0.4, 10000, 0.1, -CIRCLE, 0.15, 0, 0, 0, 0);
        robot.addComponent(dynamics);
        robot.addComponent(new Cylinder("body", 0.1666875, 0.0762, 40));
        robot.addWheel(new Wheel("front", 0.0381, 0.03, 0, 0, 0, 0.16));
        robot.addWheel(new Wheel("right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel("left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel("back", 0.0381, 0.03, 0, 0, 0, -0.16));
        if (lidar) {
            LIDAR scanner = new LIDAR("lidar", 8, 180, 0.5, 0, 0.3, 0);
            if (all) {
                scanner.setPorts("lidarUart", "lidarUser");
            }
            robot.addComponent(scanner);
        }
        if (all) {
            dynamics.setPorts("oiUart", "oiUser");
            for (int i = 0; i < 4; i++) {
                robot.addComponent(new Distance("ping" + i, "PING", 0, 0.1, 0, 0, 90 * i, 0));
            }
            robot.addComponent(new GPS("gps", 48, 300, 11, "gpsUart", "gpsUser"));
            robot.addComponent(new Compass("compass"));
            robot.addComponent(new Accelerometer("accelerometer"));
            robot.addComponent(new Gyroscope("gyroscope"));
        }
    }

    /** A step, and what a script reads after it. */
    public void step() {
        simulation.step();
        if (simulation.getStep() % SCAN_EVERY == 0) {
            for (String name : simulation.getSensorNames()) {
                simulation.read(name);
            }
        }
    }

    /** The running world. */
    public Simulation getSimulation() {
        return simulation;
    }

    /** Steps a second are this many times real time when divided by it. */
    static double stepsASecond() {
        return STEPS_A_SECOND;
    }

    @Override
    public void close() {
        simulation.close();
        try (Stream<Path> files = Files.walk(folder)) {
            for (Path file : (Iterable<Path>) files.sorted(Comparator.reverseOrder())::iterator) {
                Files.delete(file);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
