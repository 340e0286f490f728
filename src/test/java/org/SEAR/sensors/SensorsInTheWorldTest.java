// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Sensors on a driving Roomba in the whole simulation, headless. */
public class SensorsInTheWorldTest {
    private static final double GRAVITY = 9.81;
    /** Deceleration by the simulator's damping during a fall of a quarter second, m/s^2. */
    private static final double AIR = 0.04;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private void roomba(double height) {
        SEARrobot robot = new SEARrobot("roomba");
        robot.addComponent(new Dynamics("drive", 4, 60, 0.3, 0.4, 10000, 0.1, 0, height, 0, 0, 0, 0));
        robot.addComponent(new Cylinder("body", 0.1666875, 0.0762, 4));
        double[][] wheels = {{0, 0.16, 0}, {-0.16, 0, 1}, {0.16, 0, 1}, {0, -0.16, 0}};
        for (int i = 0; i < wheels.length; i++) {
            Wheel wheel = new Wheel("wheel" + i, 0.0381, 0.03, (int) wheels[i][2]);
            wheel.move(wheels[i][0], 0, wheels[i][1]);
            robot.addWheel(wheel);
        }
        robot.addComponent(new Accelerometer("accel", 2));
        Accelerometer proper = new Accelerometer("proper", 2);
        proper.setGravity(true);
        robot.addComponent(proper);
        robot.addComponent(new Gyroscope("gyro", 2));
        robot.addComponent(new Odometer("odometer"));
        robot.addComponent(new Compass("compass"));
    }

    private static void run(Simulation world, double seconds) {
        for (int i = 0; i < seconds / Simulation.STEP; i++) {
            world.step();
        }
    }

    private static VectorReading vector(Simulation world, String name) {
        return (VectorReading) world.read(name);
    }

    private static void assertVector(String what, double x, double y, double z, VectorReading reading,
        double tolerance) {
        assertEquals(what, x, reading.getX(), tolerance);
        assertEquals(what, y, reading.getY(), tolerance);
        assertEquals(what, z, reading.getZ(), tolerance);
    }

    @Test
    public void atRestAllIsQuiet() throws Exception {
        new Floor("floor", 20, 20);
        roomba(0.1);
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            run(world, 3);
            for (int i = 0; i < 120; i++) {
                world.step();
                assertVector("accelerometer", 0, 0, 0, vector(world, "accel"), 0.01);
                assertVector("with gravity", 0, GRAVITY, 0, vector(world, "proper"), 0.01);
                assertVector("gyroscope", 0, 0, 0, vector(world, "gyro"), 0.001);
                assertEquals(0, ((OdometerReading) world.read("odometer")).getMillimetres());
            }
        }
    }

    @Test
    public void aSpinIsMeasuredWithinOnePercent() throws Exception {
        new Floor("floor", 20, 20);
        roomba(0.1);
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            run(world, 1);
            world.getRobots().get(0).drive(0.2, 0);
            run(world, 2);
            double before = world.getRobots().get(0).getHardware().getTurned();
            run(world, 0.5);
            double truth = (world.getRobots().get(0).getHardware().getTurned() - before) / 0.5;
            assertTrue("it turns: " + truth, truth > 1);
            assertVector("left is +y", 0, truth, 0, vector(world, "gyro"), 0.01 * truth);
        }
    }

    @Test
    public void aTurnIsSpeedSquaredOverRadius() throws Exception {
        new Floor("floor", 20, 20);
        roomba(0.1);
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            run(world, 1);
            world.getRobots().get(0).drive(0.4, 0.5);
            run(world, 3);
            double speed = 0.4;
            double inwards = speed * speed / 0.5;
            assertVector("to the left, inwards", inwards, 0, 0, vector(world, "accel"), 0.02 * inwards);
        }
    }

    @Test
    public void aFallWeighsNothing() throws Exception {
        new Floor("floor", 20, 20);
        roomba(20);
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            run(world, 0.25);
            assertVector("accelerometer", 0, -GRAVITY, 0, vector(world, "accel"), AIR);
            assertVector("with gravity", 0, 0, 0, vector(world, "proper"), AIR);
        }
    }

    @Test
    public void onARampGravityLeans() throws Exception {
        Box ramp = new Box("ramp", 6, 6, 0.5, 0);
        ramp.rotate(-10, 0, 0);
        new Floor("floor", 20, 20).move(0, -5, 0);
        roomba(0.4);
        try (Simulation world = Simulation.load(project.folder(), 1)) {
            run(world, 4);
            double[] up = world.getRobots().get(0).getPose().rotateBack(0, GRAVITY, 0);
            assertTrue("uphill is ahead: " + up[2], up[2] > GRAVITY * Math.sin(Math.toRadians(9)));
            assertVector("it stands", 0, 0, 0, vector(world, "accel"), 0.02);
            assertVector("gravity in body axes", up[0], up[1], up[2], vector(world, "proper"), 0.05);
        }
    }
}
