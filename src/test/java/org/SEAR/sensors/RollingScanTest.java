// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.Arrays;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.raycast.BeamScene;
import org.junit.Rule;
import org.junit.Test;

/** Beams that are measured one after another, compared with the closed form of a room of four walls. */
public class RollingScanTest {
    private static final double MILLIMETRE = 0.001;
    /** Distance of the walls from the origin, metres. */
    private static final double HALF = 3;
    /** Degrees per second. */
    private static final double TURN = 90;
    private static final double SCAN_TIME = 0.1;
    private static final int STEPS = 100;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final ScriptedTruth truth = new ScriptedTruth();

    private LidarSensor sensor(double scanTime, Noise noise) {
        LIDAR lidar = new LIDAR("lidar");
        lidar.setSpread(270);
        lidar.setResolution(0.5);
        lidar.setScanTime(scanTime);
        lidar.setNoise(noise);
        lidar.rotate(0, 30, 0);
        truth.scene = room();
        return new LidarSensor(lidar, 1);
    }

    private static BeamScene room() {
        BeamScene scene = new BeamScene();
        for (int wall = 0; wall < 4; wall++) {
            double side = wall % 2 == 0 ? HALF + 1 : -HALF - 1;
            int box = wall < 2 ? scene.addBox(1, 1, 10, BeamScene.WORLD) : scene.addBox(10, 1, 1, BeamScene.WORLD);
            scene.setPose(box, wall < 2 ? side : 0, 0, wall < 2 ? 0 : side, 0, 0, 0, 1);
        }
        scene.commit();
        return scene;
    }

    /** Distance of the walls at a time from x = speed * time, in the world's direction: an angle from +z to +x. */
    private static double walls(double time, double speed, double degrees) {
        double sine = Math.sin(Math.toRadians(degrees));
        double cosine = Math.cos(Math.toRadians(degrees));
        double x = speed * time;
        return Math.min(((sine > 0 ? HALF : -HALF) - x) / sine, HALF / Math.abs(cosine));
    }

    private void drive(LidarSensor sensor, double speed, double turn, int steps) {
        for (int i = 0; i < steps; i++) {
            double next = (truth.step + 1) * ScriptedTruth.STEP;
            truth.at(speed * next, 0, 0, 0, turn * next, 0).advance(sensor);
        }
    }

    @Test
    public void eachBeamOfATurningRobotIsOfItsOwnTime() {
        LidarSensor sensor = sensor(SCAN_TIME, null);
        drive(sensor, 0.5, TURN, STEPS);
        LidarScan scan = sensor.read(truth);
        assertEquals(541, scan.size());
        for (int beam = 0; beam < scan.size(); beam++) {
            double time = truth.time() - (540 - beam) * SCAN_TIME / 720;
            double expected = walls(time, 0.5, 30 + TURN * time + scan.angle(beam));
            assertEquals("beam " + beam, expected, scan.range(beam), MILLIMETRE);
        }
    }

    @Test
    public void beamsOfDevicesAreExactWithinAndAfterTheLastSteps() {
        LidarSensor sensor = sensor(0, null);
        drive(sensor, 0.5, TURN, 150);
        LidarScan scan = sensor.scan(truth, 270, 0.5);
        drive(sensor, 0.5, TURN, 10);
        for (int beam = 0; beam < scan.size(); beam++) {
            for (double time : new double[] {truth.time() - 1.9 + beam / 600.0, truth.time() + 0.0155}) {
                double expected = walls(time, 0.5, 30 + TURN * time + scan.angle(beam));
                assertEquals("beam " + beam + " at " + time, expected, sensor.range(truth, scan, beam, time),
                    MILLIMETRE);
            }
        }
    }

    @Test
    public void aRobotAtRestReadsTheSameBytes() {
        Noise noise = new Noise().setWhite(0.01).setDropout(0.1);
        LidarSensor rolling = sensor(SCAN_TIME, noise);
        LidarSensor instant = sensor(0, noise);
        drive(rolling, 0, 0, 1);
        assertArrayEquals("from the first step", instant.read(truth).ranges(), rolling.read(truth).ranges(), 0);
        drive(rolling, 0, TURN, 30);
        assertNotEquals(Arrays.toString(instant.read(truth).ranges()), Arrays.toString(rolling.read(truth).ranges()));
        Pose stands = truth.body;
        for (int i = 0; i < 7; i++) {
            truth.body = new Pose(stands.x + 1e-7, stands.y, stands.z, stands.qx, stands.qy, stands.qz, stands.qw);
            truth.advance(rolling);
        }
        assertArrayEquals(instant.read(truth).ranges(), rolling.read(truth).ranges(), 0);
    }

    /** A pole of 0.1 m that crosses from right to left, 2 m ahead of a resting sensor, at 3 m/s. */
    private int crossing(LidarSensor sensor, int steps) {
        int pole = truth.scene.addBox(0.05, 1, 0.05, BeamScene.WORLD);
        for (int i = 0; i <= steps; i++) {
            truth.scene.setPose(pole, -0.5 + 3 * i * ScriptedTruth.STEP, 0, 2, 0, 0, 0, 1);
            truth.scene.commit();
            if (i > 0) {
                truth.at(0, 0, 0, 0, -30, 0).advance(sensor);
            }
        }
        return pole;
    }

    private static double poleOrWall(double time, double degrees) {
        double side = 1.95 * Math.tan(Math.toRadians(degrees));
        return Math.abs(side - (-0.5 + 3 * time)) < 0.05 ? 1.95 / Math.cos(Math.toRadians(degrees))
            : walls(0, 0, degrees);
    }

    /** With 10 turns per second the crossing pole appears 0.083 m wide, not 0.1 m, as it moves with the beams. */
    @Test
    public void eachBeamSeesAMovingObstacleAtItsOwnTime() {
        LidarSensor instant = sensor(0, null);
        LidarSensor sensor = sensor(SCAN_TIME, null);
        crossing(sensor, 12);
        LidarScan scan = sensor.read(truth);
        int hits = 0;
        int far = 0;
        for (int beam = 0; beam < scan.size(); beam++) {
            double time = truth.time() - (540 - beam) * SCAN_TIME / 720;
            double expected = poleOrWall(time, scan.angle(beam));
            far += Math.abs(expected - scan.range(beam)) > MILLIMETRE ? 1 : 0;
            hits += scan.range(beam) < 2 ? 1 : 0;
        }
        assertTrue(hits + " beams on the pole", hits > 4);
        assertTrue(far + " beams off, of those at its edges and faces", far <= 2);
        assertTrue("a device, ahead of the step", sensor.range(truth, scan, 270, truth.time() + 0.01) > 2.9);
        truth.scene.forgetMotion();
        truth.advance(sensor);
        assertArrayEquals("after a teleport", instant.read(truth).ranges(), sensor.read(truth).ranges(), 0);
    }

    @Test
    public void aTeleportIsNoMovement() {
        LidarSensor sensor = sensor(SCAN_TIME, null);
        drive(sensor, 0, 0, 60);
        truth.at(1, 0, 1, 0, 100, 0);
        sensor.moved();
        double[] there = new LidarSensor((LIDAR) sensor.getParameters(), 1).read(truth).ranges();
        assertArrayEquals("before a step", there, sensor.read(truth).ranges(), 0);
        truth.advance(sensor);
        assertArrayEquals("after a step", there, sensor.read(truth).ranges(), 1e-9);
    }

    @Test
    public void rollingAllocatesNothing() {
        LidarSensor sensor = sensor(SCAN_TIME, null);
        crossing(sensor, STEPS);
        drive(sensor, 0.5, TURN, STEPS);
        LidarScan scan = sensor.scan(truth, 270, 0.5);
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        double sum = 0;
        long least = Long.MAX_VALUE;
        for (int round = 0; round < 5; round++) {
            long before = threads.getThreadAllocatedBytes(Thread.currentThread().getId());
            for (int beam = 0; beam < 541; beam++) {
                sum += sensor.range(truth, scan, beam, truth.time() - 0.01);
            }
            least = Math.min(least, threads.getThreadAllocatedBytes(Thread.currentThread().getId()) - before);
        }
        assertTrue(sum > 541 * HALF / 2);
        assertTrue(least + " bytes", least < 541);
    }
}
