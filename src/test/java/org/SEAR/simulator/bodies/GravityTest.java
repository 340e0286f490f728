// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.bodies;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Gravity;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Wheel;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import org.SEAR.sensors.ImuReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.SEAR.simulator.orders.BodyOrder;
import org.junit.Rule;
import org.junit.Test;

/** Gravity of the project acts on bodies, joints, springs, servos and sensors by closed forms. */
public class GravityTest {
    private static final double MOON = 1.62;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static double height(Simulation world, String name) {
        return world.getPose(name).y;
    }

    @Test
    public void bodiesFallByIt() throws Exception {
        new Gravity("gravity", "Moon");
        new Sphere("ball", 0.1, 2).move(0, 100, 0);
        Simulation world = Worlds.start(project);
        Worlds.run(world, 4);
        assertEquals(100 - MOON * 16 / 2, height(world, "ball"), 1e-3);
        assertEquals(MOON, world.getGravity(), 0);
    }

    @Test
    public void withoutItBodiesGoOnStraightAndFloatAsleepOrAwake() throws Exception {
        new Gravity("gravity", 0);
        new Floor("floor", 10, 10);
        Box thrown = new Box("thrown", 0.1, 0.2, 0.3, 2);
        thrown.move(0, 1, 0);
        thrown.setVelocity(0.003, 0.002, 0);
        new Box("floating", 0.1, 0.2, 0.3, 2).move(0, 1, 2);
        new Box("standing", 0.1, 0.2, 0.3, 2).move(0, 0.15, 3);
        Simulation world = Worlds.start(project);
        double stands = height(world, "standing");
        Worlds.run(world, 20);
        assertEquals("a slow body does not fall asleep", 0.06, world.getPose("thrown").x, 1e-9);
        assertEquals(1.04, height(world, "thrown"), 1e-9);
        assertEquals(1, height(world, "floating"), 0);
        assertEquals(stands, height(world, "standing"), 1e-3);
    }

    /** Half a period is the time between two crossings of the lowest point. */
    @Test
    public void aPendulumSwingsByIt() throws Exception {
        new Gravity("gravity", "Moon");
        Box rod = new Box("rod", 0.01, 0.01, 1, 1);
        rod.move(0, 2, 0);
        new Hinge("pivot", null, rod, 0, 2.5, 0, 90, 0, 0);
        rod.setVelocity(0.05, 0, 0);
        rod.setSpin(0, 0, Math.toDegrees(0.1));
        Simulation world = Worlds.start(project);
        double before = 0;
        double first = 0;
        while (world.getTime() < 10) {
            world.step();
            double now = world.getPose("rod").x;
            if (before > 0 && now <= 0) {
                first = world.getTime() - Simulation.STEP * now / (now - before);
                break;
            }
            before = now;
        }
        double half = Math.PI * Math.sqrt(2.0 / 3 / MOON);
        assertEquals(half, first, 0.01 * half);
    }

    @Test
    public void aServoLiftsOnTheMoonWhatItCannotLiftOnTheEarth() throws Exception {
        Servo lift = new Servo("lift", 0, 0.6, 0, 0, 0, 90);
        lift.setSpeed(60);
        Box weight = new Box("weight", 0.01, 0.01, 0.01, 2 * 0.18 / (Gravity.EARTH * 0.05));
        weight.move(0, 0.6, 0.05);
        lift.mount(weight);
        new Floor("floor", 20, 20);
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        robot.addComponent(lift);
        robot.addComponent(weight);
        Simulation earth = Worlds.start(project);
        earth.getServo("lift").setAngle(60);
        Worlds.run(earth, 4);
        assertTrue("" + earth.getServo("lift").getAngle(), earth.getServo("lift").getAngle() < 0);
        new Gravity("gravity", "Moon");
        Simulation moon = Worlds.start(project);
        moon.getServo("lift").setAngle(60);
        Worlds.run(moon, 4);
        assertEquals(60, moon.getServo("lift").getAngle(), 0.1);
    }

    /** Four wheels on given springs: each has the stiffness times the robot's mass, so the deflection is g / 4 k. */
    @Test
    public void givenSpringsDeflectByIt() throws Exception {
        new Floor("floor", 20, 20);
        cart(new Dynamics("drive", 5, 100, 0.5, 0.5, 10000, 0.1, 0, 0.2, 0, 0, 0, 0));
        double onEarth = standing();
        new Gravity("gravity", "Mars");
        double onMars = standing();
        assertEquals((Gravity.EARTH - 3.71) / 400, onMars - onEarth, 5e-4);
    }

    private static SEARrobot cart(Dynamics drive) {
        SEARrobot robot = new SEARrobot("cart");
        robot.addComponent(drive);
        Box body = new Box("body", 0.2, 0.4, 0.05, 5);
        robot.addComponent(body);
        for (int i = 0; i < 4; i++) {
            robot.addWheel(new Wheel("wheel" + i, 0.05, 0.03, 1, i % 2 == 0 ? 0.12 : -0.12, 0, i < 2 ? 0.1 : -0.1));
        }
        return robot;
    }

    private double standing() throws Exception {
        Simulation world = Worlds.start(project);
        Worlds.run(world, 5);
        return height(world, "cart");
    }

    @Test
    public void chosenSpringsStandAsHighOnTheMoonAndTheRobotRests() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot robot = cart(new Dynamics("drive", 5));
        Accelerometer feeler = new Accelerometer("feeler");
        feeler.setGravity(true);
        robot.addComponent(feeler);
        robot.addComponent(new IMU("imu"));
        double onEarth = standing();
        new Gravity("gravity", "Moon");
        Simulation world = Worlds.start(project);
        Worlds.run(world, 5);
        assertEquals(onEarth, height(world, "cart"), 1e-3);
        assertFalse("it sleeps", Worlds.physics(world).isAwake(Worlds.body(world, "cart")));
        double[] felt = world.read("feeler").numbers();
        assertArrayEquals(new double[] {0, MOON, 0}, felt, 1e-6);
        assertEquals("the IMU feels it too", -MOON, ((ImuReading) world.read("imu")).getAcceleration(2), 1e-6);
        world.order(BodyOrder.gravity(0));
        Worlds.run(world, 0.5);
        assertEquals("springs lift it", 0, world.read("feeler").numbers()[1], 1.5);
        assertTrue(height(world, "cart") > onEarth + 1e-4);
    }

    @Test
    public void aChangeWakesBodiesAndAResetTakesItBack() throws Exception {
        new Floor("floor", 10, 10);
        Box box = new Box("box", 0.2, 0.2, 0.2, 1);
        box.move(0, 0.1, 0);
        Simulation world = Worlds.start(project);
        Worlds.run(world, 3);
        assertFalse(Worlds.physics(world).isAwake(Worlds.body(world, "box")));
        world.order(BodyOrder.gravity(MOON));
        world.step();
        assertTrue(Worlds.physics(world).isAwake(Worlds.body(world, "box")));
        assertEquals(MOON, world.getGravity(), 0);
        world.reset();
        assertEquals(Gravity.EARTH, world.getGravity(), 0);
        for (double wrong : new double[] {-1, 100.1, Double.NaN, Double.POSITIVE_INFINITY}) {
            String message = assertThrows(IllegalArgumentException.class, () -> BodyOrder.gravity(wrong)).getMessage();
            assertEquals("gravity is " + wrong + ", legal: 0 to 100.0 m/s^2 downwards", message);
        }
    }

    @Test
    public void theEarthsGravityChangesNoByte() throws Exception {
        new Floor("floor", 10, 10);
        Robots.rover("rover");
        Box box = new Box("box", 0.2, 0.2, 0.2, 1);
        box.move(0, 0.5, 2);
        box.rotate(20, 30, 40);
        Simulation without = Worlds.start(project);
        new Gravity("gravity", "Earth");
        Simulation with = Worlds.start(project);
        for (int i = 0; i < 120; i++) {
            without.step();
            with.step();
        }
        assertEquals(without.getPose("box").toString(), with.getPose("box").toString());
        assertEquals(without.getPose("rover").toString(), with.getPose("rover").toString());
    }

    @Test
    public void itIsOneReadFromItsFileAndWrittenAsAScript() throws Exception {
        Gravity gravity = new Gravity("pull", "Moon");
        assertTrue(ProjectScript.of(Project.read(project.folder())).contains("Gravity(\"pull\", 1.62)"));
        gravity.setAcceleration(0);
        assertEquals(0, Project.read(project.folder()).getGravity(), 0);
        Path file = project.folder().resolve("environment/pull.xml");
        Files.writeString(file, Files.readString(file).replace("<acceleration>0<", "<acceleration>-1<"));
        String wrong = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(wrong, wrong.contains("acceleration") && wrong.contains("-1"));
        gravity.setAcceleration(3);
        new Gravity("second", 4);
        String two = assertThrows(ProjectException.class, () -> Project.read(project.folder())).getMessage();
        assertTrue(two, two.contains("one gravity; environment/pull.xml is it already"));
        String body = assertThrows(IllegalArgumentException.class, () -> new Gravity("third", "Pluto")).getMessage();
        assertEquals("Gravity \"third\": body is \"Pluto\", legal: Earth, Moon, Mars, or a number of m/s^2", body);
        SEARrobot robot = new SEARrobot("robot");
        assertThrows(IllegalArgumentException.class, () -> robot.addComponent(gravity));
    }
}
