// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

/** Generic ready robots of {@link Robots}: small vehicles with motors as a base for the user's own. */
final class PlainRobots {
    private static final String COLOR = "#4a7fb5";
    private static final double STIFFNESS = 1000;
    private static final double COMPRESSION = 0.3;
    private static final double DAMPING = 0.4;
    private static final double MAX_FORCE = 10000;
    private static final double REST_LENGTH = 0.02;
    /** Height of the robot's origin above the axles at rest, metres. */
    private static final double HANGING = 0.018;

    private PlainRobots() {
    }

    private static SEARrobot make(String name, double mass, double radius) {
        SEARrobot robot = new SEARrobot(name);
        robot.addComponent(new Dynamics(ObjectStores.partName(robot, "drive"), mass, STIFFNESS, COMPRESSION, DAMPING,
            MAX_FORCE, REST_LENGTH, 0, radius + HANGING, 0, 0, 0, 0));
        return robot;
    }

    private static void body(SEARrobot robot, double length, double width, double height, double mass,
        double y, double z) {
        Box body = new Box(ObjectStores.partName(robot, "body"), length, width, height, mass);
        robot.addComponent(body);
        body.setColor(COLOR);
        body.move(0, y, z);
    }

    private static Wheel wheel(SEARrobot robot, String name, int type, double radius, double width,
        double x, double z) {
        Wheel wheel = new Wheel(ObjectStores.partName(robot, name), radius, width, type, x, 0, z);
        robot.addWheel(wheel);
        return wheel;
    }

    private static void motor(SEARrobot robot, String name, double torque, double speed, Wheel first, Wheel... others) {
        Motor motor = new Motor(ObjectStores.partName(robot, name), first, torque, speed);
        for (Wheel other : others) {
            motor.addWheel(other);
        }
        robot.addComponent(motor);
    }

    /** 2 kg, without wheels. The origin suits the middle between driven wheels of 5 cm radius. */
    static SEARrobot chassis(String name) {
        SEARrobot robot = make(name, 2, 0.05);
        body(robot, 0.2, 0.3, 0.06, 2, 0.02, -0.05);
        return robot;
    }

    /** 2 kg; its origin is the middle between its driven wheels. */
    static SEARrobot rover(String name) {
        SEARrobot robot = make(name, 2, 0.05);
        body(robot, 0.14, 0.22, 0.05, 2, 0.02, -0.05);
        Wheel left = wheel(robot, "left", Wheel.DRIVEN, 0.05, 0.025, 0.1, 0);
        Wheel right = wheel(robot, "right", Wheel.DRIVEN, 0.05, 0.025, -0.1, 0);
        Wheel caster = new Wheel(ObjectStores.partName(robot, "caster"), 0.02, 0.015, Wheel.IDLER, 0, -0.03, -0.13);
        robot.addWheel(caster);
        caster.setTrail(0.02);
        motor(robot, "leftMotor", 0.5, 20, left);
        motor(robot, "rightMotor", 0.5, 20, right);
        return robot;
    }

    /** 4 kg; its origin is the middle between its wheels. */
    static SEARrobot fourWheeled(String name) {
        SEARrobot robot = make(name, 4, 0.06);
        body(robot, 0.2, 0.32, 0.07, 4, 0.03, 0);
        Wheel frontLeft = wheel(robot, "frontLeft", Wheel.DRIVEN, 0.06, 0.04, 0.14, 0.1);
        Wheel frontRight = wheel(robot, "frontRight", Wheel.DRIVEN, 0.06, 0.04, -0.14, 0.1);
        Wheel rearLeft = wheel(robot, "rearLeft", Wheel.DRIVEN, 0.06, 0.04, 0.14, -0.1);
        Wheel rearRight = wheel(robot, "rearRight", Wheel.DRIVEN, 0.06, 0.04, -0.14, -0.1);
        motor(robot, "leftMotor", 3, 16, frontLeft, rearLeft);
        motor(robot, "rightMotor", 3, 16, frontRight, rearRight);
        return robot;
    }

    /** 5 kg; its origin is the middle between its wheels. */
    static SEARrobot car(String name) {
        SEARrobot robot = make(name, 5, 0.05);
        body(robot, 0.18, 0.44, 0.06, 5, 0.02, 0);
        Wheel rearLeft = wheel(robot, "rearLeft", Wheel.DRIVEN, 0.05, 0.03, 0.12, -0.15);
        Wheel rearRight = wheel(robot, "rearRight", Wheel.DRIVEN, 0.05, 0.03, -0.12, -0.15);
        wheel(robot, "frontLeft", Wheel.FREE, 0.05, 0.03, 0.12, 0.15).setSteering(30);
        wheel(robot, "frontRight", Wheel.FREE, 0.05, 0.03, -0.12, 0.15).setSteering(30);
        motor(robot, "engine", 1, 30, rearLeft, rearRight);
        return robot;
    }
}
