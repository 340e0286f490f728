// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.vehicles;

import static org.junit.Assert.assertEquals;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.ImuReading;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.SEAR.simulator.orders.BodyOrder;
import org.junit.Rule;
import org.junit.Test;

/** A robot on two wheels falls as a pendulum, and balances by examples/drive/balance.py. */
public class BalancingRobotTest {
    private static final double RADIUS = 0.05;
    private static final double MASS = 3;
    /** Height of the body's middle above the axle, metres. */
    private static final double HEIGHT = 0.12;
    private static final double MINUTE = 60;

    @Rule
    public final ProjectRule project = new ProjectRule();
    private Simulation simulation;
    private double lean;
    private double place;

    private void make(double degrees) throws Exception {
        new Floor("floor", 20, 20);
        new Box("step", 1, 1, 0.005, 0).move(0, 0.0025, 1.5);
        SEARrobot robot = new SEARrobot("robot");
        robot.addComponent(new Dynamics("drive", MASS));
        Box body = new Box("body", 0.16, 0.06, 0.3, MASS);
        body.move(0, HEIGHT, 0);
        robot.addComponent(body);
        robot.addComponent(new IMU("imu"));
        robot.addWheel(new Wheel("left", RADIUS, 0.03, 1, 0.1, 0, 0));
        robot.addWheel(new Wheel("right", RADIUS, 0.03, 1, -0.1, 0, 0));
        Motor motor = new Motor("motor", robot.getWheels().get(0), 2, 30);
        motor.addWheel(robot.getWheels().get(1));
        robot.addComponent(motor);
        robot.move(0, RADIUS, 0);
        robot.rotate(degrees, 0, 0);
        simulation = Worlds.start(project);
    }

    private double pitch() {
        return Math.toDegrees(Math.asin(simulation.getPose("robot").rotate(0, 0, 1)[1]));
    }

    /** Places the poles at -7.3 and -1.5 per second, each twice. */
    private void balance(double seconds, double target) {
        long steps = Math.round(seconds / Simulation.STEP);
        for (long step = 0; step < steps; step++) {
            double now = -Math.toRadians(((ImuReading) simulation.read("imu")).getPitch());
            double rate = (now - lean) / Simulation.STEP;
            lean = now;
            double speed = RADIUS * (simulation.getMotor("motor").getSpeed() + rate);
            place += speed * Simulation.STEP;
            double off = Math.max(-0.5, Math.min(0.5, place - target));
            double acceleration = 28.6 * lean + 3.93 * rate + 3.64 * speed + 2.26 * off;
            double wanted = (speed + acceleration * Simulation.STEP) / RADIUS - rate;
            simulation.getMotor("motor").setSpeed(Math.max(-30, Math.min(30, wanted)));
            simulation.step();
        }
    }

    @Test
    public void itStandsForAMinuteUnderPushesAndOverAStep() throws Exception {
        make(1);
        balance(2, 0);
        for (int push = 0; push < 6; push++) {
            simulation.order(new BodyOrder(BodyOrder.Kind.PUSH, "robot", 0, 0, push % 2 == 0 ? 10 : -10, 0.1));
            balance(4, 0);
        }
        balance(14, 2.5);
        balance(MINUTE - simulation.getTime(), 0);
        Pose pose = simulation.getPose("robot");
        assertEquals("upright", 0, pitch(), 0.2);
        assertEquals(0, pose.z, 0.05);
        assertEquals(RADIUS, pose.y, 1e-3);
    }

    /** A body whose motors are off tips over its wheels, which roll freely: its axle recoils. */
    @Test
    public void itTipsWithoutItsMotor() throws Exception {
        make(1);
        simulation.getMotor("motor").setPower(0);
        Worlds.run(simulation, 1);
        assertEquals("it lies", 88, Math.abs(pitch()), 5);
    }
}
