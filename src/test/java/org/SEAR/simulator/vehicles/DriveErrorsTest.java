// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.Arrays;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.DriveErrors;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Odometer;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.SEAR.devices.RobotHardware;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.OdometerReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.orders.BodyOrder;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Dead reckoning of robots whose wheels and encoders are not perfect. */
public class DriveErrorsTest {
    private static final double SIDE = 4;
    private static final int SIDES = 12;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Simulation simulation;
    private double x;
    private double z;
    private double heading;
    private double left;
    private double right;

    private static void preset(SEARrobot robot, String errors) {
        ((Dynamics) robot.getPart("drive")).setErrors(errors);
    }

    /** A step of the robot and of the program that counts its wheels' rotation. */
    private void step() {
        simulation.step();
        RobotHardware wheels = simulation.getRobots().get(0).getHardware();
        double l = wheels.getLeftWheelAngle() * wheels.getWheelRadius();
        double r = wheels.getRightWheelAngle() * wheels.getWheelRadius();
        double turned = (r - l - right + left) / wheels.getTrack();
        double way = (r - right + l - left) / 2;
        x += way * Math.sin(heading + turned / 2);
        z += way * Math.cos(heading + turned / 2);
        heading += turned;
        left = l;
        right = r;
    }

    private void drive(double speed, double radius) {
        simulation.post(world -> world.getRobots().get(0).drive(speed, radius));
    }

    /** Drives squares of 48 m by dead reckoning; returns the distance of the true from the computed end, metres. */
    private double squares(long seed) throws Exception {
        simulation = Simulation.of(Project.read(project.folder()), seed);
        for (int i = 0; i < 60; i++) {
            simulation.step();
        }
        Pose start = simulation.getRobots().get(0).getPose();
        x = start.x;
        z = start.z;
        heading = 0;
        left = 0;
        right = 0;
        for (int side = 0; side < SIDES; side++) {
            double fromX = x;
            double fromZ = z;
            drive(0.5, Double.POSITIVE_INFINITY);
            while (Math.hypot(x - fromX, z - fromZ) < SIDE) {
                step();
            }
            double from = heading;
            drive(0.1, 0);
            while (heading < from + Math.PI / 2) {
                step();
            }
        }
        Pose end = simulation.getRobots().get(0).getPose();
        simulation.close();
        return Math.hypot(end.x - x, end.z - z);
    }

    /** Without errors the computed end is true to a millimetre for each seed. */
    @Category(Slow.class)
    @Test
    public void deadReckoningMissesOneToTwoPercentByTheSeed() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Robots.create2("robot");
        assertEquals("perfect", 0, squares(1), 0.001);
        preset(robot, "create2");
        double[] off = new double[3];
        for (int seed = 1; seed <= off.length; seed++) {
            off[seed - 1] = squares(seed) / (SIDE * SIDES);
            assertEquals("seed " + seed, 0.015, off[seed - 1], 0.007);
        }
        assertEquals("mean", 0.015, Arrays.stream(off).average().orElse(0), 0.005);
        assertNotEquals("another seed", off[0], off[1], 1e-6);
        assertEquals("same seed", off[0], squares(1) / (SIDE * SIDES), 0);
        simulation = Simulation.of(Project.read(project.folder()), 2);
        double other = encoderAfterTwoSeconds();
        simulation.reseed(1);
        simulation.reset();
        assertNotEquals("a reset with another seed", other, encoderAfterTwoSeconds(), 1e-6);
    }

    private double encoderAfterTwoSeconds() {
        drive(0.3, Double.POSITIVE_INFINITY);
        for (int i = 0; i < 120; i++) {
            simulation.step();
        }
        return simulation.getRobots().get(0).getHardware().getLeftWheelAngle();
    }

    /** The controller turns wheels of 1 % more radius at the nominal rate, so the robot drives further than counted. */
    @Test
    public void wheelsRollTheirTrueRadiusAndEncodersMissCounts() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Robots.create2("robot");
        robot.addComponent(new Odometer("odometer"));
        Dynamics drive = (Dynamics) robot.getPart("drive");
        double perfect = ratio(1);
        assertEquals(1, perfect, 0.001);
        drive.setErrors(new DriveErrors(2, 0, 0, 0, 0, 0, 0, 0));
        double size = ratio(1);
        assertTrue("radius " + size, Math.abs(size - 1) > 0.009 && Math.abs(size - 1) < 0.021);
        drive.setErrors(new DriveErrors(0, 0, 0, 0, 0.1, 0, 0, 0));
        assertEquals("missed counts", 0.9, ratio(1), 0.01);
        assertEquals("an odometer counts the wheels", 0.9 * 0.3 * 10, ((OdometerReading) simulation.read("odometer"))
            .getMetres(), 0.1);
    }

    /** Returns the ratio of counted to true distance. */
    private double ratio(long seed) throws Exception {
        simulation = Simulation.of(Project.read(project.folder()), seed);
        drive(0.3, Double.POSITIVE_INFINITY);
        for (int i = 0; i < 600; i++) {
            simulation.step();
        }
        RobotHardware wheels = simulation.getRobots().get(0).getHardware();
        return (wheels.getLeftWheelAngle() + wheels.getRightWheelAngle()) / 2 * wheels.getWheelRadius()
            / wheels.getPath();
    }

    /** On ice the wheels spin: the Open Interface reports their distance, not that of the robot. */
    @Test
    public void theOpenInterfaceCountsWheels() throws Exception {
        Floor ice = new Floor("ice", 50, 50);
        ice.setFriction(0);
        SEARrobot robot = Robots.create2("robot", "/dev/uart", "/dev/user");
        robot.addComponent(new Odometer("wheels"));
        Odometer path = new Odometer("path");
        path.setTruePath(true);
        robot.addComponent(path);
        simulation = Simulation.of(Project.read(project.folder()), 1);
        ByteArrayOutputStream answers = new ByteArrayOutputStream();
        SerialLine line = simulation.getLines().get(0);
        line.setSink((bytes, starts) -> answers.write(bytes, 0, bytes.length));
        line.write(Bytes.bytes("80 84 89 00 C8 80 00"));
        for (int i = 0; i < 120; i++) {
            simulation.step();
        }
        assertEquals("stands", 0, simulation.getRobots().get(0).getHardware().getPath(), 0.01);
        assertEquals("spinning wheels count", 0.4, metres("wheels"), 0.03);
        assertEquals("not on the true path", 0, metres("path"), 0.01);
        line.write(Bytes.bytes("8E 3A 8E 13"));
        simulation.step();
        simulation.step();
        byte[] answer = answers.toByteArray();
        assertEquals("no progress", 0, answer[answer.length - 3]);
        assertEquals("200 mm/s for 2 s", 400, answer[answer.length - 2] << 8 | answer[answer.length - 1] & 0xFF, 30);
        line.write(Bytes.bytes("89 00 00 00 00"));
        step(60);
        double before = metres("wheels");
        simulation.order(new BodyOrder(BodyOrder.Kind.VELOCITY, "robot", 0, 0, 1, 0));
        step(60);
        assertEquals("pushed", 0.9, metres("path"), 0.1);
        assertEquals("locked wheels slide", before, metres("wheels"), 0.005);
    }

    private double metres(String odometer) {
        return ((OdometerReading) simulation.read(odometer)).getMetres();
    }

    private void step(int steps) {
        for (int i = 0; i < steps; i++) {
            simulation.step();
        }
    }

    /** Wheels with rollers count what they move the robot ahead, and nothing sideways. */
    @Test
    public void anOdometerOnMecanumWheelsMeasuresTheWayAhead() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", 4, 400, 0.5, 0.5, 1000, 0.02, 0, 0.1, 0, 0, 0, 0));
        for (int i = 0; i < 4; i++) {
            Wheel wheel = new Wheel("wheel" + i, 0.05, 0.04, 1, i % 2 == 0 ? 0.12 : -0.12, 0, i < 2 ? 0.15 : -0.15);
            wheel.setRollers(i == 0 || i == 3 ? -45 : 45);
            robot.addWheel(wheel);
        }
        robot.addComponent(new Odometer("wheels"));
        simulation = Simulation.of(Project.read(project.folder()), 1);
        step(60);
        drive(0.3, Double.POSITIVE_INFINITY);
        step(120);
        double path = simulation.getRobots().get(0).getTruth().path();
        assertTrue("" + path, path > 0.4);
        assertEquals(path, metres("wheels"), 0.02);
    }

    /** A circle of the middle has radius (wheelbase + understeer v^2) / tan(angle - play / 2). */
    @Test
    public void carsUndersteerAndTheirSteeringHasPlayAndDelay() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot car = Robots.car("car");
        ((Dynamics) car.getPart("drive")).setErrors(new DriveErrors(0, 0, 0, 0, 0, 4, 0.5, 2));
        simulation = Simulation.of(Project.read(project.folder()), 1);
        drive(1, Double.POSITIVE_INFINITY);
        for (int i = 0; i < 60; i++) {
            simulation.step();
        }
        simulation.post(world -> world.getRobots().get(0).steer(12));
        for (int i = 0; i < 29; i++) {
            simulation.step();
        }
        assertEquals("dead time", 0, simulation.getRobots().get(0).getSteering(), 0);
        for (int i = 0; i < 120; i++) {
            simulation.step();
        }
        assertEquals(12, simulation.getRobots().get(0).getSteering(), 1e-9);
        double[] turn = simulation.getRobots().get(0).getTruth().angularVelocity();
        double expected = Math.tan(Math.toRadians(12 - 2)) / (0.3 + Math.toRadians(2));
        assertEquals(expected, turn[1], 0.03 * expected);
    }

    /** Parts follow a servo after its play, in both directions, and commands wait for its dead time. */
    @Test
    public void servosHavePlayAndDelay() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Robots.rover("robot");
        Servo neck = new Servo("neck", 0, 0.1, 0);
        Distance ping = new Distance("ping", "laser", 0, 0.1, 0.05, 0, 0, 0);
        neck.mount(ping);
        robot.addComponent(neck);
        robot.addComponent(ping);
        neck.setPlay(2);
        neck.setDelay(0.1);
        simulation = Simulation.of(Project.read(project.folder()), 1);
        double home = simulation.getPose("ping").heading();
        simulation.getServo("neck").setAngle(30);
        for (int i = 0; i < 6; i++) {
            simulation.step();
        }
        assertEquals("dead time", 0, simulation.getServo("neck").getAngle(), 0);
        for (int i = 0; i < 60; i++) {
            simulation.step();
        }
        assertEquals(30, simulation.getServo("neck").getAngle(), 1e-9);
        assertEquals("play", 29, Math.IEEEremainder(home - simulation.getPose("ping").heading(), 360), 0.01);
        simulation.getServo("neck").setAngle(0);
        for (int i = 0; i < 60; i++) {
            simulation.step();
        }
        assertEquals("play backwards", 1, Math.IEEEremainder(home - simulation.getPose("ping").heading(), 360), 0.01);
    }

    @Test
    public void illegalErrorsAreRefusedWithTheLegalRange() {
        IllegalArgumentException range =
            assertThrows(IllegalArgumentException.class, () -> new DriveErrors(21, 0, 0, 0, 0, 0, 0, 0));
        assertEquals("DriveErrors: radius is 21, legal: a number from 0 to 20 %", range.getMessage());
        IllegalArgumentException name = assertThrows(IllegalArgumentException.class, () -> DriveErrors.of("tank"));
        assertEquals("drive errors of \"tank\", legal: car, create, create2, fourWheeled, roomba400, rover",
            name.getMessage());
    }
}
