// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.RobotHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.Robot;
import org.SEAR.sensors.DistanceReading;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Worlds with unusual robots and objects. */
public class WorldTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;
    private static final double FRONT = 0.1666875;

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Before
    public void floor() {
        new Floor("floor", 50, 50);
    }

    private static Box box(String name, double x, double y, double z) {
        Box box = new Box(name, 1, 1, 1, 0);
        box.move(x, y, z);
        return box;
    }

    @Test
    public void aRobotWithoutWheelsLiesWhereItFalls() throws Exception {
        SEARrobot sled = new SEARrobot("sled");
        sled.addComponent(new Dynamics("dynamics", 5, 1, 0.4, 2, 0, 0, 0));
        sled.addComponent(new Box("body", 0.4, 0.4, 0.2, 0));
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).drive(1, STRAIGHT);
        Worlds.run(simulation, 3);
        Pose pose = simulation.getPose("sled");
        assertEquals(0.1, pose.y, 0.002);
        assertEquals(1, pose.x, 0.002);
        assertEquals(2, pose.z, 0.002);
        assertEquals(0, simulation.getRobots().get(0).getHardware().getTrack(), 0);
    }

    @Test
    public void lookReturnsTheDistanceFromTheBody() throws Exception {
        box("wall", 0, 0.5, 3);
        Worlds.roomba("roomba", 0, 0, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 2);
        RobotHardware hardware = simulation.getRobots().get(0).getHardware();
        assertEquals(2.5, hardware.look(0, 0, 0, 0, 0, 1, 10), 0.002);
        assertEquals("farther than asked", Double.POSITIVE_INFINITY, hardware.look(0, 0, 0, 0, 0, 1, 2.4), 0);
        assertEquals("the floor", simulation.getPose("roomba").y, hardware.look(0, 0, 0, 0, -1, 0, 1), 0.001);
        assertEquals("sky", Double.POSITIVE_INFINITY, hardware.look(0, 0, 0, 0, 1, 0, 100), 0);
    }

    @Test
    public void aVirtualWallIsFeltInItsFanAndItsHalo() throws Exception {
        Box wall = new Box("virtualWall1", 0.1, 0.1, 0.1, 0);
        wall.move(0, 0.05, 5);
        Worlds.roomba("inFan", 0.1, 6.5, 0);
        Worlds.roomba("aside", 1.2, 6.5, 0);
        Worlds.roomba("beyond", 0, 7.7, 0);
        Worlds.roomba("behind", 0, 4.2, 0);
        Worlds.roomba("halo", 0.3, 4.9, 0);
        Simulation simulation = Worlds.start(project);
        for (Robot robot : simulation.getRobots()) {
            String name = robot.getObject().getName();
            boolean expected = name.equals("inFan") || name.equals("halo");
            assertEquals(name, expected, robot.getHardware().isInVirtualWall());
        }
    }

    @Test
    public void solidObjectsStopAVirtualWall() throws Exception {
        new Box("virtualWall north", 0.1, 0.1, 0.1, 0).move(0, 0.05, 5);
        Box wall = new Box("wall", 2, 0.1, 0.5, 0);
        wall.setVisibleToSensors(false);
        wall.move(0, 0.25, 5.8);
        Worlds.roomba("shaded", 0.1, 6.5, 0);
        Worlds.roomba("halo", 0.3, 4.9, 0);
        for (Robot robot : Worlds.start(project).getRobots()) {
            assertEquals(robot.getObject().getName().equals("halo"), robot.getHardware().isInVirtualWall());
        }
    }

    @Test
    public void aRobotOnItsSideIsReported() throws Exception {
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        for (SearObject part : robot.getComponents()) {
            if (part instanceof Dynamics) {
                part.rotate(0, 0, 89);
                part.move(0, 0.3, 0);
            }
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        assertTrue(simulation.snapshot().warnings.toString(), simulation.snapshot().warnings.contains(
            "robot roomba has overturned"));
    }

    @Test
    public void movingARobotMovesItsStartPose() throws Exception {
        SEARrobot robot = Worlds.roomba("roomba", 0, 1, 0);
        robot.move(3, 0, 2);
        robot.rotate(0, 90, 0);
        Pose pose = Worlds.start(project).getPose("roomba");
        assertEquals("the turn takes the Dynamics' z = 1 to the x axis", 4, pose.x, 1e-9);
        assertEquals(2, pose.z, 1e-9);
        assertEquals("heads along x", 1, pose.rotate(0, 0, 1)[0], 1e-9);
    }

    @Test
    public void robotsThatStartOverlappingAreReported() throws Exception {
        new Floor("floor", 10, 10);
        Worlds.roomba("first", 0, 0, 0);
        Worlds.roomba("second", 0.1, 0, 0);
        Worlds.roomba("apart", 0.5, 0, 0);
        Box crate = new Box("crate", 0.2, 0.2, 0.2, 1);
        crate.move(0.5, 0.1, 0);
        assertEquals("[first and second start 0.076 m inside each other and will be pushed apart; move one of them,"
            + " crate and apart start 0.138 m inside each other and will be pushed apart; move one of them]",
            Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void startingDepthsOfOverlapsAreReported() throws Exception {
        new Floor("floor", 10, 10);
        new Box("left", 0.4, 0.4, 0.4, 1).move(0, 0.2, 0);
        new Box("right", 0.4, 0.4, 0.4, 1).move(0.28, 0.2, 0);
        new Box("above", 0.4, 0.4, 0.4, 1).move(0, 0.5995, 0);
        assertEquals("what stands on another thing by half a millimetre is not told",
            "[left and right start 0.120 m inside each other and will be pushed apart; move one of them]",
            Worlds.start(project).snapshot().warnings.toString());
    }

    @Test
    public void loweringAtTheStartIsNoWheelDrop() throws Exception {
        Worlds.roomba("roomba", 0, 0, 0);
        Worlds.roomba("skydiver", 3, 0, 0).move(0, 20, 0);
        Simulation simulation = Worlds.start(project);
        RobotHardware hardware = simulation.getRobots().get(0).getHardware();
        for (int i = 0; i < 90; i++) {
            simulation.step();
            assertFalse("step " + i, hardware.isLeftWheelDropped() || hardware.isRightWheelDropped()
                || hardware.isCasterDropped());
        }
        assertTrue("after a second it counts", simulation.getRobots().get(1).getHardware().isLeftWheelDropped());
    }

    @Test
    public void twoRobotsSeeEachOtherAndNotThemselves() throws Exception {
        Worlds.roomba("first", 0, 0, 0).addComponent(new Distance("firstEye", "laser", 0, 0, 0, 0, 0, 0));
        Worlds.roomba("second", 0, 2, 180).addComponent(new Distance("secondEye", "laser", 0, 0, 0, 0, 0, 0));
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        assertEquals(2 - FRONT, ((DistanceReading) simulation.read("firstEye")).getDistance(), 0.002);
        assertEquals(2 - FRONT, ((DistanceReading) simulation.read("secondEye")).getDistance(), 0.002);
        simulation.getRobots().get(1).drive(0.2, STRAIGHT);
        Worlds.run(simulation, 3);
        double between = simulation.getPose("second").z - simulation.getPose("first").z;
        assertEquals(between - FRONT, ((DistanceReading) simulation.read("firstEye")).getDistance(), 0.005);
    }

    @Test
    public void objectsInvisibleToBeamsStillBlockARobot() throws Exception {
        box("glass", 0, 0.5, 2).setVisibleToSensors(false);
        Worlds.roomba("roomba", 0, 0, 0).addComponent(new Distance("eye", "laser", 0, 0, 0, 0, 0, 0));
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).drive(0.3, STRAIGHT);
        Worlds.run(simulation, 8);
        assertFalse(((DistanceReading) simulation.read("eye")).isReturn());
        assertEquals(1.5 - FRONT - 0.03, simulation.getPose("roomba").z, 0.05);
        assertTrue(simulation.getRobots().get(0).getHardware().isBumpedLeft());
    }

    @Test
    public void aRobotWithoutDynamicsIsRejectedWithTheRemedy() {
        SEARrobot robot = new SEARrobot("bare");
        robot.addComponent(new Box("body", 0.4, 0.4, 0.2, 0));
        ProjectException refused = assertThrows(ProjectException.class, () -> Worlds.start(project));
        assertTrue(refused.getMessage(), refused.getMessage().contains("bare") && refused.getMessage()
            .contains("Dynamics"));
    }
}
