// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.FixedJoint;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.ForceTorque;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Rope;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Slider;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Joints between parts of one robot: pendulum, linkage, suspension, caster, chain with servos. */
public class JointsInRobotsTest {
    private static final double GRAVITY = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** A robot that the world holds, of 10 kg besides its moving parts. */
    private static SEARrobot stand(String name, double moving) {
        SEARrobot robot = new SEARrobot(name);
        robot.addComponent(new Dynamics(name + "Dynamics", 10 + moving));
        robot.addComponent(new Box(name + "Base", 0.2, 0.2, 0.2, 10, 0, 0.1, -1, 0, 0, 0));
        new FixedJoint(name + "Bolt", null, robot, 0, 0, 0);
        return robot;
    }

    /** Adds a bar from one point to another in the plane z = 0. */
    private static Box bar(SEARrobot robot, String name, double mass, double x1, double y1, double x2, double y2) {
        Box bar = new Box(name, Math.hypot(x2 - x1, y2 - y1), 0.02, 0.02, mass, (x1 + x2) / 2, (y1 + y2) / 2, 0, 0, 0,
            Math.toDegrees(Math.atan2(y2 - y1, x2 - x1)));
        robot.addComponent(bar);
        return bar;
    }

    /** Adds a hinge about z. */
    private static Hinge hinge(SEARrobot robot, String name, Box first, Box second, double x, double y) {
        Hinge hinge = new Hinge(name, first, second, x, y, 0, 90, 0, 0);
        robot.addComponent(hinge);
        return hinge;
    }

    private static double[] joint(Simulation world, String name) {
        return world.getJoints().reading(name).numbers();
    }

    @Test
    public void aPendulumOnARobotHasItsPeriod() throws Exception {
        SEARrobot robot = stand("stand", 1);
        double angle = Math.toRadians(5);
        Box rod = bar(robot, "rod", 1, 0, 2, Math.sin(angle), 2 - Math.cos(angle));
        hinge(robot, "pivot", null, rod, 0, 2);
        try (Simulation world = Worlds.start(project)) {
            List<Double> crossings = new ArrayList<>();
            double last = world.getPose("rod").x;
            while (crossings.size() < 6) {
                world.step();
                double x = world.getPose("rod").x;
                if (last < 0 && x >= 0) {
                    crossings.add(world.getTime() - Simulation.STEP * x / (x - last));
                }
                last = x;
            }
            assertEquals(1.63881, (crossings.get(5) - crossings.get(0)) / 5, 1e-3);
            assertEquals(0, joint(world, "stand/pivot")[0] - joint(world, "pivot")[0], 0);
        }
    }

    @Test
    public void aLinkageThatAMotorDrivesStaysClosed() throws Exception {
        SEARrobot robot = stand("stand", 0.9);
        Box crank = bar(robot, "crank", 0.1, 0, 1, 0, 1.1);
        Box coupler = bar(robot, "coupler", 0.4, 0, 1.1, 0.4, 1.3);
        Box rocker = bar(robot, "rocker", 0.4, 0.4, 1.3, 0.4, 1);
        hinge(robot, "drive", null, crank, 0, 1).setMotor(20, 720);
        hinge(robot, "pin", crank, coupler, 0, 1.1);
        hinge(robot, "ground", null, rocker, 0.4, 1);
        hinge(robot, "loop", rocker, coupler, 0.4, 1.3);
        try (Simulation world = Worlds.start(project)) {
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_SPEED, "drive", 360));
            double half = Math.hypot(0.4, 0.2) / 2;
            double least = 0;
            double most = 0;
            for (int i = 0; i < 180; i++) {
                world.step();
                double[] one = world.getPose("coupler").transform(half, 0, 0);
                double[] other = world.getPose("rocker").transform(-0.15, 0, 0);
                assertArrayEquals(one, other, 1e-4);
                least = Math.min(least, joint(world, "ground")[0]);
                most = Math.max(most, joint(world, "ground")[0]);
            }
            assertEquals(3 * 360, joint(world, "drive")[0], 20);
            assertTrue("the rocker swings from " + least + " to " + most, most - least > 30 && most - least < 60);
        }
    }

    /** The load of 1 kg at twice the arm of the spring pulls it with twice its weight. */
    @Test
    public void aSuspensionArmHangsOnItsSpring() throws Exception {
        SEARrobot robot = stand("stand", 1.001);
        Box arm = bar(robot, "arm", 0.001, 0, 1, 0.4, 1);
        Box load = new Box("load", 0.02, 0.02, 0.02, 1, 0.4, 1, 0, 0, 0, 0);
        robot.addComponent(load);
        Hinge hinge = hinge(robot, "arm joint", null, arm, 0, 1);
        hinge.mount(load);
        hinge.setDamping(1);
        Rope spring = new Rope("spring", null, arm, 0.2, 1.5, 0, 0.2, 1, 0);
        spring.setSpring(200 * GRAVITY, 0.49);
        robot.addComponent(spring);
        robot.addComponent(new ForceTorque("scale", "arm joint"));
        try (Simulation world = Worlds.start(project)) {
            Worlds.run(world, 5);
            assertEquals(0, joint(world, "arm joint")[0], 0.02);
            assertEquals(0.5, joint(world, "spring")[0], 2e-5);
            double[] force = world.read("scale").numbers();
            assertEquals("the joint pulls the arm down", -GRAVITY, force[1], 0.05);
            assertFalse(world.snapshot().warnings.toString().contains("does not move"));
        }
    }

    @Test
    public void aCasterSwivelsBehindItsRobot() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot robot = new SEARrobot("cart");
        robot.addComponent(new Dynamics("dynamics", 2.2));
        robot.addComponent(new Box("body", 0.2, 0.3, 0.04, 2, 0, 0.06, -0.02, 0, 0, 0));
        robot.addWheel(new Wheel("left", 0.05, 0.02, 1, 0.12, 0, 0.1));
        robot.addWheel(new Wheel("right", 0.05, 0.02, 1, -0.12, 0, 0.1));
        Box fork = new Box("fork", 0.01, 0.01, 0.05, 0.1, 0.03, -0.01, -0.15, 0, 0, 0);
        robot.addComponent(fork);
        robot.addComponent(new Hinge("swivel", null, fork, 0, 0.02, -0.15));
        Cylinder roller = new Cylinder("roller", 0.025, 0.015, 0.1);
        roller.move(0.03, -0.025, -0.15);
        roller.rotate(90, 0, 0);
        robot.addComponent(roller);
        robot.addComponent(new Hinge("axle", fork, roller, 0.03, -0.025, -0.15, 90, 0, 0));
        robot.move(0, 0.05, 0);
        try (Simulation world = Worlds.start(project)) {
            Worlds.run(world, 0.5);
            world.getRobots().get(0).getHardware().setWheelSpeeds(0.2, 0.2);
            Worlds.run(world, 4);
            assertEquals("from the left side to the back", 90, Math.abs(joint(world, "swivel")[0]), 3);
            assertEquals("it rolls", Math.toDegrees(0.2 / 0.025), Math.abs(joint(world, "axle")[1]), 15);
            assertEquals("level", 1, world.getPose("cart").rotate(0, 1, 0)[1], 1e-3);
            assertEquals(0.2 * 4, world.getPose("cart").z, 0.1);
        }
    }

    /** Servo, slider and hinge in one chain: poses of the parts follow all of them. */
    @Test
    public void jointsAndServosMakeChains() throws Exception {
        SEARrobot robot = stand("stand", 0.6);
        Servo pan = new Servo("pan", 0, 1, 0);
        pan.setStallTorque(10);
        robot.addComponent(pan);
        Box turret = new Box("turret", 0.1, 0.1, 0.1, 0.2, 0, 1, 0, 0, 0, 0);
        Box stick = new Box("stick", 0.02, 0.3, 0.02, 0.2, 0, 1, 0.2, 0, 0, 0);
        Box hand = new Box("hand", 0.02, 0.02, 0.02, 0.2, 0, 1, 0.35, 0, 0, 0);
        pan.mount(turret);
        robot.addComponent(turret);
        robot.addComponent(stick);
        robot.addComponent(hand);
        Slider reach = new Slider("reach", turret, stick, 0, 1, 0.1, 90, 0, 0);
        reach.setLimits(0, 0.5);
        reach.setMotor(50, 1);
        robot.addComponent(reach);
        Hinge wrist = new Hinge("wrist", stick, hand, 0, 1, 0.35);
        wrist.setMotor(5, 360);
        Distance eye = new Distance("eye");
        eye.move(0, 1, 0.36);
        wrist.mount(eye);
        robot.addComponent(eye);
        robot.addComponent(wrist);
        try (Simulation world = Worlds.start(project)) {
            world.getServo("pan").setAngle(90);
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, "reach", 0.3));
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, "wrist", 90));
            Worlds.run(world, 5);
            Pose at = world.getPose("hand");
            assertArrayEquals(new double[] {0.65, 1, 0}, new double[] {at.x, at.y, at.z}, 2e-3);
            assertArrayEquals("back", new double[] {0, 0, -1}, at.rotate(0, 0, 1), 0.02);
            Pose seen = world.getPose("eye");
            assertArrayEquals(new double[] {0.65, 1, -0.01}, new double[] {seen.x, seen.y, seen.z}, 2e-3);
            assertEquals(Set.of("standBolt", "reach", "wrist"), world.getJoints().getNames());
        }
    }

    @Test
    public void partsOfTwoRobotsMayHaveTheSameNames() throws Exception {
        for (int i = 0; i < 2; i++) {
            SEARrobot robot = stand("stand" + i, 1);
            Box door = new Box("door", 0.8, 0.02, 1, 1, 0.4, 1, 0, 0, 0, 0);
            robot.addComponent(door);
            Hinge hinge = new Hinge("hinge", null, door, 0, 1, 0);
            hinge.setMotor(10, 90);
            robot.addComponent(hinge);
            robot.addComponent(new ForceTorque("scale", "hinge"));
            robot.move(0, 0, 5 * i);
        }
        try (Simulation world = Worlds.start(project)) {
            world.order(new ActuatorOrder(ActuatorOrder.Kind.JOINT_POSITION, "stand1/hinge", 45));
            Worlds.run(world, 2);
            assertEquals(0, joint(world, "stand0/hinge")[0], 0.1);
            assertEquals(45, joint(world, "stand1/hinge")[0], 0.1);
            assertEquals(GRAVITY, world.read("stand1/scale").numbers()[1], 0.02);
            String said = assertThrows(IllegalArgumentException.class, () -> joint(world, "hinge")).getMessage();
            assertEquals("\"hinge\" is on stand0 and stand1: use \"stand0/hinge\" or \"stand1/hinge\"", said);
        }
    }

    @Test
    public void aBrokenJointLetsItsPartFall() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = stand("stand", 1);
        Box bumper = new Box("bumper", 0.1, 0.1, 0.1, 1, 0, 1, 0, 0, 0, 0);
        robot.addComponent(bumper);
        FixedJoint weld = new FixedJoint("weld", null, bumper, 0, 1, 0);
        weld.setBreakingForce(9);
        robot.addComponent(weld);
        try (Simulation world = Worlds.start(project)) {
            Worlds.run(world, 3);
            assertEquals(0.05, world.getPose("bumper").y, 1e-3);
            assertTrue(world.snapshot().warnings.toString().contains("FixedJoint \"weld\" broke"));
            assertTrue(world.getJoints().isBroken("weld"));
        }
    }

    private String problem(Joint joint, SEARrobot robot) {
        robot.addComponent(joint);
        String said = assertThrows(Exception.class, () -> Project.read(project.folder())).getMessage();
        return said.substring(said.indexOf("xml:") + 4);
    }

    @Test
    public void wrongJointsAreReported() throws Exception {
        SEARrobot robot = stand("stand", 3);
        Box a = bar(robot, "a", 1, 0, 1, 1, 1);
        Box b = bar(robot, "b", 1, 1, 1, 2, 1);
        Compass compass = new Compass("compass");
        robot.addComponent(compass);
        hinge(robot, "good", null, a, 0, 1);
        Hinge second = hinge(robot, "second", a, b, 1, 1);
        assertEquals(2, Project.read(project.folder()).getAllJoints().size() - 1);
        Hinge wrong = new Hinge("wrong", null, compass);
        String said = problem(wrong, robot);
        assertTrue(said, said.contains("second is \"compass\", legal: the name of a shape of the joint's robot stand: "
            + "standBase, a, b"));
        wrong.set(Map.of("second", "a", "first", "a2"));
        said = assertThrows(Exception.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("first is \"a2\", legal: the name of a shape"));
        wrong.set(Map.of("first", "a", "second", "b", "collide", true));
        said = assertThrows(Exception.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("collide is \"true\", legal: false within a robot, whose parts pass through "
            + "each other"));
        wrong.set(Map.of("first", "a", "second", "b", "collide", false));
        second.mount(compass);
        Project.read(project.folder());
        wrong.mount(robotPart(robot, "c"));
        Project.read(project.folder());
        wrong.set(Map.of("first", "b", "second", "c"));
        said = assertThrows(Exception.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("part is \"c\", legal: a part that no other servo or joint moves"));
        said = assertThrows(IllegalArgumentException.class, () -> second.mount(compass)).getMessage();
        assertEquals("Hinge \"second\": Compass \"compass\" is mounted on Hinge \"second\", legal: a part that no "
            + "servo or joint moves yet", said);
        wrong.set(Map.of("part", List.of()));
        assertFalse(Project.read(project.folder()).getAllJoints().isEmpty());
        second.set(Map.of("first", "c"));
        said = assertThrows(Exception.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(said, said.contains("a shape that the second one, b, does not move"));
    }

    private static Box robotPart(SEARrobot robot, String name) {
        Box part = new Box(name, 0.1, 0.1, 0.1, 1);
        robot.addComponent(part);
        return part;
    }
}
