// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

/**
 * Ready robots: iRobot's models with the dimensions of the real ones, so that drivers compute correct distances and
 * turns; three vehicles with motors and a chassis without wheels, as a base for the user's own. Each is an ordinary
 * robot: it can be moved, and gets sensors by {@link SEARrobot#addComponent}. The parts of an iRobot are {@code drive}
 * (a {@link Dynamics}), {@code body}, the driven wheels {@code left} and {@code right}, and the casters {@code front}
 * and {@code back} (the real ones only have a front caster). Its origin is the middle of the body, which starts 54 mm
 * above the world's origin; forward is z. If an object of the environment or a robot is named {@code body}, the part of
 * {@code rover} is named {@code rover body}. If a robot can't be created completely, the project stays unchanged.
 */
public final class Robots {
    private static final double RADIUS = 0.17;
    private static final double HEIGHT = 0.07;
    /** Height of the body's middle above the axles, metres: its bottom is 20 mm above the ground, its top 90 mm. */
    private static final double RAISED = 0.0015;
    private static final double MASS = 3.6;
    private static final double STIFFNESS = 1000;
    private static final double COMPRESSION = 0.3;
    private static final double DAMPING = 0.4;
    private static final double MAX_FORCE = 10000;
    private static final double REST_LENGTH = 0.02;
    private static final double START = 0.054;
    private static final double TREAD = 0.02;
    private static final double CASTER_RADIUS = 0.02;
    private static final double CASTER_Z = 0.13;

    private Robots() {
    }

    /** A Roomba of the 400 series: wheels 258 mm apart, 57600 baud. */
    public static SEARrobot roomba400(String name) {
        return make(name, "roomba400", 57600, null, null);
    }

    /**
     * A Roomba of the 400 series with ports: {@code uart} is the device's end, {@code user} the one that the user
     * opens.
     */
    public static SEARrobot roomba400(String name, String uart, String user) {
        return make(name, "roomba400", 57600, uart, user);
    }

    /**
     * An iRobot Create, the first: wheels 258 mm apart, 57600 baud; a Roomba of the 500 series has the same dimensions.
     */
    public static SEARrobot create(String name) {
        return make(name, "create", 57600, null, null);
    }

    /**
     * An iRobot Create, the first, with ports: {@code uart} is the device's end, {@code user} the one that the user
     * opens.
     */
    public static SEARrobot create(String name, String uart, String user) {
        return make(name, "create", 57600, uart, user);
    }

    /**
     * An iRobot Create 2 or a Roomba of the 600 series: wheels of 72 mm, 235 mm apart, 508.8 encoder counts a turn,
     * 115200 baud.
     */
    public static SEARrobot create2(String name) {
        return make(name, "create2", 115200, null, null);
    }

    /**
     * An iRobot Create 2 or a Roomba of the 600 series with ports: {@code uart} is the device's end, {@code user} the
     * one that the user opens.
     */
    public static SEARrobot create2(String name, String uart, String user) {
        return make(name, "create2", 115200, uart, user);
    }

    /**
     * A chassis of 2 kg without wheels, which rests on its {@code body}; its other part is {@code drive}. Wheels with a
     * radius of 0.05 m at y 0 lift the body 4 cm above the ground.
     */
    public static SEARrobot chassis(String name) {
        return ObjectStores.get().whole(() -> PlainRobots.chassis(name));
    }

    /**
     * A rover of 2 kg with two driven wheels and a caster behind: {@code left}, {@code right}, {@code caster}, a motor
     * for each driven wheel ({@code leftMotor}, {@code rightMotor}), {@code body} and {@code drive}.
     */
    public static SEARrobot rover(String name) {
        return ObjectStores.get().whole(() -> PlainRobots.rover(name));
    }

    /**
     * A skid-steered robot of 4 kg with four driven wheels: {@code frontLeft}, {@code frontRight}, {@code rearLeft},
     * {@code rearRight}, a motor for each side ({@code leftMotor}, {@code rightMotor}), {@code body} and {@code drive}.
     */
    public static SEARrobot fourWheeled(String name) {
        return ObjectStores.get().whole(() -> PlainRobots.fourWheeled(name));
    }

    /**
     * A car of 5 kg with front wheels steered by up to 30 degrees and rear wheels driven by one motor:
     * {@code frontLeft}, {@code frontRight}, {@code rearLeft}, {@code rearRight}, {@code engine}, {@code body} and
     * {@code drive}.
     */
    public static SEARrobot car(String name) {
        return ObjectStores.get().whole(() -> PlainRobots.car(name));
    }

    private static SEARrobot make(String name, String model, int baud, String uart, String user) {
        return ObjectStores.get().whole(() -> build(name, model, baud, uart, user));
    }

    private static SEARrobot build(String name, String model, int baud, String uart, String user) {
        SEARrobot robot = new SEARrobot(name);
        Dynamics drive = new Dynamics(ObjectStores.partName(robot, "drive"), MASS, STIFFNESS, COMPRESSION, DAMPING,
            MAX_FORCE, REST_LENGTH, 0, START, 0,
            0, 0, 0);
        drive.setModel(model);
        drive.setBaud(baud);
        if (uart != null || user != null) {
            drive.setPorts(uart, user);
        }
        robot.addComponent(drive);
        Cylinder body = new Cylinder(ObjectStores.partName(robot, "body"), RADIUS, HEIGHT, MASS, "textures/roomba.jpg");
        robot.addComponent(body);
        body.move(0, RAISED, 0);
        OpenInterfaceBody size = OpenInterfaceBody.of(model);
        robot.addWheel(new Wheel(ObjectStores.partName(robot, "left"), size.wheelRadius, TREAD, 1,
            size.track / 2, 0, 0));
        robot.addWheel(new Wheel(ObjectStores.partName(robot, "right"), size.wheelRadius, TREAD, 1,
            -size.track / 2, 0, 0));
        double casterY = CASTER_RADIUS - size.wheelRadius;
        robot.addWheel(new Wheel(ObjectStores.partName(robot, "front"), CASTER_RADIUS, TREAD, 0, 0, casterY, CASTER_Z));
        robot.addWheel(new Wheel(ObjectStores.partName(robot, "back"), CASTER_RADIUS, TREAD, 0, 0, casterY, -CASTER_Z));
        return robot;
    }
}
