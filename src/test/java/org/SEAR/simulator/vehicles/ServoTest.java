// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gyroscope;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Sphere;
import org.SEAR.devices.ServoHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;
import org.SEAR.sensors.DistanceReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** Servos turn sensors and parts: beams, contacts and poses follow. */
public class ServoTest {
    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot roomba() {
        new Floor("floor", 20, 20);
        return Worlds.roomba("roomba", 20, 0, 0, 0);
    }

    private static void turn(Simulation simulation, String servo, double degrees) {
        simulation.getServo(servo).setAngle(degrees);
        Worlds.run(simulation, 2);
    }

    private static double distance(Simulation simulation, String name) {
        return ((DistanceReading) simulation.read(name)).getDistanceOrRange();
    }

    /** A ping on a servo measures from the pose that its angle gives. */
    @Test
    public void aSensorOnAServoLooksAbout() throws Exception {
        SEARrobot robot = roomba();
        new Box("wall", 0.1, 4, 2, 0).move(2, 0.5, 0);
        Servo neck = new Servo("neck", 0, 0.1, 0.1);
        Distance ping = new Distance("ping", "laser", 0, 0.1, 0.15, 0, 0, 0);
        neck.mount(ping);
        robot.addComponent(neck);
        robot.addComponent(ping);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        Pose body = simulation.getPose("roomba");
        turn(simulation, "neck", 90);
        assertEquals(90, simulation.getServo("roomba/neck").getAngle(), 0);
        assertEquals(1.95 - (simulation.getPose("ping").x), distance(simulation, "ping"), 0.005);
        double[] place = body.transform(0.05, 0.1, 0.1);
        assertEquals(place[0], simulation.getPose("ping").x, 1e-4);
        assertEquals(place[2], simulation.getPose("ping").z, 1e-4);
        turn(simulation, "neck", 60);
        double slanted = (1.95 - simulation.getPose("ping").x) / Math.cos(Math.toRadians(30));
        assertEquals(slanted, distance(simulation, "ping"), 0.005);
        int index = robot.getComponents().indexOf(ping);
        Pose shown = simulation.snapshot().robots.get(0).pose.times(
            simulation.snapshot().robots.get(0).parts.get(index));
        assertEquals(simulation.getPose("ping").toString(), shown.toString());
        simulation.reset();
        assertEquals(0, simulation.getServo("neck").getAngle(), 0);
        assertEquals(0.15, simulation.getPose("ping").z - simulation.getPose("roomba").z, 1e-4);
    }

    @Test
    public void itTurnsAtItsSpeed() throws Exception {
        SEARrobot robot = roomba();
        Servo neck = new Servo("neck");
        neck.setSpeed(60);
        neck.setRange(10, 170);
        robot.addComponent(neck);
        Simulation simulation = Worlds.start(project);
        ServoHardware servo = simulation.getServo("neck");
        assertEquals("it starts as near to 0 as it can", 10, servo.getAngle(), 0);
        servo.setAngle(100);
        Worlds.run(simulation, 1);
        assertEquals(70, servo.getAngle(), 1e-9);
        Worlds.run(simulation, 1);
        assertEquals(100, servo.getAngle(), 0);
    }

    /** Two servos in series: the part on the second turns with both. */
    @Test
    public void aServoOnAServoPansAndTilts() throws Exception {
        SEARrobot robot = roomba();
        Servo pan = new Servo("pan", 0, 0.2, 0);
        Servo tilt = new Servo("tilt", 0, 0.3, 0, 0, 0, 90);
        Distance ping = new Distance("ping", "laser", 0, 0.3, 0.2, 0, 0, 0);
        pan.mount(tilt);
        tilt.mount(ping);
        robot.addComponent(ping);
        robot.addComponent(tilt);
        robot.addComponent(pan);
        Simulation simulation = Worlds.start(project);
        simulation.getServo("pan").setAngle(90);
        turn(simulation, "tilt", 30);
        Pose body = simulation.getPose("roomba");
        double[] expected = body.transform(0.2 * Math.cos(Math.toRadians(30)),
            0.3 + 0.2 * Math.sin(Math.toRadians(30)), 0);
        Pose is = simulation.getPose("ping");
        assertEquals(expected[0], is.x, 1e-4);
        assertEquals(expected[1], is.y, 1e-4);
        assertEquals(expected[2], is.z, 1e-4);
    }

    /** A swinging arm pushes an object, and beams of other sensors see the arm in its actual pose. */
    @Test
    public void anArmPushesAnObject() throws Exception {
        SEARrobot robot = roomba();
        Arm.on(robot, new Servo("shoulder", 0, 0.12, 0), 60, 5, Arm.box("arm", 0.04, 0.3, 0.04, 0.1, 0, 0.12, 0.3));
        Arm.box("thing", 0.1, 0.1, 0.3, 0.2, 0.3, 0.15, 0.3);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        double before = simulation.getPose("thing").x;
        turn(simulation, "shoulder", 80);
        Pose moved = simulation.getPose("thing");
        assertTrue("the thing is at " + moved, Math.hypot(moved.x - before, moved.z - 0.3) > 0.1);
        Hit hit = new Hit();
        Pose at = simulation.getPose("arm");
        double down = simulation.getRobots().get(0).getTruth().scene()
            .cast(at.x, 2, at.z, 0, -1, 0, 5, BeamScene.WORLD, hit);
        assertEquals(at.y + 0.02, 2 - down, 1e-3);
        double none = simulation.getRobots().get(0).getTruth().scene()
            .cast(0, 2, 0.4, 0, -1, 0, 5, BeamScene.WORLD, hit);
        assertEquals("nothing is where the arm was", 2, none, 1e-3);
    }

    /**
     * A stick that sweeps an object aside at half its height keeps it in front. The object may turn on a corner, but
     * the stick doesn't penetrate it.
     */
    @Test
    public void aPushedObjectStaysInFrontOfTheArm() throws Exception {
        for (double speed : new double[] {60, 200, 400}) {
            SEARrobot robot = roomba();
            Arm.on(robot, new Servo("shoulder", 0, 0.05, 0.1), speed, 5,
                Arm.box("stick", 0.02, 0.3, 0.02, 0.02, 0, 0.05, 0.25));
            Arm.box("thing", 0.1, 0.1, 0.2, 0.2, 0.25, 0.1, 0.2);
            try (Simulation simulation = Worlds.start(project)) {
                Worlds.run(simulation, 1);
                simulation.getServo("shoulder").setAngle(90);
                for (int i = 0; i < 120; i++) {
                    simulation.step();
                    Pose arm = simulation.getPose("stick");
                    double[] way = arm.rotateBack(simulation.getPose("thing").x - arm.x, 0,
                        simulation.getPose("thing").z - arm.z);
                    assertTrue(speed + " degrees a second: the thing's middle is " + way[0] + " m before the arm",
                        way[0] > 0.04);
                }
                Pose moved = simulation.getPose("thing");
                assertTrue(speed + " degrees a second: the thing is at " + moved, moved.z < 0.05);
            }
        }
    }

    /** In a step it turns by more than its thickness. */
    @Test
    public void aSpoonThrowsABall() throws Exception {
        SEARrobot robot = roomba();
        Arm.on(robot, new Servo("hinge", 0, 0.2, 0.1, 0, 0, -90), 700, 100,
            Arm.box("spoon", 0.2, 0.3, 0.01, 0.1, 0, 0.2, 0.25));
        Sphere ball = new Sphere("ball", 0.03, 0.05);
        ball.setRollingFriction(0.1);
        ball.move(0, 0.36, 0.3);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        double from = simulation.getPose("ball").y;
        assertEquals("it lies on the spoon", simulation.getPose("spoon").y + 0.035, from, 0.005);
        simulation.getServo("hinge").setAngle(-60);
        double highest = from;
        for (int i = 0; i < 60; i++) {
            simulation.step();
            highest = Math.max(highest, simulation.getPose("ball").y);
        }
        assertTrue("it flies to " + highest + " m from " + from, highest > from + 0.15);
    }

    /** Friction drags the object along. */
    @Test
    public void anObjectOnAPlateTurnsWithIt() throws Exception {
        SEARrobot robot = roomba();
        Arm.on(robot, new Servo("table", 0, 0.3, 0), 60, 5, Arm.box("plate", 0.4, 0.4, 0.02, 0.3, 0, 0.3, 0));
        Arm.box("thing", 0.05, 0.05, 0.05, 0.1, 0.1, 0.44, 0).setFriction(2);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 2);
        turn(simulation, "table", 90);
        Pose moved = simulation.getPose("thing");
        double[] forward = moved.rotate(1, 0, 0);
        assertEquals("it has turned, " + moved, -1, forward[2], 0.001);
        assertEquals(simulation.getPose("roomba").x, moved.x, 0.005);
        assertEquals(simulation.getPose("roomba").z - 0.1, moved.z, 0.01);
    }

    /** At a large radius, for several turns. */
    @Test
    public void anObjectOnAPlateStaysAtItsDistance() throws Exception {
        SEARrobot robot = roomba();
        Servo table = Arm.on(robot, new Servo("table", 0, 0.3, 0), 60, 5,
            Arm.box("plate", 0.8, 0.8, 0.02, 0.3, 0, 0.3, 0));
        table.setRange(-360, 360);
        Arm.box("thing", 0.03, 0.03, 0.01, 0.1, 0.3, 0.316, 0).setFriction(2);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        turn(simulation, "table", 360);
        Worlds.run(simulation, 5);
        Pose at = simulation.getPose("thing");
        Pose centre = simulation.getPose("roomba");
        assertEquals("after a turn", 0.3, Math.hypot(at.x - centre.x, at.z - centre.z), 0.005);
    }

    @Test
    public void theSameBytesEveryRun() throws Exception {
        SEARrobot robot = roomba();
        Arm.on(robot, new Servo("shoulder", 0, 0.12, 0), 400, 0.18, Arm.box("arm", 0.04, 0.3, 0.04, 0.1, 0, 0.12, 0.3));
        Arm.box("thing", 0.1, 0.1, 0.3, 0.2, 0.3, 0.15, 0.3);
        Simulation simulation = Worlds.start(project);
        List<String> runs = new ArrayList<>();
        for (int run = 0; run < 2; run++) {
            StringBuilder text = new StringBuilder();
            simulation.getRobots().get(0).drive(0.1, 0.5);
            for (int i = 0; i < 180; i++) {
                simulation.getServo("shoulder").setAngle(80 * Math.sin(i * 0.05));
                simulation.step();
                text.append(simulation.getPose("arm")).append(simulation.getPose("thing"));
            }
            runs.add(text.toString());
            simulation.reset();
        }
        assertEquals(runs.get(0), runs.get(1));
    }

    @Test
    public void wrongOrdersAndMountsAreRefused() throws Exception {
        SEARrobot robot = roomba();
        SEARrobot other = Worlds.roomba("other", 2, 0, 0);
        Servo neck = new Servo("neck");
        Servo second = new Servo("second");
        Distance ping = new Distance("ping");
        neck.mount(ping);
        neck.mount(second);
        said("Servo \"second\": Distance \"ping\" is mounted on Servo \"neck\", legal: a part that no servo "
            + "or joint moves yet",
            () -> second.mount(ping));
        said("Servo \"second\": Servo \"neck\" turns it, legal: a part that does not turn it",
            () -> second.mount(neck));
        said("Servo \"neck\": Gyroscope \"gyro\" can't be mounted, legal: a shape, a light, a servo, or a sensor "
            + "except motion sensors and GPS",
            () -> neck.mount(new Gyroscope("gyro")));
        said("Servo \"neck\": part is missing (None), legal: a shape, a light, a servo, or a sensor except "
            + "motion sensors and GPS",
            () -> neck.mount(null));
        said("Servo \"neck\": minAngle is 20, legal: less than maxAngle, which is 10 deg", () -> neck.setRange(20, 10));
        robot.addComponent(neck);
        robot.addComponent(ping);
        robot.addComponent(second);
        Distance pong = new Distance("pong");
        other.addComponent(pong);
        said("Servo \"neck\": Distance \"pong\" is a part of SEARrobot \"other\", legal: a part of "
            + "SEARrobot \"roomba\"", () -> neck.mount(pong));
        Simulation simulation = Worlds.start(project);
        said("servo neck of robot roomba: angle is 91.0, legal: -90 to 90 deg", () -> simulation.getServo("neck")
            .setAngle(91));
        said("no servo is called \"nek\", legal: neck second", () -> simulation.getServo("nek"));
        second.mount(new Distance("loose"));
        ProjectException problem = assertThrows(ProjectException.class, () -> Worlds.start(project));
        assertTrue(problem.getMessage(), problem.getMessage()
            .contains("part is \"loose\", legal: the name of a component of the servo's robot"
            + " roomba: a shape, a light, a servo, or a sensor except motion sensors and GPS"));
    }

    private static void said(String message, ThrowingRunnable wrong) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, wrong).getMessage());
    }
}
