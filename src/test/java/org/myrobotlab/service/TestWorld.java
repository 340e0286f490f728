// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
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

/** A floor, a wall 2 m ahead, and a Roomba with one of each sensor at the origin, facing +z. */
public final class TestWorld {
    public static final String ROOMBA_PORT = "/dev/SEAR_Robot_01";
    public static final String LIDAR_PORT = "/dev/SEAR_LIDAR_01";
    public static final String GPS_PORT = "/dev/SEAR_GPS_01";
    /** Distance of the wall's near face, metres. */
    public static final double WALL = 2;
    /** Distance of the LIDAR ahead of the robot's middle, metres. */
    static final double LIDAR_Z = 0.1;

    private TestWorld() {
    }

    /** Writes the project below a folder and makes it the present one. */
    public static Path build(Path parent) {
        Path folder = parent.resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        Floor floor = new Floor("floor", 40, 40, false);
        floor.move(0, 0, 0);
        Box wall = new Box("wall", 20, 0.2, 1, 0);
        wall.move(0, 0.5, WALL + 0.1);
        SEARrobot robot = new SEARrobot("roomba");
        Dynamics dynamics = new Dynamics("drive", 4, 60, 0.3, 0.4, 10000, 0.1, 0, 0.1, 0, 0, 0, 0);
        dynamics.setPorts("/dev/my_Robot01", ROOMBA_PORT);
        robot.addComponent(dynamics);
        robot.addComponent(new Cylinder("body", 0.1666875, 0.0762, 4));
        for (double[] at : new double[][] {{0, 0.16, 0}, {-0.129, 0, 1}, {0.129, 0, 1}, {0, -0.16, 0}}) {
            Wheel wheel = new Wheel("wheel" + robot.getWheels().size(), 0.0381, 0.03, (int) at[2]);
            wheel.move(at[0], 0, at[1]);
            robot.addWheel(wheel);
        }
        LIDAR lidar = new LIDAR("scanner");
        lidar.setRange(8.191);
        lidar.setSpread(180);
        lidar.setResolution(1);
        lidar.setPorts("/dev/my_Lidar01", LIDAR_PORT);
        lidar.setBaud(38400);
        lidar.move(0, 0.15, LIDAR_Z);
        robot.addComponent(lidar);
        GPS gps = new GPS("receiver", 33.61, 182.5, -80.865);
        gps.setPorts("/dev/my_GPS_01", GPS_PORT);
        robot.addComponent(gps);
        Distance ping = new Distance("ping", "PING)))");
        ping.move(0, 0.2, 0.15);
        robot.addComponent(ping);
        robot.addComponent(new Compass("compass"));
        robot.addComponent(new Accelerometer("accel"));
        robot.addComponent(new Gyroscope("gyro"));
        return folder;
    }

    /** Returns the names of all live threads that SEAR started. */
    public static List<String> threads() {
        List<String> names = new ArrayList<>();
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            String name = thread.getName();
            if (thread.isAlive() && (name.startsWith("SEAR ") || name.contains("/dev/")
                || name.startsWith("serial time-outs") || name.contains("simulator_Serial_Service"))) {
                names.add(name);
            }
        }
        return names;
    }

    /**
     * Waits up to a minute until all of these threads have ended, because threads end a moment after their shutdown.
     */
    public static void assertNoThreads() {
        long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
        while (!threads().isEmpty() && System.nanoTime() < end) {
            LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(1));
        }
        assertEquals(Collections.emptyList(), threads());
    }

    /** Writes text into a file of the project. */
    static void write(Path folder, String file, String text) throws IOException {
        Files.createDirectories(folder.resolve(file).getParent());
        Files.writeString(folder.resolve(file), text);
    }
}
