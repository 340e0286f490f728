package org.SEAR.simulator;

import org.SEAR.robot.Robot;

/**
 * What a motor, a servo, a light or the steering of a robot is told to do, by {@link Simulation#order}; a record knows it again. Immutable, any
 * thread.
 */
public final class ActuatorOrder {
    /** What the value is, and of what. A record has their places in this list. */
    public enum Kind {
        /** Of a motor: share of the full voltage, -1 to 1. */
        POWER,
        /** Of a motor: speed of its wheels, rad/s. */
        SPEED,
        /** Of a servo: degrees. */
        ANGLE,
        /** Of a light: 0 to 1. */
        BRIGHTNESS,
        /** Of a robot: degrees of a wheel in the middle, + to the left. */
        STEERING
    }

    public final Kind kind;
    /** Of the motor, servo or light, as {@link Simulation#getMotor} takes it; of the robot. */
    public final String name;
    public final double value;

    public ActuatorOrder(Kind kind, String name, double value) {
        this.kind = kind;
        this.name = name;
        this.value = value;
    }

    /** @throws IllegalArgumentException that names what there is, or the legal range */
    void giveTo(Simulation simulation) {
        switch (kind) {
            case POWER:
                simulation.getMotor(name).setPower(value);
                break;
            case SPEED:
                simulation.getMotor(name).setSpeed(value);
                break;
            case ANGLE:
                simulation.getServo(name).setAngle(value);
                break;
            case BRIGHTNESS:
                simulation.getLight(name).setBrightness(value);
                break;
            default:
                robot(simulation).steer(value);
                break;
        }
    }

    private Robot robot(Simulation simulation) {
        return simulation.getRobots().stream().filter(robot -> robot.getObject().getName().equals(name)).findFirst()
            .orElseThrow(() -> new IllegalArgumentException("no robot is called \"" + name + "\""));
    }
}
