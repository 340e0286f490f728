// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import java.util.function.Function;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.RobotBodies;
import org.SEAR.physics.SolverBody;
import org.SEAR.robot.servo.ServoDrive;

/**
 * Wheels of one robot, solved together with the contacts of its body: a motor on each driven wheel, longitudinal and
 * lateral grip, springs on all. Idlers roll freely in every direction. Simulation thread.
 */
public final class DriveTrain implements PhysicsWorld.Drive {
    /** Speed below which a robot stands, m/s. */
    private static final double MIN_SPEED = 0.01;

    private final Body body;
    private final List<RaycastWheel> wheels = new ArrayList<>();
    private final List<GearedMotor> geared = new ArrayList<>();
    private final List<MotorDrive> motors;
    /** Null if no wheel is steered. */
    private final Steering steering;
    private final DriveForces forces;
    private final DriveLimits orders;
    private final boolean swivels;
    /** z of its turning line in the body frame, metres. */
    private final double centre;
    private final int owner;
    private final double frontAxle;
    private final double[] mounts;
    /** Speed of the body's middle at the start of the last step, m/s, + forward. */
    private double speed;
    private final List<Body> pushed = new ArrayList<>();
    private final BodyMotion motion = new BodyMotion();
    private final Vec3 ahead = new Vec3();
    private final Vec3 up = new Vec3();
    private final Vec3 sideways = new Vec3();

    /**
     * Drive train of a restarted robot.
     * @param springs of its wheels
     * @param motors of the robot, which get their wheels here
     * @param errors of wheels, encoders and steering
     * @param servos by their names
     * @param gravity present one, m/s^2, which limits acceleration and grip
     * @param reported takes warnings during the run
     */
    public DriveTrain(Body body, List<Wheel> objects, Spring[] springs, List<MotorDrive> motors, WheelErrors errors,
            Function<String, ServoDrive> servos, int owner, DoubleSupplier gravity, Consumer<String> reported) {
        this.body = body;
        this.motors = motors;
        this.owner = owner;
        double mass = RobotBodies.whole(body).mass;
        for (int i = 0; i < springs.length; i++) {
            wheels.add(new RaycastWheel(objects.get(i), springs[i], errors, i, mass));
        }
        motors.forEach(motor -> motor.restart(wheels));
        for (RaycastWheel wheel : wheels) {
            if (wheel.isDriven() && wheel.getMotor() == null) {
                geared.add(new GearedMotor());
                wheel.setMotor(geared.get(geared.size() - 1));
            }
        }
        mounts = WheelPoses.mounts(wheels);
        steering = Steering.of(wheels, servos, body.name, errors.get());
        swivels = wheels.stream().anyMatch(wheel -> wheel.getSwivel() != null);
        centre = steering != null ? steering.getCentre() : wheels.stream().filter(RaycastWheel::isDriven)
            .mapToDouble(wheel -> wheel.z).average()
            .orElse(0);
        frontAxle = wheels.stream().mapToDouble(wheel -> wheel.z).max().orElse(0);
        forces = new DriveForces(body, wheels, gravity);
        orders = new DriveLimits(body.name, wheels, forces, reported);
    }

    /** @param newLeft m/s over ground, likewise newRight */
    public void setSpeeds(double newLeft, double newRight) {
        orders.set(newLeft, newRight);
        motors.forEach(MotorDrive::follow);
    }

    /** Starts an emergency stop, until the next command that moves. */
    public void brake() {
        orders.brake();
        motors.forEach(MotorDrive::follow);
    }

    /** Whether the motors have a command to turn. */
    public boolean isCommanded() {
        return orders.isCommanded() || isMotorCommanded() || steering != null && steering.isMoving();
    }

    private boolean isMotorCommanded() {
        for (int i = 0; i < motors.size(); i++) {
            if (motors.get(i).isCommanded()) {
                return true;
            }
        }
        return false;
    }

    /** Whether commands to single motors turn the robot. */
    private boolean isTurnedByMotors() {
        double first = motors.isEmpty() ? Double.NaN : motors.get(0).getWanted();
        for (int i = 1; i < motors.size(); i++) {
            double other = motors.get(i).getWanted();
            if (!Double.isNaN(other) && other != first) {
                return true;
            }
        }
        return false;
    }

    /** Sets the target speed of each wheel for this step. */
    private void reportWheels() {
        orders.approach();
        double turn = orders.turn();
        double curvature = 0;
        if (steering != null) {
            steering.step(speed);
            curvature = steering.curvature();
            turn += orders.middle() * curvature;
        }
        boolean scrubs = turn != 0 || isTurnedByMotors();
        for (int i = 0; i < wheels.size(); i++) {
            RaycastWheel wheel = wheels.get(i);
            Swivel swivel = wheel.getSwivel();
            if (swivel == null) {
                wheel.follow(orders.middle() - turn * wheel.x, 1 - curvature * wheel.x);
            } else {
                wheel.follow(swivel.along(orders.middle(), turn, centre), swivel.along(1, curvature, centre));
            }
            wheel.getGrip().setScrubbing(scrubs ? forces.scrubbing : 0);
        }
    }

    /** Finds the ground under each wheel and the obstacle in front of it. Before the physics step. */
    public void look(RaycastScenes scenes) {
        reportWheels();
        Pose pose = body.getPose();
        up.rotate(pose, 0, 1, 0);
        ahead.rotate(pose, 0, 0, 1);
        if (swivels) {
            aim();
        }
        motion.look(body);
        speed = motion.speed(ahead);
        double coasting = Math.abs(speed) > MIN_SPEED ? speed : 0;
        boolean carried = false;
        boolean free = body.isFree();
        pushed.clear();
        for (int i = 0; i < wheels.size(); i++) {
            RaycastWheel wheel = wheels.get(i);
            wheel.look(scenes, pose, owner, up, ahead, motion, coasting);
            carried |= wheel.isGrounded();
            push(wheel.getGround());
            push(wheel.getSecondGround());
            push(wheel.getObstacle().body());
            free &= wheel.getObstacle().body() == null;
        }
        for (int i = 0; i < geared.size(); i++) {
            // gears pressed against a wall would hold the pressure and keep the robot askew
            geared.get(i).setGeared(free);
        }
        body.setCarried(carried);
    }

    /** Updates the directions of wheels that don't point straight ahead. */
    private void aim() {
        sideways.cross(up, ahead);
        for (int i = 0; i < wheels.size(); i++) {
            if (wheels.get(i).getSwivel() != null) {
                wheels.get(i).getSwivel().aim(ahead, sideways);
            }
        }
    }

    private void push(Body other) {
        if (other != null && !other.isFixed() && !pushed.contains(other)) {
            pushed.add(other);
        }
    }

    @Override
    public List<Body> loaded() {
        return pushed;
    }

    @Override
    public void prepare(SolverBody solver) {
        for (int i = 0; i < wheels.size(); i++) {
            wheels.get(i).prepare(solver, ahead, up);
        }
    }

    @Override
    public void solve(SolverBody solver) {
        for (int i = 0; i < wheels.size(); i++) {
            wheels.get(i).solve(solver.v);
        }
    }

    /** Rotates the wheels. After the physics step. */
    public void roll() {
        for (int i = 0; i < wheels.size(); i++) {
            wheels.get(i).roll(body.solver());
        }
    }

    /**
     * Steers by its steered wheels.
     * @param degrees of a wheel in the middle, + to the left
     * @throws IllegalArgumentException if it has none, if a servo steers them, or if the angle is out of range
     */
    public void steer(double degrees) {
        if (steering == null) {
            throw new IllegalArgumentException(
                "robot " + body.name + " has no steered wheels: wheel.setSteering(30) makes one");
        }
        steering.steer(degrees);
    }

    /** Whether it has steered wheels without a servo. */
    public boolean canSteer() {
        return steering != null && steering.isFree();
    }

    /**
     * Steers to a circle, or as far as it can.
     * @param radius metres, + to the left, infinite = straight, 0 = the smallest, to the left with a positive speed
     * @param speed m/s
     */
    public void steerTo(double radius, double speed) {
        steering.follow(radius == 0 ? Math.signum(speed) * Double.POSITIVE_INFINITY : 1 / radius);
        if (speed != 0) {
            orders.reportTight(Math.abs(radius), steering, speed);
            orders.reportSliding(speed, speed / Math.max(Math.abs(radius), steering.tightest()));
        }
    }

    /** Notes a circle command that only wheel speeds can follow. */
    public void turnBySpeeds() {
        if (steering != null) {
            orders.reportServo(steering.getServo());
        }
    }

    /** Steering angle, degrees, + to the left; 0 without steered wheels. */
    public double getSteering() {
        return steering == null ? 0 : steering.getDegrees();
    }

    /** Returns the commanded mean speed, for powered motors their speed without load, m/s, + forward. */
    public double getCommanded() {
        if (motors.isEmpty()) {
            return orders.middle();
        }
        double sum = 0;
        for (int i = 0; i < motors.size(); i++) {
            sum += motors.get(i).getAlong(orders.middle());
        }
        return sum / motors.size();
    }

    /** Speed of the body's middle at the start of the step, m/s, + forward. */
    public double getSpeed() {
        return speed;
    }

    /** Whether a driven wheel has ground. */
    public boolean isGrounded() {
        for (int i = 0; i < wheels.size(); i++) {
            if (wheels.get(i).isDriven() && wheels.get(i).isGrounded()) {
                return true;
            }
        }
        return false;
    }

    public List<RaycastWheel> getWheels() {
        return wheels;
    }

    /** Track of the driven wheels, metres. */
    public double getTrack() {
        return forces.track;
    }

    /**
     * Distance since the start by the encoders of the driven wheels and their nominal radii, metres, + forward: the
     * mean of the left and the right side. NaN without driven wheels, or if all of them drive across the robot.
     */
    public double getOdometer() {
        double left = meanForward(1);
        double right = meanForward(-1);
        return Double.isNaN(left) ? right : Double.isNaN(right) ? left : (left + right) / 2;
    }

    /** A wheel in the middle counts for both sides. */
    private double meanForward(int side) {
        double sum = 0;
        int count = 0;
        for (int i = 0; i < wheels.size(); i++) {
            RaycastWheel wheel = wheels.get(i);
            double forward = wheel.isDriven() && wheel.x * side >= 0 ? wheel.getForward() : Double.NaN;
            if (!Double.isNaN(forward)) {
                sum += forward;
                count++;
            }
        }
        return sum / count;
    }

    /** z of the foremost wheel's mount in the body frame, metres; 0 without wheels. */
    public double getFrontAxle() {
        return frontAxle;
    }

    /** Returns the wheels' poses in the body frame, spin included; an immutable copy for other threads. */
    public List<Pose> getWheelPoses() {
        return WheelPoses.of(wheels, mounts, swivels);
    }
}
