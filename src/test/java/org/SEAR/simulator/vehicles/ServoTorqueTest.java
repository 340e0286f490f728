// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Servo;
import org.SEAR.devices.ServoHardware;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** A servo's torque against its load agrees with closed forms of the motor's line within 2 %. */
public class ServoTorqueTest {
    private static final double TORQUE = 0.18;
    private static final double SHARE = 0.02;
    /** Height above everything that an arm could touch, metres. */
    private static final double HEIGHT = 0.6;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot roomba(SearObject... parts) {
        new Floor("floor", 20, 20);
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        for (SearObject part : parts) {
            robot.addComponent(part);
        }
        return robot;
    }

    /** Returns the angle from rest for an inertia in kg m^2 without weight to lift, degrees. */
    private static double spunUp(double degreesPerSecond, double inertia, double seconds) {
        double settling = inertia * Math.toRadians(degreesPerSecond) / TORQUE;
        return degreesPerSecond * (seconds - settling * (1 - Math.exp(-seconds / settling)));
    }

    private static List<String> complaints(Simulation simulation) {
        return simulation.snapshot().warnings.stream().filter(text -> text.startsWith("servo "))
            .collect(Collectors.toList());
    }

    @Test
    public void aFlywheelSpinsUpByTheMotorsLineAndStopsWhereItShould() throws Exception {
        Servo servo = new Servo("hub", 0, HEIGHT, 0);
        servo.setRange(-360, 360);
        servo.setSpeed(360);
        Box disc = new Box("disc", 0.2, 0.2, 0.02, 2);
        disc.move(0, HEIGHT, 0);
        servo.mount(disc);
        roomba(servo, disc);
        double inertia = 2 * (0.2 * 0.2 + 0.2 * 0.2) / 12;
        Simulation simulation = Worlds.start(project);
        ServoHardware hub = simulation.getServo("hub");
        hub.setAngle(300);
        for (double seconds : new double[] {0.2, 0.4, 0.6, 0.8}) {
            Worlds.run(simulation, 0.2);
            double expected = spunUp(360, inertia, seconds);
            assertEquals(expected, hub.getAngle(), SHARE * expected);
        }
        double most = 0;
        for (int i = 0; i < 180; i++) {
            simulation.step();
            most = Math.max(most, hub.getAngle());
        }
        assertEquals("it is there", 300, hub.getAngle(), 0);
        assertEquals("and never went past it", 300, most, 1e-9);
        assertEquals(List.of(), complaints(simulation));
    }

    /**
     * Makes an arm on a horizontal axis, level to the front at 0 degrees, where its weight takes a share of the servo's
     * torque.
     */
    private static Servo lift(double share) {
        Servo lift = new Servo("lift", 0, HEIGHT, 0, 0, 0, 90);
        lift.setSpeed(60);
        Box weight = new Box("weight", 0.01, 0.01, 0.01, share * TORQUE / (Gravity.EARTH * 0.05));
        weight.move(0, HEIGHT, 0.05);
        lift.mount(weight);
        roomba(lift, weight);
        return lift;
    }

    /** Returns the time at which an angle is reached, interpolated linearly between two steps, seconds. */
    private static double passes(Simulation simulation, double degrees) {
        ServoHardware lift = simulation.getServo("lift");
        for (int i = 0; i < 1000; i++) {
            double before = lift.getAngle();
            simulation.step();
            if (lift.getAngle() > degrees) {
                return simulation.getTime() - Simulation.STEP * (lift.getAngle() - degrees) / (
                    lift.getAngle() - before);
            }
        }
        throw new AssertionError("it is at " + lift.getAngle());
    }

    /** Returns the integral of d(angle) / (fastest (1 - share cos(angle))) from level to an angle, seconds. */
    private static double lifting(double share, double degrees) {
        return 2 / Math.sqrt(1 - share * share) * Math.atan(
            Math.sqrt((1 + share) / (1 - share)) * Math.tan(Math.toRadians(degrees) / 2))
            / Math.toRadians(60);
    }

    @Test
    public void aLoadMakesItSlower() throws Exception {
        lift(0.5);
        Simulation simulation = Worlds.start(project);
        simulation.getServo("lift").setAngle(-60);
        Worlds.run(simulation, 2);
        assertEquals("the weight helps downwards", -60, simulation.getServo("lift").getAngle(), 0);
        simulation.getServo("lift").setAngle(60);
        double low = passes(simulation, -30);
        double high = passes(simulation, 30);
        double expected = 2 * lifting(0.5, 30);
        assertTrue("much slower than without it", expected > 1.8 * 60 / 60);
        assertEquals(expected, high - low, SHARE * expected);
        Worlds.run(simulation, 3);
        assertEquals("and it holds it there", 60, simulation.getServo("lift").getAngle(), 0);
        assertEquals(List.of(), complaints(simulation));
    }

    @Test
    public void aTooHeavyLoadSinksToItsBalanceWithOneWarning() throws Exception {
        Servo servo = lift(2);
        Simulation simulation = Worlds.start(project);
        ServoHardware lift = simulation.getServo("lift");
        lift.setAngle(45);
        Worlds.run(simulation, 40);
        assertEquals("cos(60 degrees) = 1 / 2", -60, lift.getAngle(), SHARE * 60);
        assertEquals("and rests", 0, Worlds.physics(simulation).getBusyBodies());
        assertEquals("one message", 1, complaints(simulation).size());
        String told = complaints(simulation).get(0);
        assertTrue(told, told.matches("servo lift of robot roomba is too weak to turn its load to 45\\.0 deg: at"
            + " -\\d+\\.\\d deg the load pulls with 0\\.3\\d+ N m, and its stallTorque is 0\\.18 N m\\. Give it more"
            + " \\(lift\\.setStallTorque\\(\\.\\.\\.\\)\\), or mount less, nearer to its axis"));
        simulation.reset();
        assertEquals(List.of(), complaints(simulation));
        servo.setStallTorque(0.4);
        Simulation stronger = Worlds.start(project);
        stronger.getServo("lift").setAngle(45);
        Worlds.run(stronger, 20);
        assertEquals(45, stronger.getServo("lift").getAngle(), 0);
        assertEquals(List.of(), complaints(stronger));
    }

    /** A pan carries the arm of a tilt: the higher the arm, the nearer its weight is to the pan's axis. */
    @Test
    public void loadsOnAnotherServoCountAtTheirPlace() throws Exception {
        Servo pan = new Servo("pan", 0, HEIGHT, 0);
        Servo tilt = new Servo("tilt", 0, HEIGHT, 0, 0, 0, 90);
        tilt.setStallTorque(5);
        Box weight = new Box("weight", 0.01, 0.01, 0.01, 1);
        weight.move(0, HEIGHT, 0.2);
        pan.mount(tilt);
        tilt.mount(weight);
        roomba(pan, tilt, weight);
        Simulation simulation = Worlds.start(project);
        for (double height : new double[] {0, 60}) {
            simulation.reset();
            simulation.getServo("tilt").setAngle(height);
            Worlds.run(simulation, 3);
            assertEquals(height, simulation.getServo("tilt").getAngle(), 0);
            simulation.getServo("pan").setAngle(90);
            Worlds.run(simulation, 0.25);
            double arm = 0.2 * Math.cos(Math.toRadians(height));
            double expected = spunUp(400, arm * arm, 0.25);
            assertEquals(expected, simulation.getServo("pan").getAngle(), SHARE * expected);
        }
    }

    @Test
    public void aProjectFromBeforeHasTheDefault() throws Exception {
        Servo lift = lift(0.5);
        lift.setStallTorque(3);
        Path file = project.folder().resolve("robot/lift.xml");
        String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
        assertTrue(text, text.contains("  <stallTorque>3</stallTorque>\n"));
        Files.write(file, text.replace("  <stallTorque>3</stallTorque>\n", "").getBytes(StandardCharsets.UTF_8));
        Servo old = (Servo) Project.read(project.folder()).getRobots().get(0).getComponents().stream()
            .filter(part -> part instanceof Servo)
            .findFirst().orElseThrow(AssertionError::new);
        assertEquals(TORQUE, old.getStallTorque(), 0);
    }
}
