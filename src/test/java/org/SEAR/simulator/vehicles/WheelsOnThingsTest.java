// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.function.Function;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/**
 * Forces of wheels act on the supporting body in the same step: neither is thrown, however light it is, and momentum is
 * conserved.
 */
public class WheelsOnThingsTest {
    private static final double THICK = 0.02;
    private static final double STILL = 1e-4;
    private static final int STEPS = 600;
    private static final List<Function<String, SEARrobot>> READY =
        List.of(Robots::rover, Robots::car, Robots::fourWheeled, Robots::create);

    @Rule
    public final ProjectRule project = new ProjectRule();

    @Test
    public void aRobotStandsOnABoardOfAnyMass() throws Exception {
        double[] masses = {0.01, 0.1, 1, 100};
        new Floor("floor", 20, 20);
        for (int i = 0; i < masses.length; i++) {
            new Box("board" + i, 0.5, 0.5, THICK, masses[i]).move(2 * i, THICK / 2, 0);
            Robots.rover("rover" + i).move(2 * i, THICK, 0);
        }
        Robots.rover("onFloor").move(-2, 0, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 5);
        double height = Worlds.body(simulation, "onFloor").getPose().y + THICK;
        for (int i = 0; i < masses.length; i++) {
            assertStands(masses[i] + " kg: robot", Worlds.body(simulation, "rover" + i).getPose(), 2 * i, height);
            assertStands(masses[i] + " kg: board", Worlds.body(simulation, "board" + i).getPose(), 2 * i, THICK / 2);
        }
    }

    private static void assertStands(String what, Pose pose, double x, double y) {
        assertEquals(what, x, pose.x, STILL);
        assertEquals(what, y, pose.y, STILL);
        assertEquals(what, 0, pose.z, STILL);
    }

    /** On ice the board moves back as the robot moves forward. */
    @Test
    public void aBoardOnIceGoesBackUnderTheWheels() throws Exception {
        Floor ice = new Floor("floor", 40, 40);
        ice.setFriction(0);
        new Box("board", 1, 6, THICK, 4).move(0, THICK / 2, 0);
        Robots.rover("rover").move(0, THICK, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        simulation.getRobots().get(0).drive(0.4, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 2);
        double robot = momentum(Worlds.body(simulation, "rover"));
        double board = momentum(Worlds.body(simulation, "board"));
        assertTrue("the robot drives: " + robot + " Ns", robot > 0.2);
        assertEquals("what one has the other has backwards", -robot, board, 0.01 * robot);
    }

    private static double momentum(Body body) {
        double[] v = new double[6];
        body.velocities(v);
        return body.mass * v[2];
    }

    /** Robots created without a place start at the origin together. */
    @Test
    public void twoRobotsAtOneSpotComeApartSlowly() throws Exception {
        new Floor("floor", 60, 60);
        int pairs = 0;
        for (Function<String, SEARrobot> one : READY) {
            for (Function<String, SEARrobot> other : READY) {
                one.apply("a" + pairs).move(3 * pairs - 24, 0, 0);
                other.apply("b" + pairs).move(3 * pairs - 24, 0, 0);
                pairs++;
            }
        }
        Simulation simulation = Worlds.start(project);
        double[] v = new double[6];
        for (int step = 0; step < STEPS; step++) {
            Pose[] before = new Pose[2 * pairs];
            for (int i = 0; i < 2 * pairs; i++) {
                before[i] = Worlds.body(simulation, (i % 2 == 0 ? "a" : "b") + i / 2).getPose();
            }
            simulation.step();
            for (int i = 0; i < 2 * pairs; i++) {
                String name = (i % 2 == 0 ? "a" : "b") + i / 2;
                Body robot = Worlds.body(simulation, name);
                robot.velocities(v);
                assertEquals(name + " leaps", 0,
                    Math.hypot(robot.getPose().x - before[i].x, robot.getPose().z - before[i].z), 0.2);
                assertTrue(name + " is thrown: " + Math.hypot(Math.hypot(v[0], v[1]), v[2]) + " m/s",
                    Math.hypot(Math.hypot(v[0], v[1]), v[2]) < 5);
                assertTrue(name + " has sunk to " + lowest(robot) + " m in step " + step,
                    lowest(robot) > (step < STEPS - 1 ? -0.045 : -1e-3));
            }
        }
    }

    /** Wheels that point up must not carry a robot on its back from below the floor. */
    @Test
    public void aRobotOnItsBackLiesStill() throws Exception {
        new Floor("floor", 160, 60);
        int count = 3 * READY.size();
        for (int i = 0; i < count; i++) {
            double high = 0.3 + 0.06 * i;
            new Box("edge" + i, 0.4, 0.1, high, 0).move(4 * i - 24, high / 2, 0);
            READY.get(i % READY.size()).apply("robot" + i).move(4 * i - 24, high + 0.05, 0.07 + 0.003 * i);
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 10);
        Pose[] before = poses(simulation, count);
        Worlds.run(simulation, 5);
        int turned = 0;
        for (int i = 0; i < count; i++) {
            Body robot = Worlds.body(simulation, "robot" + i);
            Pose now = robot.getPose();
            assertEquals("robot" + i, 0, Math.hypot(Math.hypot(now.x - before[i].x, now.y - before[i].y),
                now.z - before[i].z), STILL);
            assertTrue("robot" + i + " has sunk to " + lowest(robot) + " m", lowest(robot) > -5e-4);
            turned += now.rotate(0, 1, 0)[1] < -0.99 ? 1 : 0;
        }
        assertTrue("only " + turned + " of " + count + " lie on their backs", turned >= 6);
    }

    /**
     * A caster on the ground must not alternate between contact as a wheel and contact as a wall, which makes the rover
     * hop.
     */
    @Test
    public void aRoverThatStandsOnItsTailStands() throws Exception {
        new Floor("floor", 40, 10);
        int count = 8;
        for (int i = 0; i < count; i++) {
            SEARrobot rover = Robots.rover("robot" + i);
            rover.move(3 * i - 12, 0.2, 0);
            rover.rotate(-66 - 2 * i, 0, 0);
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 10);
        Pose[] before = poses(simulation, count);
        Worlds.run(simulation, 5);
        int upright = 0;
        for (int i = 0; i < count; i++) {
            Pose now = Worlds.body(simulation, "robot" + i).getPose();
            assertEquals("robot" + i, 0, Math.hypot(Math.hypot(now.x - before[i].x, now.y - before[i].y),
                now.z - before[i].z), STILL);
            upright += now.rotate(0, 0, 1)[1] > 0.9 ? 1 : 0;
        }
        assertTrue("only " + upright + " of " + count + " stand on their tails", upright >= 3);
    }

    /** A turntable drags along a rover beside its axis; the caster does not swing, because it does not roll. */
    @Test
    public void aPlateThatAServoTurnsTakesWheelsAlong() throws Exception {
        new Floor("floor", 20, 20);
        Servo turn = plate("turn", 0, 0, 0);
        turn.setSpeed(30);
        turn.setStallTorque(100);
        Robots.rover("rover").move(0.2, 0.27, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        simulation.getServo("turn").setAngle(90);
        Worlds.run(simulation, 2.9);
        double angle = Math.toRadians(simulation.getServo("turn").getAngle());
        Pose pose = Worlds.body(simulation, "rover").getPose();
        assertEquals(87, Math.toDegrees(angle), 0.1);
        assertEquals(0.2 * Math.cos(angle), pose.x, STILL);
        assertEquals(-0.2 * Math.sin(angle), pose.z, STILL);
        assertEquals(87, Math.toDegrees(Math.atan2(pose.rotate(0, 0, 1)[0], pose.rotate(0, 0, 1)[2])), 0.1);
        assertEquals("upright", 1, pose.rotate(0, 1, 0)[1], 1e-6);
    }

    /**
     * A rover of 2 kg half a metre from the axis is a moment of 9.8 N m. A servo with twice that torque lifts it at
     * half speed; one with half of it sinks at full speed.
     */
    @Test
    public void aServoFeelsTheWheelsThatItLifts() throws Exception {
        double moment = 2 * 9.81 * 0.5;
        new Floor("floor", 20, 20);
        Servo strong = plate("strong", 0, -0.5, -90);
        strong.setSpeed(2);
        strong.setStallTorque(2 * moment);
        Servo weak = plate("weak", 3, -0.5, -90);
        weak.setSpeed(2);
        weak.setStallTorque(moment / 2);
        Robots.rover("lifted").move(0, 0.27, 0);
        Robots.rover("sinking").move(3, 0.27, 0);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        simulation.getServo("strong").setAngle(-10);
        simulation.getServo("weak").setAngle(-10);
        double sunk = simulation.getServo("weak").getAngle();
        Worlds.run(simulation, 1);
        assertEquals(-1, simulation.getServo("strong").getAngle(), 0.15);
        double load = 2 * 9.81 * 0.45;
        assertEquals("its body is 5 cm behind its middle", 2 * (load / (moment / 2) - 1),
            simulation.getServo("weak").getAngle() - sunk, 0.1);
    }

    /** Makes a heavy robot with a light plate that a servo of that name turns about an axis at z. */
    private static Servo plate(String name, double x, double z, double rz) throws Exception {
        SEARrobot robot = new SEARrobot(name + "Robot");
        robot.addComponent(new Dynamics(name + "Weight", 400));
        Box base = new Box(name + "Base", 0.8, 1.5, 0.2, 400);
        base.move(0, 0.1, -0.3);
        robot.addComponent(base);
        Box plate = new Box(name + "Plate", 0.9, 0.5, 0.04, 0.01);
        plate.move(0, 0.25, 0);
        plate.setFriction(0.8);
        Servo servo = new Servo(name, 0, 0.25, z, 0, 0, rz);
        servo.mount(plate);
        robot.addComponent(servo);
        robot.addComponent(plate);
        robot.move(x, 0, 0);
        return servo;
    }

    /** Returns the height of the lowest point of all parts, metres. */
    private static double lowest(Body body) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < body.solids.size(); i++) {
            Pose pose = body.getPose().times(body.places[i]);
            double[] down = pose.rotateBack(0, -1, 0);
            double[] point = body.solids.get(i).farthest(down[0], down[1], down[2]);
            lowest = Math.min(lowest, pose.transform(point[0], point[1], point[2])[1]);
        }
        return lowest;
    }

    private static Pose[] poses(Simulation simulation, int count) {
        Pose[] poses = new Pose[count];
        for (int i = 0; i < count; i++) {
            poses[i] = Worlds.body(simulation, "robot" + i).getPose();
        }
        return poses;
    }
}
