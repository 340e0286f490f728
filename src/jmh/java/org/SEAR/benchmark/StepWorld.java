// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.nio.file.Path;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.devices.SerialLine;
import org.SEAR.simulator.Simulation;

/**
 * World of the step benchmark: a {@link Room} in which a four-wheeled robot drives in circles of 1 m radius. Its name
 * is EQUIPMENT-ROOM, for example {@code lidar-room-20}. Equipment: {@code drive} (no sensor); {@code lidar};
 * {@code lidarsN} (N LIDARs of 361 beams, read ten times per simulated second); {@code camera} (a colour camera of 320
 * x 240 at 10 Hz, each picture read); {@code blind} (the same camera, never read); {@code all} (every sensor, and
 * serial devices that send all the time).
 */
public final class StepWorld implements AutoCloseable {
    /** Radius of the circle, metres. */
    static final double CIRCLE = 1;
    /** Speed, m/s. */
    static final double SPEED = 0.4;
    /** Steps between two readings of the LIDAR. */
    static final int SCAN_EVERY = 6;
    /** Height of the first LIDAR above the body's origin, and distance between LIDARs, metres. */
    static final double LIDAR_HEIGHT = 0.3;
    static final double LIDAR_PITCH = 0.02;
    /** Initial height of the body's origin, metres. */
    static final double START_HEIGHT = 0.15;
    static final double RANGE = 8;
    private static final double STEPS_A_SECOND = 60;
    /** LMS200: send all scans (operating mode 0x24). */
    private static final int[] ALL_SCANS = {0x02, 0x00, 0x02, 0x00, 0x20, 0x24, 0x34, 0x08};
    /**
     * Roomba: start, full mode, drive at 400 mm/s on a radius of 1000 mm, stream packet group 3, distance, angle and
     * bumps.
     */
    private static final int[] STREAM = {128, 132, 137, 1, 0x90, 3, 0xE8, 148, 4, 3, 19, 20, 7};

    private final Room room;
    private final int lidars;
    private final BenchmarkProject project;
    private final Simulation simulation;
    private final boolean all;
    private final boolean camera;
    private final boolean blind;

    /** Creates a temporary project. */
    public StepWorld(String name) {
        this(name, null);
    }

    /** @param kept folder that keeps the project; null for a temporary one */
    StepWorld(String name, Path kept) {
        room = room(name);
        all = name.startsWith("all-");
        blind = name.startsWith("blind-");
        camera = blind || name.startsWith("camera-");
        lidars = lidars(name);
        project = new BenchmarkProject(kept, () -> {
            room.build();
            robot();
        });
        simulation = project.getSimulation();
        if (all) {
            for (SerialLine line : simulation.getLines()) {
                line.setSink((bytes, starts) -> { });
                write(line, line.getObjectType().equals("LIDAR") ? ALL_SCANS : line.getObjectType().equals("Dynamics")
                    ? STREAM : new int[0]);
            }
        } else {
            simulation.post(world -> world.getRobots().get(0).drive(SPEED, CIRCLE));
        }
    }

    /** Returns the number of LIDARs of a world's robot. */
    static int lidars(String name) {
        String equipment = name.substring(0, name.indexOf('-'));
        if (equipment.startsWith("lidars")) {
            return Integer.parseInt(equipment.substring("lidars".length()));
        }
        return equipment.matches("drive|camera|blind") ? 0 : 1;
    }

    /** Returns the static surroundings of a world. */
    static Room room(String name) {
        return new Room(name.substring(name.indexOf('-') + 1));
    }

    private static void write(SerialLine line, int[] values) {
        byte[] bytes = new byte[values.length];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) values[i];
        }
        line.write(bytes);
    }

    private void robot() {
        SEARrobot robot = new SEARrobot("roomba");
        Dynamics dynamics = new Dynamics("dynamics", 40, 60, 0.3, 0.4, 10000, 0.1, -CIRCLE, START_HEIGHT, 0, 0, 0, 0);
        robot.addComponent(dynamics);
        robot.addComponent(new Cylinder("body", 0.1666875, 0.0762, 40));
        robot.addWheel(new Wheel("front", 0.0381, 0.03, 0, 0, 0, 0.16));
        robot.addWheel(new Wheel("right", 0.0381, 0.03, 1, -0.16, 0, 0));
        robot.addWheel(new Wheel("left", 0.0381, 0.03, 1, 0.16, 0, 0));
        robot.addWheel(new Wheel("back", 0.0381, 0.03, 0, 0, 0, -0.16));
        for (int i = 0; i < lidars; i++) {
            LIDAR scanner = new LIDAR("lidar" + i, RANGE, 180, 0.5, 0, LIDAR_HEIGHT + i * LIDAR_PITCH, 0, 0,
                360.0 * i / lidars, 0);
            if (all) {
                scanner.setPorts("lidarUart", "lidarUser");
            }
            robot.addComponent(scanner);
        }
        if (camera) {
            robot.addComponent(new Camera("eye", 0, LIDAR_HEIGHT, 0, 10, 0, 0));
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

    /** Steps and reads as a script would. */
    public void step() {
        simulation.step();
        if (simulation.getStep() % SCAN_EVERY == 0 && !blind) {
            for (String name : simulation.getSensorNames()) {
                simulation.read(name);
            }
        }
    }

    public Simulation getSimulation() {
        return simulation;
    }

    /** Returns the steps per second of real time. */
    static double stepsASecond() {
        return STEPS_A_SECOND;
    }

    @Override
    public void close() {
        project.close();
    }
}
