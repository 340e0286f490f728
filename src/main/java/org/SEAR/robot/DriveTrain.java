package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.Scenes;
import org.SEAR.physics.SolverBody;

/**
 * The wheels of one robot. jbullet solves them together with the contacts of the body: a servo of limited force on each driven wheel, grip along
 * and across it, springs on all; idlers roll freely in every direction. Simulation thread.
 */
public final class DriveTrain implements PhysicsWorld.Drive {
    /** Greatest force of all motors together for each kg of the robot, N/kg (climbs 20 degrees). */
    private static final double MOTOR_FORCE = 4;
    /** The same for a skid-steered robot, whose wheels scrub when it turns. */
    private static final double SKID_FORCE = 9;
    /** Friction across the wheels of a skid-steered robot as a share of what its track and wheelbase would just allow. */
    private static final double SKID_GRIP = 0.4;
    /** While it turns, its wheels resist scrubbing in proportion to speed: force of all together for each kg and m/s, 1/s. */
    private static final double SKID_DAMPING = 25;
    private static final double NO_TRACK = 1e-6;
    /** Greatest change of the wheels' speed that the motor controller asks for, m/s^2. */
    private static final double RAMP = 4;
    /** The same for an emergency stop, which shorts the motors; the grip of the tyres sets the limit. */
    private static final double BRAKE_RAMP = 20;
    /** The same as a share of what would lift a wheel off the ground. */
    private static final double TIPPING_SHARE = 0.5;
    /** What tips over anyway starts and stops so, m/s^2. */
    private static final double LEAST_RAMP = 0.2;

    /** A robot slower than this stands, m/s. */
    private static final double LEAST_SPEED = 0.01;

    private final Body body;
    private final List<RaycastWheel> wheels = new ArrayList<>();
    private final List<MotorDrive> motors;
    /** Null if no wheel is steered. */
    private final Steering steering;
    private final boolean swivels;
    /** The z of the line on which it turns, in the body frame, metres. */
    private final double centre;
    private final int owner;
    private final double[] mounts;
    private final double track;
    private final double frontAxle;
    private final double ramp;
    private final double brakeRamp;
    private boolean braking;
    private double scrub;
    private double left;
    private double right;
    private double commandedLeft;
    private double commandedRight;
    private final double[] v = new double[6];
    private final double[] ahead = new double[3];
    private final double[] up = new double[3];
    private final double[] sideways = new double[3];
    private final double[] groundSpeed = new double[3];
    private final double[] impulse = new double[3];
    private final double[] point = new double[3];

    /** @param motors of the robot, which get their wheels here */
    DriveTrain(Body body, List<Wheel> objects, List<MotorDrive> motors, Turrets servos, Dynamics dynamics, int owner) {
        this.body = body;
        this.motors = motors;
        this.owner = owner;
        for (Wheel wheel : objects) {
            wheels.add(new RaycastWheel(wheel, dynamics, body.mass));
        }
        motors.forEach(motor -> motor.restart(wheels));
        mounts = WheelPoses.mounts(wheels);
        steering = Steering.of(wheels, servos, body.name);
        swivels = wheels.stream().anyMatch(wheel -> wheel.getSwivel() != null);
        centre = steering != null ? steering.getCentre() : wheels.stream().filter(RaycastWheel::isDriven).mapToDouble(wheel -> wheel.z).average()
            .orElse(0);
        track = equip();
        frontAxle = wheels.stream().mapToDouble(wheel -> wheel.z).max().orElse(0);
        double safe = safeRamp(objects, dynamics);
        ramp = Math.min(RAMP, safe);
        brakeRamp = objects.size() < 3 ? RAMP : Math.min(BRAKE_RAMP, safe);
    }

    /** How fast speeds may change, m/s^2: a tall robot must not fall over when it starts or stops. */
    private double safeRamp(List<Wheel> objects, Dynamics dynamics) {
        if (objects.size() < 3) {
            return Double.POSITIVE_INFINITY;
        }
        double[] mass = body.getCentre();
        double lowest = Double.POSITIVE_INFINITY;
        for (RaycastWheel wheel : wheels) {
            lowest = Math.min(lowest, wheel.y - dynamics.getRestLength() - wheel.radius);
        }
        double room = CentreOfMass.room(mass[0], mass[2], objects);
        return Math.max(LEAST_RAMP, TIPPING_SHARE * PhysicsWorld.GRAVITY * room / Math.max(mass[1] - lowest, NO_TRACK));
    }

    /**
     * Shares out the motor force and the grip.
     *
     * @return distance of the left from the right driven wheels, metres
     */
    private double equip() {
        double widest = 0;
        double front = Double.NEGATIVE_INFINITY;
        double back = Double.POSITIVE_INFINITY;
        double leftSum = 0;
        double rightSum = 0;
        int lefts = 0;
        int rights = 0;
        int driven = 0;
        for (RaycastWheel wheel : wheels) {
            if (wheel.isDriven()) {
                driven++;
                if (wheel.getSwivel() == null) {
                    front = Math.max(front, wheel.z);
                    back = Math.min(back, wheel.z);
                }
                widest = Math.max(widest, wheel.radius);
                if (wheel.x > 0) {
                    leftSum += wheel.x;
                    lefts++;
                } else if (wheel.x < 0) {
                    rightSum -= wheel.x;
                    rights++;
                }
            }
        }
        double distance = (lefts > 0 ? leftSum / lefts : 0) + (rights > 0 ? rightSum / rights : 0);
        boolean skid = front - back > widest;
        scrub = skid ? driven / (SKID_DAMPING * body.mass * TimeStep.SECONDS) : 0;
        double grip = skid ? Math.min(1, SKID_GRIP * Math.max(distance, NO_TRACK) / (front - back)) : 1;
        for (RaycastWheel wheel : wheels) {
            if (wheel.isDriven()) {
                wheel.equip((skid ? SKID_FORCE : MOTOR_FORCE) * body.mass / driven, grip);
            }
        }
        return distance;
    }

    /** @param newLeft m/s over ground, likewise newRight */
    void setSpeeds(double newLeft, double newRight) {
        commandedLeft = newLeft;
        commandedRight = newRight;
        motors.forEach(MotorDrive::follow);
        braking = braking && newLeft == 0 && newRight == 0;
    }

    /** An emergency stop, until the next command that moves. */
    void brake() {
        setSpeeds(0, 0);
        braking = true;
    }

    /** Whether the motors are to turn. */
    boolean isCommanded() {
        return left != 0 || right != 0 || commandedLeft != 0 || commandedRight != 0 || isMotorCommanded()
            || steering != null && steering.isMoving();
    }

    private boolean isMotorCommanded() {
        for (int i = 0; i < motors.size(); i++) {
            if (motors.get(i).isCommanded()) {
                return true;
            }
        }
        return false;
    }

    /** Whether the motors have orders of their own that turn the robot. */
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

    /** Brings both speeds nearer to what is commanded, in proportion, so that an arc stays the same arc. */
    private void approach() {
        double largest = Math.max(Math.abs(commandedLeft - left), Math.abs(commandedRight - right));
        double step = (braking ? brakeRamp : ramp) * TimeStep.SECONDS;
        double share = largest <= step ? 1 : step / largest;
        left = share == 1 ? commandedLeft : left + share * (commandedLeft - left);
        right = share == 1 ? commandedRight : right + share * (commandedRight - right);
        double turn = track > NO_TRACK ? (right - left) / track : 0;
        if (steering != null) {
            steering.step();
            turn += (left + right) / 2 * steering.curvature();
        }
        boolean scrubs = turn != 0 || isTurnedByMotors();
        for (int i = 0; i < wheels.size(); i++) {
            RaycastWheel wheel = wheels.get(i);
            Swivel swivel = wheel.getSwivel();
            wheel.setTarget(swivel == null ? (left + right) / 2 - turn * wheel.x : swivel.along((left + right) / 2, turn, centre));
            wheel.setScrub(scrubs ? scrub : 0);
        }
    }

    /** Looks for the ground under each wheel, before jbullet's step. */
    void look(Scenes scenes) {
        approach();
        Pose pose = body.getPose();
        axis(pose, up, 0, 1, 0);
        axis(pose, ahead, 0, 0, 1);
        if (swivels) {
            aim();
        }
        body.velocities(v);
        double speed = v[0] * ahead[0] + v[1] * ahead[1] + v[2] * ahead[2];
        boolean carried = false;
        boolean free = body.isFree();
        for (int i = 0; i < wheels.size(); i++) {
            RaycastWheel wheel = wheels.get(i);
            wheel.look(scenes, pose, owner, up);
            carried |= wheel.isGrounded();
            double sign = wheel.getTarget() != 0 ? wheel.getTarget() : Math.abs(speed) > LEAST_SPEED ? speed : 0;
            wheel.lookAhead(scenes, pose, owner, ahead, Math.signum(sign));
            free &= wheel.getObstacle() == null;
        }
        for (int i = 0; i < wheels.size(); i++) {
            // pressed against a wall the gears would hold the pressure, and with it the robot askew
            wheels.get(i).setGeared(free);
        }
        body.setCarried(carried);
        body.forgetObstacles();
    }

    /** Finds out where wheels point that do not just point ahead. */
    private void aim() {
        sideways[0] = up[1] * ahead[2] - up[2] * ahead[1];
        sideways[1] = up[2] * ahead[0] - up[0] * ahead[2];
        sideways[2] = up[0] * ahead[1] - up[1] * ahead[0];
        for (int i = 0; i < wheels.size(); i++) {
            if (wheels.get(i).getSwivel() != null) {
                wheels.get(i).getSwivel().aim(ahead, sideways);
            }
        }
    }

    private static void axis(Pose pose, double[] into, double x, double y, double z) {
        double[] rotated = pose.rotate(x, y, z);
        into[0] = rotated[0];
        into[1] = rotated[1];
        into[2] = rotated[2];
    }

    @Override
    public void prepare(SolverBody solver) {
        for (int i = 0; i < wheels.size(); i++) {
            wheels.get(i).prepare(solver, ahead, groundSpeed);
        }
    }

    @Override
    public void solve(SolverBody solver) {
        for (int i = 0; i < wheels.size(); i++) {
            wheels.get(i).solve(solver.v);
        }
    }

    /** Turns the wheels and pushes the ground, after jbullet's step. */
    void roll() {
        body.velocities(v);
        body.pushObstacles(impulse, point);
        for (int i = 0; i < wheels.size(); i++) {
            RaycastWheel wheel = wheels.get(i);
            wheel.roll(v);
            wheel.trail(body, groundSpeed);
            if (wheel.reaction(impulse, point)) {
                wheel.getGround().push(impulse, point);
            }
            if (wheel.push(impulse, point)) {
                wheel.getObstacle().wake();
                wheel.getObstacle().push(impulse, point);
            }
        }
    }

    /** See {@link Robot#steer}. */
    void steer(double degrees) {
        if (steering == null) {
            throw new IllegalArgumentException("robot " + body.name + " has no steered wheels: wheel.setSteering(30) makes one");
        }
        steering.steer(degrees);
    }

    /** Whether it has steered wheels that no servo steers. */
    boolean canSteer() {
        return steering != null && steering.isFree();
    }

    /**
     * Steers to a circle, or as far as it can.
     *
     * @param radius metres, + to the left, infinite = straight, 0 = the smallest, to the left with a positive speed
     * @param speed m/s
     */
    void steerTo(double radius, double speed) {
        steering.follow(radius == 0 ? Math.signum(speed) * Double.POSITIVE_INFINITY : 1 / radius);
    }

    /** Degrees, + to the left; 0 without steered wheels. */
    double getSteering() {
        return steering == null ? 0 : steering.getDegrees();
    }

    public List<RaycastWheel> getWheels() {
        return wheels;
    }

    /** Distance of the left from the right driven wheels, metres. */
    double getTrack() {
        return track;
    }

    /** How far before the body's middle the foremost wheel is fastened, metres; 0 without wheels. */
    double getFrontAxle() {
        return frontAxle;
    }

    /** Where the wheels are now in the body frame, spin included; immutable, of no use to the running world. */
    public List<Pose> getWheelPoses() {
        return WheelPoses.of(wheels, mounts, swivels);
    }
}
