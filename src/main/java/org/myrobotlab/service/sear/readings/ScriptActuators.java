// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import org.SEAR.devices.LightHardware;
import org.SEAR.devices.MotorHardware;
import org.SEAR.devices.ServoHardware;
import org.SEAR.grammar.ScriptText;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.Simulation;
import org.myrobotlab.service.sear.run.SimulationControl;

/**
 * Commands to motors, servos and lights. A command takes effect at the next step and lasts until the next command. Any
 * thread.
 */
public final class ScriptActuators {
    private final SimulationControl control;

    public ScriptActuators(SimulationControl control) {
        this.control = control;
    }

    /** @param power fraction of the full voltage, -1 to 1 */
    public void power(String name, double power) throws InterruptedException {
        control.session().scriptDrives();
        order(ActuatorOrder.Kind.POWER, name, "motor", power);
    }

    /** @param speed wheel speed, rad/s */
    public void speed(String name, double speed) throws InterruptedException {
        control.session().scriptDrives();
        order(ActuatorOrder.Kind.SPEED, name, "motor", speed);
    }

    /** Returns the mean speed of the motor's wheels, rad/s. */
    public double speed(String name) throws InterruptedException {
        return control.session().ask(world -> motor(world, name).getSpeed());
    }

    /** Returns the encoder's count. */
    public long counts(String name) throws InterruptedException {
        return control.session().ask(world -> motor(world, name).getCounts());
    }

    /** @param degrees counter-clockwise positive, seen from above */
    public void angle(String name, double degrees) throws InterruptedException {
        order(ActuatorOrder.Kind.ANGLE, name, "servo", degrees);
    }

    /** Returns degrees. */
    public double angle(String name) throws InterruptedException {
        return control.session().ask(world -> servo(world, name).getAngle());
    }

    /** @param share fraction of the full brightness, 0 to 1 */
    public void brightness(String name, double share) throws InterruptedException {
        order(ActuatorOrder.Kind.BRIGHTNESS, name, "led", share);
    }

    /** Returns 0 to 1. */
    public double brightness(String name) throws InterruptedException {
        return control.session().ask(world -> led(world, name).getBrightness());
    }

    /** @param value position of a joint, degrees or metres; speed, the same a second; or power, -1 to 1 */
    public void joint(ActuatorOrder.Kind kind, String name, double value) throws InterruptedException {
        order(kind, name, "joint", value);
    }

    /** Returns {position, speed, force of the motor}. */
    public double[] joint(String name) throws InterruptedException {
        return control.session().ask(world -> world.getJoints().reading(given(name, "joint")).numbers());
    }

    /** Returns {fx, fy, fz, tx, ty, tz}, N and N m, world frame. */
    public double[] jointForce(String name) throws InterruptedException {
        return control.session().ask(world -> world.getJoints().wrench(given(name, "joint")));
    }

    private static LightHardware led(Simulation world, String name) {
        return world.getLight(given(name, "led"));
    }

    private static ServoHardware servo(Simulation world, String name) {
        return world.getServo(given(name, "servo"));
    }

    private static String given(String name, String kind) {
        if (name == null) {
            throw new IllegalArgumentException("the name is missing (None), legal: the name of a " + kind);
        }
        return ScriptText.of(name);
    }

    private void order(ActuatorOrder.Kind kind, String name, String called, double value) throws InterruptedException {
        control.session().ask(world -> {
            world.order(new ActuatorOrder(kind, given(name, called), value));
            return true;
        });
    }

    private static MotorHardware motor(Simulation world, String name) {
        return world.getMotor(given(name, "motor"));
    }
}
