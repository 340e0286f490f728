// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A servo is a joint: what it turns has mass and inertia, and reacts on the robot. */
public class ServoJointsTest {
    private static final double GRAVITY = 9.81;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot robot(double mass, double friction) {
        new Floor("floor", 20, 20).setFriction(friction);
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("dynamics", mass));
        return robot;
    }

    /** A load m at 1 m tips a base M that is 0.4 m wide if m (1 - 0.2) is more than M 0.2. */
    private double lean(double load) throws Exception {
        SEARrobot robot = robot(10 + load, 1);
        robot.addComponent(Arm.box("base", 0.4, 0.4, 0.1, 10, 0, 0.05, 0));
        robot.addComponent(Arm.box("feet", 0.1, 3, 0.02, 1e-3, 0, 0.01, 0));
        Arm.on(robot, new Servo("slew", 0, 0.6, 0), 30, 50, Arm.box("hook", 0.1, 0.1, 0.1, load, 0, 0.6, 1))
            .setRange(70, 90);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.getServo("slew").setAngle(90);
            Worlds.run(simulation, 2);
            return Math.toDegrees(Math.acos(simulation.getPose("robot").rotate(0, 1, 0)[1]));
        }
    }

    @Test
    public void aCraneTipsOverAsStaticsSays() throws Exception {
        assertEquals(0, lean(2.45), 0.1);
        assertTrue(lean(2.55) > 5);
    }

    @Test
    public void aFlywheelOnIceTurnsItsBaseBack() throws Exception {
        SEARrobot robot = robot(3, 0);
        robot.addComponent(Arm.box("base", 0.4, 0.4, 0.1, 2, 0, 0.05, 0));
        Servo hub = Arm.on(robot, new Servo("hub", 0, 0.2, 0), 400, 0.18,
            Arm.box("disc", 0.3, 0.3, 0.02, 1, 0, 0.2, 0));
        hub.setRange(-360, 360);
        double base = 2 * (0.4 * 0.4 + 0.4 * 0.4) / 12;
        double disc = (0.3 * 0.3 + 0.3 * 0.3) / 12;
        Simulation simulation = Worlds.start(project);
        simulation.getServo("hub").setAngle(300);
        for (int i = 0; i < 4; i++) {
            Worlds.run(simulation, 0.4);
            double[] ahead = simulation.getPose("robot").rotate(0, 0, 1);
            double turned = -disc / (base + disc) * simulation.getServo("hub").getAngle();
            assertEquals(turned, Math.toDegrees(Math.atan2(ahead[0], ahead[2])), 1e-3 * Math.abs(turned));
        }
        assertEquals(300, simulation.getServo("hub").getAngle(), 0);
    }

    /** Adds a level arm with a weight that takes a share of the servo's torque of 0.18 N m. */
    private static Servo lift(SEARrobot robot, String name, double share, double x) {
        Servo lift = new Servo(name, x, 0.6, 0, 0, 0, 90);
        double mass = share * 0.18 / (GRAVITY * 0.05);
        Arm.on(robot, lift, 60, 0.18, Arm.box(name + "Weight", 0.01, 0.01, 0.01, mass, x, 0.6, 0.05));
        return lift;
    }

    @Test
    public void aServoHoldsUpToItsStallTorqueAndSaysThatItSinks() throws Exception {
        SEARrobot robot = robot(60, 1);
        robot.addComponent(Arm.box("base", 2, 2, 0.1, 50, 0, 0.05, 0));
        lift(robot, "holds", 0.99, 0);
        lift(robot, "sinks", 1.1, 0.5);
        lift(robot, "locks", 3, -0.5).setSelfLocking(true);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 0.2);
        double before = simulation.getServo("sinks").getAngle();
        Worlds.run(simulation, 0.5);
        double sunk = simulation.getServo("sinks").getAngle();
        assertEquals("60 degrees a second times 0.1", -6 * 0.5, sunk - before, 0.05);
        assertEquals(0, simulation.getServo("holds").getAngle(), 0);
        assertEquals(0, simulation.getServo("locks").getAngle(), 0);
        List<String> told = simulation.snapshot().warnings.stream().filter(text -> text.startsWith("servo "))
            .collect(Collectors.toList());
        assertEquals(told.toString(), 1, told.size());
        assertTrue(told.get(0), told.get(0).startsWith("servo sinks of robot robot is too weak to turn its load"));
        simulation.getServo("locks").setAngle(20);
        Worlds.run(simulation, 1);
        assertEquals("too weak to lift, but locked", 0, simulation.getServo("locks").getAngle(), 0.01);
    }

    /** Parts and sensors on a servo on a servo follow their bodies, also after a teleport and a restart. */
    @Test
    public void partsFollowTheirLinks() throws Exception {
        SEARrobot robot = robot(5, 1);
        robot.addComponent(Arm.box("base", 0.4, 0.4, 0.1, 4, 0, 0.05, 0));
        Servo pan = new Servo("pan", 0, 0.2, 0);
        Servo tilt = new Servo("tilt", 0, 0.3, 0, 0, 0, -90);
        Distance eye = new Distance("eye", "laser", 0, 0.3, 0.3, 0, 0, 0);
        tilt.mount(eye);
        pan.mount(tilt);
        robot.addComponent(eye);
        Arm.on(robot, pan, 60, 5);
        Arm.on(robot, tilt, 60, 5, Arm.box("arm", 0.02, 0.3, 0.02, 0.2, 0, 0.3, 0.15));
        Simulation simulation = Worlds.start(project);
        simulation.getServo("pan").setAngle(90);
        simulation.getServo("tilt").setAngle(-30);
        Worlds.run(simulation, 2);
        Pose body = simulation.getPose("robot");
        double across = 0.3 * Math.cos(Math.toRadians(30));
        double up = 0.3 + 0.3 * Math.sin(Math.toRadians(30));
        at(body.transform(across, up, 0), simulation.getPose("eye"));
        at(body.transform(across / 2, (0.3 + up) / 2, 0), simulation.getPose("arm"));
        simulation.move("robot", new Pose(2, body.y, 1, 0, 0, 0, 1), new Pose(2, body.y, 1, 0, 0, 0, 1));
        Worlds.run(simulation, 0.5);
        assertEquals(90, simulation.getServo("pan").getAngle(), 0);
        at(simulation.getPose("robot").transform(across, up, 0), simulation.getPose("eye"));
        assertEquals(2 + across, simulation.getPose("eye").x, 0.005);
        simulation.reset();
        at(simulation.getPose("robot").transform(0, 0.3, 0.3), simulation.getPose("eye"));
    }

    private static void at(double[] place, Pose is) {
        assertEquals(place[0], is.x, 1e-4);
        assertEquals(place[1], is.y, 1e-4);
        assertEquals(place[2], is.z, 1e-4);
    }
}
