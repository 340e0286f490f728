// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.devices.MotorHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Motors agree with the closed forms of their torque-speed line within 2 %. */
public class MotorTest {
    private static final double RADIUS = 0.05;
    private static final double MASS = 4;
    private static final double STALL = 0.6;
    private static final double NO_LOAD = 12;
    private static final double SHARE = 0.02;
    /** Mass of a wheel, kg, and a stall torque that spins two of them up slowly, N m. */
    private static final double WHEEL = 0.2;
    private static final double WEAK = 0.02;

    @Rule
    public final ProjectRule project = new ProjectRule();

    /** Makes a cart on a slope, uphill along its z, with one motor for both wheels. */
    private Simulation cart(double slope, double stall, double noLoad, double gear) throws ProjectException {
        new Floor("floor", 400, 400).rotate(-slope, 0, 0);
        SEARrobot robot = Worlds.cart("cart", MASS, RADIUS, 0.15, new double[] {0}, 0.2, 0, 0, 0);
        robot.addWheel(new Wheel("cartRear", RADIUS, 0.02, 0, 0, 0, -0.2));
        Motor motor = new Motor("engine", robot.getWheels().get(0), stall, noLoad, gear, 48);
        motor.addWheel(robot.getWheels().get(1));
        robot.addComponent(motor);
        return Worlds.start(project);
    }

    private static double along(Pose from, Pose to) {
        return Math.sqrt((to.x - from.x) * (to.x - from.x) + (to.y - from.y) * (to.y - from.y)
            + (to.z - from.z) * (to.z - from.z));
    }

    @Test
    public void withoutLoadItReachesItsNoLoadSpeedExponentially() throws Exception {
        Simulation simulation = cart(0, STALL, NO_LOAD, 1);
        Worlds.run(simulation, 1);
        Pose from = simulation.getPose("cart");
        simulation.getMotor("engine").setPower(0.5);
        double end = 0.5 * NO_LOAD * RADIUS;
        double tau = MASS * RADIUS * RADIUS * NO_LOAD / STALL;
        for (double seconds : new double[] {0.5, 1, 5}) {
            Worlds.run(simulation, seconds - (simulation.getTime() - 1));
            double way = end * (seconds - tau * (1 - Math.exp(-seconds / tau)));
            assertEquals("way after " + seconds + " s", way, along(from, simulation.getPose("cart")), SHARE * way);
        }
        assertEquals(0.5 * NO_LOAD, simulation.getMotor("engine").getSpeed(), SHARE * NO_LOAD / 2);
    }

    @Test
    public void underLoadItFollowsItsTorqueSpeedLine() throws Exception {
        for (double gear : new double[] {1, 5}) {
            Simulation simulation = cart(6, STALL / gear, NO_LOAD * gear, gear);
            simulation.getMotor("engine").setPower(1);
            Worlds.run(simulation, 3);
            Pose from = simulation.getPose("cart");
            long counts = simulation.getMotor("engine").getCounts();
            Worlds.run(simulation, 2);
            double load = MASS * 9.81 * Math.sin(Math.toRadians(6)) * RADIUS;
            double turning = NO_LOAD * (1 - load / STALL);
            assertEquals(2 * turning * RADIUS, along(from, simulation.getPose("cart")), SHARE * 2 * turning * RADIUS);
            assertEquals(turning, simulation.getMotor("engine").getSpeed(), SHARE * turning);
            assertEquals(load / STALL, simulation.getMotor("engine").getLoad(), SHARE);
            assertEquals(2 * turning * gear * 48 / (2 * Math.PI), simulation.getMotor("engine").getCounts() - counts,
                SHARE * 2 * turning * gear * 8);
        }
    }

    @Test
    public void itHoldsASpeedUphillAndDownhill() throws Exception {
        for (double slope : new double[] {-6, 0, 6}) {
            Simulation simulation = cart(slope, STALL, NO_LOAD, 1);
            MotorHardware motor = simulation.getMotor("cart/engine");
            motor.setSpeed(4);
            Worlds.run(simulation, 2);
            Pose from = simulation.getPose("cart");
            Worlds.run(simulation, 2);
            assertEquals(2 * 4 * RADIUS, along(from, simulation.getPose("cart")), SHARE * 8 * RADIUS);
            motor.setSpeed(0);
            Worlds.run(simulation, 1);
            from = simulation.getPose("cart");
            Worlds.run(simulation, 10);
            assertEquals("it stands on " + slope + " degrees", 0, along(from, simulation.getPose("cart")), 2e-3);
        }
    }

    @Test
    public void aTooHeavyCartRollsBackByTheMotorsLine() throws Exception {
        Simulation simulation = cart(6, 0.1, NO_LOAD, 1);
        simulation.getMotor("engine").setPower(1);
        Worlds.run(simulation, 8);
        double load = MASS * 9.81 * Math.sin(Math.toRadians(6)) * RADIUS;
        double turning = NO_LOAD * (1 - load / 0.1);
        assertEquals(turning, simulation.getMotor("engine").getSpeed(), SHARE * -turning);
    }

    @Test
    public void aRobotWithMotorsDrivesAsAnyOther() throws Exception {
        Simulation simulation = cart(0, STALL, NO_LOAD, 1);
        simulation.getMotor("engine").setPower(1);
        Worlds.run(simulation, 0.5);
        simulation.getRobots().get(0).drive(0.3, Double.POSITIVE_INFINITY);
        Worlds.run(simulation, 2);
        Pose from = simulation.getPose("cart");
        Worlds.run(simulation, 2);
        assertEquals(0.6, along(from, simulation.getPose("cart")), SHARE * 0.6);
    }

    @Test
    public void theSameBytesEveryRun() throws Exception {
        Simulation simulation = cart(3, STALL, NO_LOAD, 1);
        List<String> runs = new ArrayList<>();
        for (int run = 0; run < 2; run++) {
            StringBuilder text = new StringBuilder();
            for (int i = 0; i < 240; i++) {
                simulation.getMotor("engine").setPower(Math.sin(i * 0.05));
                simulation.step();
                text.append(simulation.getPose("cart")).append(simulation.getMotor("engine").getCounts());
            }
            runs.add(text.toString());
            simulation.reset();
            assertEquals(0, simulation.getMotor("engine").getCounts());
        }
        assertEquals(runs.get(0), runs.get(1));
    }

    @Test
    public void wrongOrdersNameTheRange() throws Exception {
        Simulation simulation = cart(0, STALL, NO_LOAD, 2);
        MotorHardware motor = simulation.getMotor("engine");
        said("motor engine of robot cart: power is 3.0, legal: -1 to 1", () -> motor.setPower(3));
        said("motor engine of robot cart: power is NaN, legal: -1 to 1", () -> motor.setPower(Double.NaN));
        said("motor engine of robot cart: speed is 7.0, legal: -6 to 6 rad/s, which its wheels reach without load",
            () -> motor.setSpeed(7));
        said("no motor is called \"motor\", legal: engine", () -> simulation.getMotor("motor"));
    }

    @Test
    public void wrongWheelsAreRefused() throws Exception {
        SEARrobot robot = Worlds.cart("cart", MASS, RADIUS, 0.15, new double[] {0}, 0.2, 0, 0, 0);
        SEARrobot other = Worlds.cart("other", MASS, RADIUS, 0.15, new double[] {0}, 0.2, 2, 0, 0);
        Wheel left = robot.getWheels().get(0);
        said("Motor \"m\": Wheel \"cartIdler\" has type 0, legal: a driven wheel (type 1)",
            () -> new Motor("m", robot.getWheels().get(2)));
        said("Motor \"m\": wheel is missing (None), legal: a driven wheel (type 1)",
            () -> new Motor("m", (Wheel) null));
        said("Motor \"m\": stallTorque is -1, legal: a number from 0.000001 to 1000000 N m",
            () -> new Motor("m", left, -1, 5));
        Motor motor = new Motor("engine", left);
        said("Motor \"m\": Wheel \"cartLeft0\" is turned by Motor \"engine\", legal: one motor per wheel; "
            + "motor.addWheel(wheel) gives a motor several wheels", () -> new Motor("m", left));
        robot.addComponent(motor);
        said("Motor \"engine\": Wheel \"otherLeft0\" is a wheel of SEARrobot \"other\", legal: a wheel of "
            + "SEARrobot \"cart\"", () -> motor.addWheel(other.getWheels().get(0)));
        other.addComponent(new Motor("wrong", robot.getWheels().get(1)));
        ProjectException problem = assertThrows(ProjectException.class, () -> Worlds.start(project));
        assertTrue(problem.getMessage(), problem.getMessage()
            .contains("wheel is \"cartRight0\", legal: a driven wheel (type 1) of the motor's"
            + " robot other: otherLeft0, otherRight0"));
    }

    private static void said(String message, org.junit.function.ThrowingRunnable wrong) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, wrong).getMessage());
    }

    /** In free fall the wheels spin up exponentially, and the robot turns the other way with their angular momentum. */
    @Test
    public void wheelsSpinUpInTheAirAndTurnTheirRobotBack() throws Exception {
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", MASS));
        robot.addComponent(new Box("body", 0.16, 0.1, 0.1, MASS));
        for (double x : new double[] {0.1, -0.1}) {
            Wheel wheel = new Wheel(x > 0 ? "left" : "right", RADIUS, 0.02, 1, x, 0, 0);
            wheel.setMass(WHEEL);
            robot.addWheel(wheel);
        }
        Motor motor = new Motor("motor", robot.getWheels().get(0), WEAK, NO_LOAD);
        motor.addWheel(robot.getWheels().get(1));
        robot.addComponent(motor);
        robot.move(0, 100, 0);
        Simulation simulation = Worlds.start(project);
        simulation.getMotor("motor").setPower(1);
        double inertia = WHEEL * RADIUS * RADIUS / 2;
        double tau = inertia * NO_LOAD / (WEAK / 2);
        double[] turning = new double[6];
        for (int half = 1; half < 4; half++) {
            Worlds.run(simulation, 0.5);
            double speed = NO_LOAD * (1 - Math.exp(-0.5 * half / tau));
            assertEquals(speed, simulation.getMotor("motor").getSpeed(), SHARE * NO_LOAD);
            Worlds.body(simulation, "robot").velocities(turning);
            double body = MASS * 0.02 / 12;
            assertEquals("back", -2 * inertia * speed / body, turning[3], SHARE * 2 * inertia * NO_LOAD / body);
        }
        long turns = simulation.getMotor("motor").getCounts() / 360;
        double angle = NO_LOAD * (1.5 - tau * (1 - Math.exp(-1.5 / tau)));
        assertEquals("the encoder counts", angle / (2 * Math.PI), turns, 1);
    }
}
