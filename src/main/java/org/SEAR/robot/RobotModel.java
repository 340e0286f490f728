// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.vecmath.Vector3f;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Motor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.LightHardware;
import org.SEAR.devices.MotorHardware;
import org.SEAR.devices.RobotHardware;
import org.SEAR.devices.ServoHardware;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.RobotBodies;
import org.SEAR.physics.solid.Solid;
import org.SEAR.robot.servo.JointMotor;
import org.SEAR.robot.wheel.DriveTrain;
import org.SEAR.robot.wheel.MotorDrive;
import org.SEAR.robot.wheel.Obstacle;
import org.SEAR.robot.wheel.RaycastWheel;
import org.SEAR.robot.wheel.Spring;
import org.SEAR.robot.wheel.WheelErrors;
import org.SEAR.sensors.Sensor;

/** Robot of the world, and its hardware as firmware sees it. Simulation thread. */
public final class RobotModel implements Robot, RobotHardware {
    /** Vertical part of the normal above which a surface is floor or ceiling, not an obstacle. */
    private static final double LEVEL = 0.7;
    /** Share of the rest length above which a wheel counts as dropped. */
    private static final double DROPPED = 0.999;
    /** Largest number of steps after a start in which a hanging wheel does not count as dropped. */
    private static final int SETTLING = 60;

    private final SEARrobot object;
    private final Dynamics dynamics;
    private final int number;
    private final Body body;
    private final List<RobotLink> links;
    private final RaycastScenes scenes;
    private final RobotTruth truth;
    private final VirtualWalls virtualWalls;
    private final List<Sensor<?>> sensors = new ArrayList<>();
    private final List<Solid> wheelSolids;
    private final int[] wheelShapes;
    private final double[][] feet;
    private final double bodyRadius;
    private final boolean hasFarWheels;
    private final List<MotorDrive> motors = new ArrayList<>();
    private final List<JointMotor> jointMotors = new ArrayList<>();
    private final ServoMounts turrets;
    private final LedLights lights;
    private final Stability stability;
    private final Spring[] springs;
    private final Consumer<String> reported;
    private DriveTrain train;
    private SEARrobot written;
    private final Frame frame = new Frame();
    private final StuckCheck stuck;
    private final Grasp grasp = new Grasp();
    private int unsettled;
    /** Whether {@link #drive} set the steering, not a command of its own. */
    private boolean steersToDrive;

    /**
     * Robot of a world.
     * @param number its index among the robots
     * @param told takes warnings during the run
     */
    public RobotModel(RobotBuilder from, int number, RaycastScenes scenes, RobotTruth truth, VirtualWalls virtualWalls,
        Consumer<String> told) {
        this.object = from.object;
        this.written = from.object;
        this.dynamics = from.dynamics;
        this.body = from.body;
        this.links = from.links;
        this.wheelSolids = from.wheelSolids;
        this.bodyRadius = from.radius;
        this.hasFarWheels = from.hasFarWheels;
        this.feet = from.feet();
        this.number = number;
        this.scenes = scenes;
        this.truth = truth;
        this.virtualWalls = virtualWalls;
        this.turrets = new ServoMounts(from, told, grasp::holds);
        this.lights = new LedLights(from);
        this.stability = from.stability;
        this.springs = from.springs;
        this.reported = told;
        this.stuck = new StuckCheck(object);
        for (SearObject part : object.getComponents()) {
            if (part instanceof Motor && ((Motor) part).getJoint() != null) {
                jointMotors.add(new JointMotor((Motor) part, object.getName()));
            } else if (part instanceof Motor) {
                motors.add(new MotorDrive((Motor) part, object.getName()));
            }
        }
        this.wheelShapes = new int[wheelSolids.size()];
        for (int i = 0; i < wheelShapes.length; i++) {
            wheelShapes[i] = scenes.add(body, wheelSolids.get(i), object.getWheels().get(i)
                .isVisibleToSensors(), number);
        }
    }

    public void add(Sensor<?> sensor) {
        sensors.add(sensor);
        turrets.add(sensor);
    }

    /** Adds its bodies and joints to the physics. */
    public void addTo(PhysicsWorld physics) {
        physics.add(body);
        links.forEach(link -> physics.add(link.getBody()));
        turrets.addTo(physics);
    }

    /** Moves the servos to their start, before the physics restarts. */
    public void rewind() {
        turrets.restart();
    }

    /**
     * Moves everything to its start, in a new physics world.
     * @param seed random seed of the simulation
     */
    public void restart(PhysicsWorld physics, long seed) {
        turrets.attach();
        jointMotors.forEach(JointMotor::restart);
        WheelErrors errors = new WheelErrors(dynamics.getErrors(), seed, object.getName());
        train = new DriveTrain(body, object.getWheels(), springs, motors, errors, turrets::find, number,
            truth::gravity, reported);
        if (!train.getWheels().isEmpty()) {
            physics.add(body, train);
        }
        truth.touches().restart();
        lights.restart();
        stuck.restart();
        steersToDrive = false;
        unsettled = SETTLING;
        truth.restart();
        truth.setEncoders(Double.isNaN(train.getOdometer()) ? null : train::getOdometer);
    }

    /**
     * Teleports the robot, at rest; its motors go on.
     * @param start pose for the next start
     */
    public void move(PhysicsWorld physics, Pose start, Pose to) {
        turrets.move(physics, start, to);
        physics.move(body, start, to);
        truth.touches().clear();
        truth.moved();
        sensors.forEach(Sensor::moved);
        unsettled = SETTLING;
        mirror();
    }

    /** Finds the ground, and wakes the body when its motors turn or its ground moves. Before the physics step. */
    public void prepare() {
        boolean busy = train.isCommanded() || groundMoves();
        busy |= turrets.step();
        for (int i = 0; i < jointMotors.size(); i++) {
            busy |= jointMotors.get(i).isCommanded();
        }
        body.setDriven(busy);
        if (busy) {
            body.wake();
        }
        if (body.isActive()) {
            train.look(scenes);
        }
    }

    private boolean groundMoves() {
        for (int i = 0; i < train.getWheels().size(); i++) {
            Body ground = train.getWheels().get(i).getGround();
            if (ground != null && !ground.isFixed() && ground.isActive()) {
                return true;
            }
        }
        return false;
    }

    /** Rotates the wheels and moves its shapes in the scenes. After the physics step. */
    public void follow(boolean awake) {
        if (unsettled > 0) {
            unsettled = train.getWheels().stream().anyMatch(this::hangs) ? unsettled - 1 : 0;
        }
        if (awake) {
            checkStuck();
            train.roll();
            turrets.follow();
            mirror();
            truth.touches().clear();
            grasp.clear();
        }
        truth.touches().release();
        for (int i = 0; awake && i < wheelShapes.length; i++) {
            Obstacle obstacle = train.getWheels().get(i).getObstacle();
            if (obstacle.isPressed()) {
                stuck.touched(obstacle.body(), ahead(obstacle.point.x, obstacle.point.y, obstacle.point.z));
                truth.touches().press(RobotBodies.whole(body).solids.size() - wheelShapes.length + i, obstacle.point.x,
                    obstacle.point.y, obstacle.point.z);
            }
        }
    }

    private void checkStuck() {
        String warning = stuck.step(train.getCommanded(), train.getSpeed(), train.isGrounded());
        if (warning != null) {
            reported.accept(warning);
        }
    }

    /** Returns how far a point of the world is ahead of the robot's origin, metres. */
    private double ahead(double x, double y, double z) {
        Pose pose = body.getPose();
        return pose.rotateBack(x - pose.x, y - pose.y, z - pose.z)[2];
    }

    /** Copies its poses to the scenes. */
    public void mirror() {
        body.mirror(scenes);
        for (int i = 0; i < links.size(); i++) {
            links.get(i).getBody().mirror(scenes);
        }
        for (int i = 0; i < wheelShapes.length; i++) {
            frame.set(body.getPose());
            train.getWheels().get(i).place(frame);
            frame.times(wheelSolids.get(i).offset);
            scenes.setPose(wheelShapes[i], frame);
        }
    }

    /**
     * Notes a contact of one of its bodies.
     * @param index of the touched solid in that body
     * @param other touching body
     * @param normal of the touching surface; its vertical part decides whether it is an obstacle
     */
    public void touch(Body of, int index, Body other, Vector3f at, Vector3f normal) {
        int solid = links.isEmpty() ? index : RobotBodies.whole(body).solids.indexOf(of.solids.get(index));
        grasp.touched(solid, other);
        if (Math.abs(normal.y) <= LEVEL) {
            stuck.touched(other, ahead(at.x, at.y, at.z));
            truth.touches().press(solid, at.x, at.y, at.z);
        } else if (!truth.touches().isWheel(solid)) {
            truth.touches().add(solid);
        }
    }

    /**
     * Returns the height at which it stands on the surfaces below a pose.
     * @param at its pose there; surfaces more than {@code climb} metres above it do not count
     * @return y of its frame, metres; NaN if nothing is below
     */
    public double standing(Pose at, double climb) {
        double height = Double.NEGATIVE_INFINITY;
        double[][] lowest = feet.length > 0 ? feet : new double[][] {{0, body.lowest() - body.getPose().y, 0}};
        for (double[] foot : lowest) {
            double[] point = at.transform(foot[0], foot[1], foot[2]);
            double down = scenes.ground.cast(point[0], point[1] + climb, point[2], 0, -1, 0, Double.MAX_VALUE,
                number, null);
            height = down < Double.POSITIVE_INFINITY ? Math.max(height, at.y + climb - down) : height;
        }
        return height == Double.NEGATIVE_INFINITY ? Double.NaN : height;
    }

    public Body getBody() {
        return body;
    }

    public RobotTruth truth() {
        return truth;
    }

    public DriveTrain getTrain() {
        return train;
    }

    public Dynamics getDynamics() {
        return dynamics;
    }

    /** Springs of its wheels, in their order. */
    Spring[] getSprings() {
        return springs;
    }

    @Override
    public SEARrobot getObject() {
        return object;
    }

    @Override
    public int getOwner() {
        return number;
    }

    @Override
    public Pose getPose() {
        return body.getPose();
    }

    @Override
    public Pose getStart() {
        return body.getStart();
    }

    @Override
    public SEARrobot getWritten() {
        return written;
    }

    /** @param newWritten the object with the start pose of its file */
    public void setWritten(SEARrobot newWritten) {
        written = newWritten;
    }

    @Override
    public org.SEAR.sensors.Truth getTruth() {
        return truth;
    }

    @Override
    public RobotHardware getHardware() {
        return this;
    }

    @Override
    public List<Sensor<?>> getSensors() {
        return sensors;
    }

    /** Whether a wheel is too large or too far away for checks of the robot's stand. */
    boolean hasFarWheels() {
        return hasFarWheels;
    }

    @Override
    public Stability getStability() {
        return stability;
    }

    @Override
    public void drive(double speed, double radius) {
        if (speed == 0 && radius == 0) {    // no circle to steer to
            train.setSpeeds(0, 0);
            return;
        }
        if (train.canSteer() && (steersToDrive || Double.isFinite(radius))) {
            steersToDrive = Double.isFinite(radius);
            train.steerTo(steersToDrive ? radius : Double.POSITIVE_INFINITY, speed);
            double along = radius == 0 ? Math.abs(speed) : speed;
            train.setSpeeds(along, along);
            return;
        }
        if (Double.isFinite(radius) && speed != 0) {
            train.turnBySpeeds();
        }
        double half = getTrack() / 2;
        if (Double.isInfinite(radius)) {
            train.setSpeeds(speed, speed);
        } else if (radius == 0) {
            train.setSpeeds(-speed, speed);
        } else {
            train.setSpeeds(speed * (1 - half / radius), speed * (1 + half / radius));
        }
    }

    @Override
    public void steer(double degrees) {
        train.steer(degrees);
        steersToDrive = false;
    }

    @Override
    public double getSteering() {
        return train.getSteering();
    }

    @Override
    public void brake() {
        train.brake();
    }

    @Override
    public void setWheelSpeeds(double left, double right) {
        if (!Double.isFinite(left) || !Double.isFinite(right)) {
            throw new IllegalArgumentException("robot " + object.getName() + ": wheel speeds are " + left
                + " and " + right
                + " m/s, legal: finite numbers");
        }
        double along = (left + right) / 2;
        if (left == right && (along == 0 || !steersToDrive)) {
            train.setSpeeds(left, right);
        } else if (train.canSteer() && getTrack() > 0) {
            double radius = left == right ? Double.POSITIVE_INFINITY : along * getTrack() / (right - left);
            drive(radius == 0 ? right : along, radius);
        } else {
            train.turnBySpeeds();
            train.setSpeeds(left, right);
        }
    }

    @Override
    public MotorHardware getMotor(String name) {
        return Stream.<MotorHardware>concat(motors.stream(), jointMotors.stream())
            .filter(motor -> motor.getName().equals(name)).findFirst().orElse(null);
    }

    /** Motors that drive its joints. */
    public List<JointMotor> getJointMotors() {
        return jointMotors;
    }

    @Override
    public ServoHardware getServo(String name) {
        return turrets.find(name);
    }

    @Override
    public LightHardware getLight(String name) {
        return lights.find(name);
    }

    /** Brightness of each LED, 0 to 1, in the order of its components; the same list until one changes. Immutable. */
    public List<Double> getLights() {
        return lights.getShown();
    }

    /**
     * Pose of each component in the body frame; empty without servos and joints, when the components stay at the poses
     * of their objects. Immutable.
     */
    public List<Pose> getPartPoses() {
        return turrets.getPoses();
    }

    @Override
    public double getTrack() {
        return train.getTrack();
    }

    @Override
    public double getLeftWheelAngle() {
        return mean(1, true);
    }

    @Override
    public double getRightWheelAngle() {
        return mean(-1, true);
    }

    @Override
    public double getLeftLoad() {
        return mean(1, false);
    }

    @Override
    public double getRightLoad() {
        return mean(-1, false);
    }

    /** Returns the mean over the driven wheels of one side; a wheel in the middle counts for both. */
    private double mean(int side, boolean angle) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < train.getWheels().size(); i++) {
            RaycastWheel wheel = train.getWheels().get(i);
            if (wheel.isDriven() && wheel.x * side >= 0) {
                sum += angle ? wheel.getEncoder() : Math.abs(wheel.getLoad());
                count++;
            }
        }
        return count == 0 ? 0 : sum / count;
    }

    @Override
    public double getWheelRadius() {
        for (RaycastWheel wheel : train.getWheels()) {
            if (wheel.isDriven()) {
                return wheel.radius;
            }
        }
        return 0;
    }

    @Override
    public double getPath() {
        return truth.path();
    }

    @Override
    public double getSpeed() {
        double[] ahead = body.getPose().rotate(0, 0, 1);
        double[] v = truth.velocity();
        return v[0] * ahead[0] + v[1] * ahead[1] + v[2] * ahead[2];
    }

    @Override
    public double getTurned() {
        return truth.turned();
    }

    @Override
    public boolean isBumpedLeft() {
        return truth.touches().isBumpedLeft();
    }

    @Override
    public boolean isBumpedRight() {
        return truth.touches().isBumpedRight();
    }

    @Override
    public boolean isLeftWheelDropped() {
        return dropped(1);
    }

    @Override
    public boolean isRightWheelDropped() {
        return dropped(-1);
    }

    private boolean dropped(int side) {
        for (int i = 0; i < train.getWheels().size(); i++) {
            RaycastWheel wheel = train.getWheels().get(i);
            if (wheel.isDriven() && wheel.x * side >= 0 && hangs(wheel)) {
                return unsettled == 0;
            }
        }
        return false;
    }

    private boolean hangs(RaycastWheel wheel) {
        return !wheel.isGrounded() || wheel.getRest() > 0 && wheel.getLength() > DROPPED * wheel.getRest();
    }

    @Override
    public boolean isCasterDropped() {
        RaycastWheel front = null;
        for (int i = 0; i < train.getWheels().size(); i++) {
            RaycastWheel wheel = train.getWheels().get(i);
            if (!wheel.isDriven() && (front == null || wheel.z > front.z)) {
                front = wheel;
            }
        }
        return unsettled == 0 && front != null && hangs(front);
    }

    @Override
    public double look(double x, double y, double z, double dx, double dy, double dz, double range) {
        double[] from = body.getPose().transform(x, y, z);
        double[] along = body.getPose().rotate(dx, dy, dz);
        return scenes.ground.cast(from[0], from[1], from[2], along[0], along[1], along[2], range, number, null);
    }

    @Override
    public double getFrontAxle() {
        return train.getFrontAxle();
    }

    @Override
    public double getBodyRadius() {
        return bodyRadius;
    }

    @Override
    public boolean isInVirtualWall() {
        Pose pose = body.getPose();
        return virtualWalls.reach(pose.x, pose.y, pose.z, number);
    }
}
