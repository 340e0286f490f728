// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Contacts of robots and objects. */
public class TouchingTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void aLightBoxIsPushed() throws Exception {
        new Floor("floor", 50, 50);
        box("box", 0.3, 0.3, 0.3, 2, 0, 0.15, 0.5);
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 2);
        assertEquals(0.5, simulation.getPose("box").z, 0.002);
        simulation.getRobots().get(0).drive(0.2, STRAIGHT);
        Worlds.run(simulation, 5);
        assertTrue("box at " + simulation.getPose("box"), simulation.getPose("box").z > 0.9);
        assertEquals(1, simulation.getPose("roomba").z, 0.05);
    }

    @Test
    public void aWallStopsItAndRaisesTheBumper() throws Exception {
        for (double speed : new double[] {0.1, 0.5}) {
            new Floor("floor", 50, 50);
            box("wall", 4, 0.05, 0.5, 0, 0, 0.25, 1);
            Worlds.roomba("roomba", 0, 0, 0);
            Simulation simulation = Worlds.start(project);
            Robot robot = simulation.getRobots().get(0);
            Worlds.run(simulation, 1);
            assertFalse(robot.getHardware().isBumpedLeft() || robot.getHardware().isBumpedRight());
            robot.drive(speed, STRAIGHT);
            Worlds.run(simulation, 15);
            assertEquals(1 - 0.025 - 0.1666875, robot.getPose().z, 0.03);
            assertEquals("climbed", 0.097, robot.getPose().y, 0.02);
            assertTrue(robot.getHardware().isBumpedLeft() && robot.getHardware().isBumpedRight());
            double path = robot.getHardware().getPath();
            Worlds.run(simulation, 10);
            assertEquals("the odometer counts at the wall", path, robot.getHardware().getPath(), 0.001);
            assertEquals("nose up", 0, Math.toDegrees(Math.asin(robot.getPose().rotate(0, 0, 1)[1])), 1);
            robot.drive(-speed, STRAIGHT);
            Worlds.run(simulation, 1);
            assertFalse(robot.getHardware().isBumpedLeft() || robot.getHardware().isBumpedRight());
        }
    }

    @Test
    public void aStepAboveTheAxleIsNotClimbedAndALowOneIs() throws Exception {
        for (double height : new double[] {0.08, 0.05, 0.01}) {
            new Floor("floor", 50, 50);
            box("step", 4, 0.5, height, 0, 0, height / 2, 1);
            Worlds.roomba("roomba", 0, 0, 0);
            Simulation simulation = Worlds.start(project);
            Robot robot = simulation.getRobots().get(0);
            robot.drive(0.15, STRAIGHT);
            Worlds.run(simulation, 14);
            assertEquals("step of " + height, height < 0.0381, robot.getPose().z > 1.3);
            assertEquals(0.097, robot.getPose().y, 0.02);
        }
    }

    @Test
    public void aBoxLowerThanTheBodyIsPushedByTheWheels() throws Exception {
        new Floor("floor", 50, 50);
        box("brick", 0.3, 0.1, 0.05, 1, 0, 0.025, 0.5);
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).drive(0.2, STRAIGHT);
        Worlds.run(simulation, 5);
        assertEquals(0.98, simulation.getPose("roomba").z, 0.03);
        assertEquals(0.98 + 0.16 + 0.0305 + 0.05, simulation.getPose("brick").z, 0.05);
    }

    @Test
    public void theBumperKnowsTheSide() throws Exception {
        new Floor("floor", 50, 50);
        box("post", 0.1, 0.1, 0.5, 0, 0.15, 0.25, 0.5);
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        Robot robot = simulation.getRobots().get(0);
        robot.drive(0.2, STRAIGHT);
        Worlds.run(simulation, 2);
        for (int i = 0; i < 120 && !robot.getHardware().isBumpedLeft(); i++) {
            simulation.step();
        }
        assertTrue(robot.getHardware().isBumpedLeft());
        assertFalse(robot.getHardware().isBumpedRight());
    }

    @Test
    public void aRampIsClimbedAndHeldAndAnEdgeIsFallenOff() throws Exception {
        new Floor("floor", 4, 4);
        Box ramp = box("ramp", 2, 2, 0.1, 0, 0, 0.205, 1.5);
        ramp.rotate(-15, 0, 0);
        Worlds.roomba("roomba", 0, -0.5, 0);
        Simulation simulation = Worlds.start(project);
        Robot robot = simulation.getRobots().get(0);
        robot.drive(0.2, STRAIGHT);
        Worlds.run(simulation, 8);
        robot.drive(0, STRAIGHT);
        Worlds.run(simulation, 3);
        Pose held = robot.getPose();
        assertTrue("height " + held.y, held.y > 0.2);
        Worlds.run(simulation, 60);
        assertEquals("slid back", held.z, robot.getPose().z, 0.001);
        robot.drive(0.3, STRAIGHT);
        for (int i = 0; i < 600 && !robot.getHardware().isLeftWheelDropped(); i++) {
            simulation.step();
        }
        assertTrue(robot.getHardware().isLeftWheelDropped() && robot.getHardware().isCasterDropped());
        Worlds.run(simulation, 2);
        assertTrue("height " + robot.getPose().y, robot.getPose().y < 0);
    }

    @Test
    public void objectsThatStartInsideTheFloorAreLiftedOutWithAWarning() throws Exception {
        new Floor("floor", 50, 50);
        Cylinder can = new Cylinder("trash Can", 0.25, 0.75, 10);
        can.move(-3, 0, -3.5);
        can.rotate(0, 30, 30);
        Cone cone = new Cone("Traffic Cone", 0.25, 2, 10);
        cone.move(-2, 0, 0);
        cone.rotate(0, 0, 45);
        box("standing", 0.2, 0.2, 0.2, 1, 3, 0.1, 3);
        Simulation simulation = Worlds.start(project);
        assertEquals(simulation.snapshot().warnings.toString(), 2, simulation.snapshot().warnings.size());
        Worlds.run(simulation, 15);
        assertEquals(0.25, simulation.getPose("trash Can").y, 0.15);
        assertTrue(simulation.getPose("Traffic Cone").y > 0.05);
        assertEquals(0.1, simulation.getPose("standing").y, 0.002);
        assertEquals("something never sleeps", 0, Worlds.physics(simulation).getBusyBodies());
    }

    /** Returns the robot's initial heading: {x, z} of its forward axis. */
    private double[] aheadOf(double[] robotDegrees, double[] dynamicsDegrees) throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Worlds.roomba("roomba", 1, 2, 0);
        robot.rotate(robotDegrees[0], robotDegrees[1], robotDegrees[2]);
        robot.getComponents().stream().filter(part -> part instanceof Dynamics)
            .forEach(part -> part.rotate(dynamicsDegrees[0], dynamicsDegrees[1], dynamicsDegrees[2]));
        Simulation simulation = Worlds.start(project);
        assertTrue(simulation.snapshot().warnings.toString(), simulation.snapshot().warnings.toString()
            .contains("upside down"));
        Worlds.run(simulation, 1);
        Pose pose = simulation.getPose("roomba");
        assertEquals(1, pose.rotate(0, 1, 0)[1], 0.01);
        double[] ahead = pose.rotate(0, 0, 1);
        return new double[] {ahead[0], ahead[2]};
    }

    @Test
    public void aRobotUpsideDownIsSetUprightAndTurned() throws Exception {
        assertArrayEquals(new double[] {0, -1}, aheadOf(new double[3], new double[] {0, 0, 180}), 0.01);
        assertArrayEquals("about either axis", new double[] {0, -1},
            aheadOf(new double[3], new double[] {180, 0, 0}), 0.01);
        assertArrayEquals("its heading is kept", new double[] {-1, 0},
            aheadOf(new double[3], new double[] {0, 90, 180}), 0.01);
        assertArrayEquals("the robot itself", new double[] {0, -1},
            aheadOf(new double[] {0, 0, 180}, new double[3]), 0.01);
    }

    @Test
    public void aSmallObjectPutsAStackToSleepAndIsWokenByARobot() throws Exception {
        new Floor("floor", 50, 50);
        for (int i = 0; i < 2; i++) {
            box("box" + i, 0.3, 0.3, 0.2, 1, 0, 0.1 + 0.2 * i, 1);
        }
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 10);
        assertEquals(0, Worlds.physics(simulation).getBusyBodies());
        assertEquals(0.3, simulation.getPose("box1").y, 0.01);
        simulation.getRobots().get(0).drive(0.3, STRAIGHT);
        Worlds.run(simulation, 6);
        assertTrue(simulation.getPose("box0").z > 1.2);
        assertTrue("nothing stays in the air", simulation.getPose("box1").y < 0.35);
    }

    private static Box box(String name, double length, double width, double height, double mass, double x,
        double y, double z) {
        Box box = new Box(name, length, width, height, mass);
        box.move(x, y, z);
        return box;
    }
}
