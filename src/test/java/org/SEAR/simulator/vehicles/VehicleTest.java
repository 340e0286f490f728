// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.Grounds;
import org.SEAR.physics.solid.TerrainSolid;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.robot.DriveOrder;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.GroundWorld;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;
import org.junit.function.ThrowingRunnable;

/** Steered wheels, casters, omni and mecanum wheels agree with their closed forms within 2 %. */
public class VehicleTest {
    private static final double RADIUS = 0.05;
    private static final double BASE = 0.3;
    private static final double TRACK = 0.24;
    private static final double SHARE = 0.02;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static SEARrobot chassis(double mass) {
        SEARrobot robot = new SEARrobot("car");
        robot.addComponent(new Dynamics("carDynamics", mass, 400, 0.5, 0.5, 10000, 0.02, 0, 0.15, 0, 0, 0, 0));
        Box body = new Box("carBody", 0.16, 0.36, 0.05, mass);
        body.move(0, 0.05, 0);
        robot.addComponent(body);
        return robot;
    }

    private static Wheel wheel(SEARrobot robot, String name, int type, double x, double z) {
        Wheel wheel = new Wheel(name, RADIUS, 0.03, type, x, 0, z);
        robot.addWheel(wheel);
        return wheel;
    }

    private static void motor(SEARrobot robot, String name, Wheel... wheels) {
        Motor motor = new Motor(name, wheels[0], 0.6, 20);
        for (int i = 1; i < wheels.length; i++) {
            motor.addWheel(wheels[i]);
        }
        robot.addComponent(motor);
    }

    /** Makes a car: rear wheels with one motor, front wheels steered and free. */
    private static SEARrobot car() {
        new Floor("floor", 60, 60);
        SEARrobot robot = chassis(4);
        motor(robot, "engine", wheel(robot, "rearLeft", 1, TRACK / 2, -BASE / 2),
            wheel(robot, "rearRight", 1, -TRACK / 2, -BASE / 2));
        wheel(robot, "frontLeft", 2, TRACK / 2, BASE / 2).setSteering(30);
        wheel(robot, "frontRight", 2, -TRACK / 2, BASE / 2).setSteering(30);
        return robot;
    }

    @Test
    public void aSteeredRobotStopsByAnyCommand() throws Exception {
        car();
        for (double radius : new double[] {0, -0.0, 1, Double.POSITIVE_INFINITY}) {
            try (Simulation simulation = Worlds.start(project)) {
                simulation.getRobots().get(0).drive(0.4, 2);
                Worlds.run(simulation, 2);
                double angle = simulation.getRobots().get(0).getSteering();
                simulation.getRobots().get(0).drive(0, radius);
                Worlds.run(simulation, 2);
                Pose stopped = simulation.getPose("car");
                Worlds.run(simulation, 1);
                assertEquals(stopped.x, simulation.getPose("car").x, 1e-3);
                assertEquals(stopped.z, simulation.getPose("car").z, 1e-3);
                assertEquals(radius == 0 ? angle : Math.toDegrees(Math.atan(BASE / radius)), simulation.getRobots()
                    .get(0).getSteering(), 1e-9);
            }
        }
    }

    /** Returns the radius of the circle through three points. */
    private static double radius(Pose a, Pose b, Pose c) {
        double ab = Math.hypot(b.x - a.x, b.z - a.z);
        double bc = Math.hypot(c.x - b.x, c.z - b.z);
        double ca = Math.hypot(a.x - c.x, a.z - c.z);
        double area = Math.abs((b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x));
        return ab * bc * ca / (2 * area);
    }

    private static double circle(Simulation simulation, String name) {
        Worlds.run(simulation, 2);
        Pose first = simulation.getPose(name);
        Worlds.run(simulation, 1);
        Pose second = simulation.getPose(name);
        Worlds.run(simulation, 1);
        return radius(first, second, simulation.getPose(name));
    }

    /**
     * By power, by speed and by drive command, the middle of the rear axle follows a circle of radius wheelbase /
     * tan(steering).
     */
    @Test
    public void aCarDrivesAckermannsCircle() throws Exception {
        SEARrobot robot = car();
        robot.addComponent(new Distance("axle", "laser", 0, 0, -BASE / 2, 0, 0, 0));
        Simulation simulation = Worlds.start(project);
        for (double degrees : new double[] {10, -20, 30}) {
            simulation.reset();
            simulation.getRobots().get(0).steer(degrees);
            simulation.getMotor("engine").setPower(0.4);
            double expected = BASE / Math.tan(Math.toRadians(Math.abs(degrees)));
            assertEquals("steered by " + degrees, expected, circle(simulation, "axle"), SHARE * expected);
            simulation.getRobots().get(0).drive(0.5, Double.POSITIVE_INFINITY);
            assertEquals("driven, steered by " + degrees, expected, circle(simulation, "axle"), SHARE * expected);
            assertEquals(Math.signum(degrees), Math.signum(simulation.snapshot().robots.get(0).turnRate), 0);
            assertEquals(degrees, simulation.getRobots().get(0).getSteering(), 1e-9);
        }
    }

    @Test
    public void theInnerWheelIsSteeredFurther() throws Exception {
        car();
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).steer(20);
        Worlds.run(simulation, 0.05);
        assertTrue(simulation.getRobots().get(0).getSteering() < 20);
        Worlds.run(simulation, 1);
        double turn = BASE / Math.tan(Math.toRadians(20));
        assertEquals(Math.toDegrees(Math.atan(BASE / (turn - TRACK / 2))), heading(simulation, 2), 0.01);
        assertEquals(Math.toDegrees(Math.atan(BASE / (turn + TRACK / 2))), heading(simulation, 3), 0.01);
        assertEquals(0, heading(simulation, 0), 0);
    }

    /** Returns the heading of a wheel in the snapshot, degrees to the left. */
    private static double heading(Simulation simulation, int wheel) {
        double[] axle = simulation.snapshot().robots.get(0).wheels.get(wheel).rotate(1, 0, 0);
        return Math.toDegrees(Math.atan2(-axle[2], axle[0]));
    }

    /** With all four wheels steered and driven, with or without motors, the circle is that of half the wheelbase. */
    @Test
    public void aCarWithFourSteeredWheelsTurnsOnHalfTheCircle() throws Exception {
        new Floor("floor", 60, 60);
        SEARrobot robot = chassis(4);
        for (int side : new int[] {1, -1}) {
            for (int end : new int[] {1, -1}) {
                wheel(robot, "wheel" + side + end, 1, side * TRACK / 2, end * BASE / 2).setSteering(25);
            }
        }
        Simulation simulation = Worlds.start(project);
        simulation.getRobots().get(0).steer(25);
        simulation.getRobots().get(0).drive(0.4, Double.POSITIVE_INFINITY);
        double expected = BASE / 2 / Math.tan(Math.toRadians(25));
        assertEquals(expected, circle(simulation, "car"), SHARE * expected);
    }

    @Test
    public void aServoSteers() throws Exception {
        SEARrobot robot = car();
        Servo servo = new Servo("steering");
        servo.setRange(-25, 25);
        robot.addComponent(servo);
        robot.getWheels().get(2).setSteering(servo);
        robot.getWheels().get(3).setSteering(servo);
        robot.addComponent(new Distance("axle", "laser", 0, 0, -BASE / 2, 0, 0, 0));
        Simulation simulation = Worlds.start(project);
        simulation.getServo("steering").setAngle(-15);
        simulation.getMotor("engine").setSpeed(8);
        double expected = BASE / Math.tan(Math.toRadians(15));
        assertEquals(expected, circle(simulation, "axle"), SHARE * expected);
        said("robot car is steered by its servo steering: turn that servo instead", () -> simulation.getRobots()
            .get(0).steer(3));
        said("robot car can't turn by wheel speeds 0.2 and 0.3 m/s: its servo steering steers it. Turn that "
            + "servo instead",
            () -> DriveOrder.wheels(0.2, 0.3).getFirst(simulation.getRobots().get(0)));
        simulation.getRobots().get(0).getHardware().setWheelSpeeds(0.2, 0.3);
        simulation.step();
        assertEquals("[robot car can't obey the command to drive on a circle, because its servo steering steers it: it "
            + "drives where the servo points."
            + " Turn it with sear.setServo(\"steering\", degrees)]", simulation.snapshot().warnings.toString());
    }

    /** The motor's line and the steering also hold up a slope and over a curb. */
    @Test
    public void aCarClimbsACurb() throws Exception {
        car();
        new Box("curb", 4, 4, 0.012, 0).move(0, 0.006, 2.6);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        double low = simulation.getPose("car").y;
        simulation.getMotor("engine").setPower(0.4);
        Worlds.run(simulation, 6);
        assertTrue(simulation.getPose("car").toString(), simulation.getPose("car").z > 1.2);
        assertEquals(0.012, simulation.getPose("car").y - low, 2e-3);
    }

    /** On a rising height field the motor's line and the steering are as on a plane. */
    @Test
    public void aCarClimbsAHeightField() throws Exception {
        car().rotate(0, 90, 0);
        GroundWorld world = new GroundWorld(new TerrainSolid(Grounds.slope(0.1)), Project.read(project.folder()));
        world.robot.getMotor("engine").setPower(0.5);
        world.run(4);
        Pose from = world.robot.getPose();
        world.run(4);
        Pose to = world.robot.getPose();
        double load = 4 * 9.81 * Math.sin(Math.atan(0.1)) * RADIUS;
        double expected = 4 * RADIUS * 20 * (0.5 - load / 0.6);
        assertEquals(expected, Math.hypot(to.x - from.x, to.y - from.y), SHARE * expected);
        assertEquals("it climbs", 0.1 * (to.x - from.x), to.y - from.y, 1e-3);
        world.robot.steer(-20);
        world.run(2);
        assertTrue("it turns to the right, to the east", world.robot.getPose().z > 0.02);
    }

    /** A reversed caster follows a tractrix: tan(angle / 2) falls by the factor e for each trail length. */
    @Test
    public void aCasterFollowsATractrix() throws Exception {
        new Floor("floor", 60, 60);
        SEARrobot robot = chassis(4);
        wheel(robot, "left", 1, TRACK / 2, 0.05);
        wheel(robot, "right", 1, -TRACK / 2, 0.05);
        wheel(robot, "caster", 0, 0, -0.15).setTrail(0.04);
        wheel(robot, "ball", 0, 0, 0.17);
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        simulation.getRobots().get(0).drive(0.1, 0);
        Worlds.run(simulation, 4);
        double turned = heading(simulation, 2);
        assertEquals("its axle points to the middle of the circle",
            -90 - Math.toDegrees(Math.asin(0.04 / 0.2)), turned, 1.5);
        simulation.getRobots().get(0).drive(0, 0);
        Worlds.run(simulation, 1);
        double start = Math.tan(Math.toRadians(heading(simulation, 2)) / 2);
        Pose from = simulation.getPose("car");
        simulation.getRobots().get(0).drive(0.1, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 1);
        Pose to = simulation.getPose("car");
        double way = Math.hypot(to.x - from.x, to.z - from.z);
        double expected = Math.toDegrees(2 * Math.atan(start * Math.exp(-way / 0.04)));
        assertEquals(expected, heading(simulation, 2), SHARE * Math.abs(turned));
        Worlds.run(simulation, 4);
        Pose caster = simulation.snapshot().robots.get(0).wheels.get(2);
        assertEquals("it trails behind", -0.19, caster.z, 1e-3);
        assertEquals(0, caster.x, 1e-3);
    }

    private static SEARrobot mecanum() {
        new Floor("floor", 60, 60);
        SEARrobot robot = chassis(4);
        String[] names = {"frontLeft", "frontRight", "rearLeft", "rearRight"};
        double[] rollers = {-45, 45, 45, -45};
        for (int i = 0; i < names.length; i++) {
            Wheel wheel = wheel(robot, names[i], 1, i % 2 == 0 ? TRACK / 2 : -TRACK / 2, i < 2 ? BASE / 2 : -BASE / 2);
            wheel.setRollers(rollers[i]);
            motor(robot, names[i] + "Motor", wheel);
        }
        return robot;
    }

    private static double[] way(Simulation simulation, double... speeds) {
        for (int i = 0; i < speeds.length; i++) {
            String name = simulation.getProject().getRobots().get(0).getWheels().get(i).getName();
            simulation.getMotor(name + "Motor").setSpeed(speeds[i]);
        }
        Worlds.run(simulation, 1);
        Pose from = simulation.getPose("car");
        Worlds.run(simulation, 2);
        Pose to = simulation.getPose("car");
        double[] way = from.rotateBack(to.x - from.x, to.y - from.y, to.z - from.z);
        double[] ahead = from.rotateBack(to.rotate(0, 0, 1)[0], to.rotate(0, 0, 1)[1], to.rotate(0, 0, 1)[2]);
        return new double[] {way[0], way[2], Math.atan2(ahead[0], ahead[2])};
    }

    @Test
    public void mecanumWheelsDriveSidewaysDiagonallyAndInPlace() throws Exception {
        mecanum();
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        double one = 2 * 4 * RADIUS;
        check("ahead", 0, one, 0, one, way(simulation, 4, 4, 4, 4));
        check("to the right", -one, 0, 0, one, way(simulation, 4, -4, -4, 4));
        check("diagonally ahead and right", -one / 2, one / 2, 0, one, way(simulation, 4, 0, 0, 4));
        double turn = one / ((TRACK + BASE) / 2);
        check("in place to the left", 0, 0, turn, turn, way(simulation, -4, 4, -4, 4));
    }

    private static void check(String what, double left, double ahead, double turned, double scale, double[] way) {
        assertEquals(what + ", left", left, way[0], SHARE * scale);
        assertEquals(what + ", ahead", ahead, way[1], SHARE * scale);
        assertEquals(what + ", turned", turned, way[2], SHARE * scale);
    }

    @Test
    public void threeOmniWheelsDriveIntoAnyDirection() throws Exception {
        new Floor("floor", 60, 60);
        SEARrobot robot = chassis(3);
        double far = 0.2;
        double[] angles = {0, 120, 240};
        for (int i = 0; i < angles.length; i++) {
            double angle = Math.toRadians(angles[i]);
            Wheel wheel = wheel(robot, "w" + i, 1, far * Math.sin(angle), far * Math.cos(angle));
            wheel.rotate(0, angles[i] + 90, 0);
            wheel.setRollers(0);
            motor(robot, "w" + i + "Motor", wheel);
        }
        Simulation simulation = Worlds.start(project);
        Worlds.run(simulation, 1);
        double vx = 0.1;
        double vz = 0.15;
        double[] speeds = new double[3];
        for (int i = 0; i < speeds.length; i++) {
            double heading = Math.toRadians(angles[i] + 90);
            speeds[i] = (vx * Math.sin(heading) + vz * Math.cos(heading)) / RADIUS;
        }
        check("slanted", 2 * vx, 2 * vz, 0, 2 * vz, way(simulation, speeds));
        double turn = 2 * 3 * RADIUS / far;
        check("in place to the left", 0, 0, turn, turn, way(simulation, 3, 3, 3));
    }

    @Test
    public void theSameBytesEveryRun() throws Exception {
        wheel(mecanum(), "caster", 0, 0, 0.2).setTrail(0.03);
        sameTwice("frontLeftMotor");
        SEARrobot robot = car();
        wheel(robot, "caster", 0, 0, 0).setTrail(0.03);
        sameTwice("engine");
    }

    private void sameTwice(String motor) throws ProjectException {
        Simulation simulation = Worlds.start(project);
        List<String> runs = new ArrayList<>();
        for (int run = 0; run < 2; run++) {
            StringBuilder text = new StringBuilder();
            for (int i = 0; i < 180; i++) {
                simulation.getMotor(motor).setPower(Math.sin(i * 0.05));
                if (motor.equals("engine")) {
                    simulation.getRobots().get(0).steer(30 * Math.cos(i * 0.03));
                }
                simulation.step();
                text.append(simulation.getPose("car")).append(simulation.getPose("caster"));
            }
            runs.add(text.toString());
            simulation.reset();
        }
        assertEquals(runs.get(0), runs.get(1));
    }

    @Test
    public void wrongWheelsAreRefused() throws Exception {
        String idler = "legal: none for an idler (type 0), which rolls in every direction; use a wheel of type 1 or 2";
        Wheel caster = new Wheel("caster", RADIUS, 0.02, 0);
        said("Wheel \"caster\": steering is 30, " + idler, () -> caster.setSteering(30));
        said("Wheel \"caster\": rollers is 45, " + idler, () -> caster.setRollers(45));
        said("Wheel \"caster\": trail is -1, legal: a number from 0 to 10 m", () -> caster.setTrail(-1));
        Wheel driven = new Wheel("driven", RADIUS, 0.02);
        said("Wheel \"driven\": trail is 0.1, legal: 0 for a wheel of type 1; an idler (type 0) can be a caster",
            () -> driven.setTrail(0.1));
        said("Wheel \"driven\": steering is 90, legal: a number from 0.1 to 80 deg", () -> driven.setSteering(90));
        said("Wheel \"driven\": steering is Wheel \"caster\", legal: a Servo, or the greatest angle",
            () -> driven.setSteering(caster));
        driven.setSteering(30);
        said("Wheel \"driven\": rollers is 45, legal: none for a wheel that is steered", () -> driven.setRollers(45));
        SEARrobot robot = car();
        Simulation simulation = Worlds.start(project);
        said("robot car: steering is 31.0, legal: -30 to 30 deg", () -> simulation.getRobots().get(0).steer(31));
        robot.getWheels().get(2).setSteering(20);
        problem("frontRight.steering is \"30\", legal: the same as the robot's other steered wheels: 20");
        robot.getWheels().get(2).setSteering(new Servo("loose"));
        robot.getWheels().get(3).setSteering(new Servo("loose"));
        problem("frontLeft.steeringServo is \"loose\", legal: the name of a servo of robot car");
        SEARrobot other = chassis(2);
        wheel(other, "left", 1, 0.1, 0);
        wheel(other, "right", 1, -0.1, 0).setSteering(20);
        problem("right.steering is \"20\", legal: a steered wheel in front of or behind the axle of those that "
            + "aren't steered");
        SEARrobot plain = chassis(2);
        wheel(plain, "left", 1, 0.1, 0);
        Simulation without = Worlds.start(project);
        said("robot car has no steered wheels: wheel.setSteering(30) makes one", () -> without.getRobots()
            .get(0).steer(1));
    }

    private void problem(String message) {
        ProjectException problem = assertThrows(ProjectException.class, () -> Worlds.start(project));
        assertTrue(problem.getMessage(), problem.getMessage().contains(message));
    }

    private static void said(String message, ThrowingRunnable wrong) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, wrong).getMessage());
    }

    @Test
    public void wheelSpeedsOfARobotDrivenInTheMiddleAreRefused() throws Exception {
        SEARrobot robot = chassis(4);
        new Floor("floor", 60, 60);
        motor(robot, "engine", wheel(robot, "rear", 1, 0, -BASE / 2));
        wheel(robot, "frontLeft", 2, TRACK / 2, BASE / 2);
        wheel(robot, "frontRight", 2, -TRACK / 2, BASE / 2);
        Simulation simulation = Worlds.start(project);
        Robot driven = simulation.getRobots().get(0);
        DriveOrder.wheels(0.2, 0.2).getFirst(driven);
        said("robot car can't turn by wheel speeds 0.2 and 0.3 m/s: all its driven wheels are in the middle. Move "
            + "them apart with"
            + " wheel.move(x, y, z): x > 0 is left, x < 0 is right", () -> DriveOrder.wheels(0.2, 0.3)
                .getFirst(driven));
    }
}
