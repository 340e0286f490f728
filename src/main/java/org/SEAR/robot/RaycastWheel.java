package org.SEAR.robot;

import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.Scenes;
import org.SEAR.physics.SolverBody;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;

/**
 * A wheel that feels the ground with one ray along its suspension, as Bullet's vehicle does: the wheel's place in the body frame is where the
 * suspension is fastened, and the wheel's centre hangs below it by up to the rest length. Springs are solved implicitly, so any stiffness is stable.
 * Simulation thread.
 */
public final class RaycastWheel {
    /** Coefficient of friction of a rubber wheel on a dry floor. */
    private static final double GRIP = 1;
    /** Friction of a wheel's tread along what blocks it, level: else a robot that pushes against a wall would turn off it. */
    private static final double OBSTACLE_GRIP = 0.3;
    private static final double LEAST_LEVEL = 0.1;
    /** Ground that leans more than this (cosine of the angle to the suspension) is a wall and carries no wheel. */
    private static final double STEEPEST = 0.35;
    /** Share of the depth beyond the stop that is corrected in a step. */
    private static final double CORRECTION = 0.2;
    private static final double HALF_TURN = Math.PI;
    /** A motor that has stalled this long, seconds, gets less current, as motor controllers do, down to this share of its force. */
    private static final double STALL_TIME = 0.25;
    private static final double STALL_SHARE = 0.05;
    /** How much slower the force comes back when the wheel turns again. */
    private static final double RECOVERY = 0.25;
    /** How much later than its guard the wheel itself stops at something high, metres: the guard feels it, and the wheel stops at a step. */
    private static final double BEHIND_GUARD = 1e-3;
    /** A wheel slower than this share of what it is told to do has stalled. */
    private static final double STALLED = 0.5;
    /** And slower than this, m/s. */
    private static final double STANDING = 0.03;

    public final Wheel object;
    final double radius;
    final double x;
    final double y;
    final double z;
    private final double stiffness;
    private final double compressing;
    private final double releasing;
    private final double mostForce;
    private final double rest;
    private final Swivel swivel;
    /** Metres that it goes along its driving direction for each radian. */
    private final double reach;
    private final ConstraintRow spring = new ConstraintRow();
    private final ConstraintRow stop = new ConstraintRow();
    private final ConstraintRow forward = new ConstraintRow();
    private final ConstraintRow side = new ConstraintRow();
    private final ConstraintRow block = new ConstraintRow();
    private final ConstraintRow slide = new ConstraintRow();
    private final Hit hit = new Hit();
    private final Hit ahead = new Hit();
    private Body obstacle;
    private double room;
    private double wx;
    private double wy;
    private double wz;
    private double groundPush;
    private double groundSlide;
    private double stalled;
    private final double[] speedOfObstacle = new double[3];
    private double softness;
    private double bias;
    private double gap;
    private double sideGrip = GRIP;
    private double scrub;
    private double groundForward;
    private double groundSide;
    private double groundUp;
    private double motorImpulse;
    private MotorDrive motor;
    private double spin;
    private double target;
    private boolean geared;
    private boolean grounded;
    private Body under;
    private double length;
    private double angle;
    private double load;
    private double px;
    private double py;
    private double pz;

    /** @param mass of the robot, kg */
    RaycastWheel(Wheel wheel, Dynamics dynamics, double mass) {
        object = wheel;
        radius = wheel.getRadius() * wheel.getScaleY();
        x = wheel.getX();
        y = wheel.getY();
        z = wheel.getZ();
        swivel = Swivel.of(wheel);
        reach = swivel == null ? radius : radius * swivel.share();
        stiffness = dynamics.getStiffness() * mass;
        double critical = 2 * Math.sqrt(dynamics.getStiffness()) * mass;
        compressing = dynamics.getCompression() * critical;
        releasing = dynamics.getDamping() * critical;
        mostForce = dynamics.getMaxSuspensionForce();
        rest = dynamics.getRestLength();
        length = rest;
    }

    boolean isDriven() {
        return object.isDriven();
    }

    /**
     * @param force greatest force of the wheel's motor, N; 0 for an idler
     * @param sideways coefficient of friction across
     */
    void equip(double force, double sideways) {
        motorImpulse = force * TimeStep.SECONDS;
        sideGrip = sideways;
    }

    /** Where it points; null if that is always ahead. */
    Swivel getSwivel() {
        return swivel;
    }

    /** Has a motor turn it instead of a servo. */
    void setMotor(MotorDrive newMotor) {
        motor = newMotor;
    }

    /** The speed over ground that the servo is to reach, m/s. */
    void setTarget(double speed) {
        if (speed * target <= 0) {
            stalled = 0;
        }
        target = speed;
    }

    /** @param on whether gears hold the wheel where its motor alone is too weak */
    void setGeared(boolean on) {
        geared = on;
    }

    /** @param speed that the wheel gains across for each Ns of side force, m/s per Ns: it scrubs while a skid-steered robot turns; else 0 */
    void setScrub(double speed) {
        scrub = speed;
    }

    /**
     * Looks for something steep before the wheel at the height of its axle: it can't roll up that.
     *
     * @param along the forward axis in the world, or backwards when it rolls back
     */
    void lookAhead(Scenes scenes, Pose body, int owner, double[] along, double sign) {
        obstacle = null;
        if (sign == 0) {
            return;
        }
        double[] from = body.transform(centreX(), y - length, centreZ());
        double[] way = swivel == null ? along : swivel.rolling();
        double dx = sign * way[0];
        double dy = sign * way[1];
        double dz = sign * way[2];
        double distance = scenes.ground.cast(from[0], from[1], from[2], dx, dy, dz, 2 * radius, owner, ahead);
        if (distance >= 2 * radius) {
            return;
        }
        double facing = -(dx * ahead.nx + dy * ahead.ny + dz * ahead.nz);
        if (facing <= 0 || Math.abs(ahead.ny) > STEEPEST) {
            return;
        }
        obstacle = scenes.body(ahead.shape);
        double reach = RobotBuilder.GUARD * radius - BEHIND_GUARD;
        room = distance * facing - reach;
        wx = from[0] - ahead.nx * reach;
        wy = from[1] - ahead.ny * reach;
        wz = from[2] - ahead.nz * reach;
    }

    /**
     * Looks for ground.
     *
     * @param body the robot's frame
     * @param owner whose parts are not ground
     */
    void look(Scenes scenes, Pose body, int owner, double[] up) {
        double sx = centreX();
        double sy = y + radius;
        double sz = centreZ();
        double[] from = body.transform(sx, sy, sz);
        double range = 2 * radius + rest;
        BeamScene scene = scenes.ground;
        double distance = scene.cast(from[0], from[1], from[2], -up[0], -up[1], -up[2], range, owner, hit);
        grounded = distance < range;
        double lean = hit.nx * up[0] + hit.ny * up[1] + hit.nz * up[2];
        if (grounded && lean < 0) {
            hit.nx = -hit.nx;
            hit.ny = -hit.ny;
            hit.nz = -hit.nz;
            lean = -lean;
        }
        grounded &= lean > STEEPEST;
        length = grounded ? Math.max(0, distance - 2 * radius) : rest;
        gap = distance - 2 * radius;
        under = grounded ? scenes.body(hit.shape) : null;
        px = from[0] - up[0] * distance;
        py = from[1] - up[1] * distance;
        pz = from[2] - up[2] * distance;
        if (!grounded) {
            spring.impulse = 0;
            stop.impulse = 0;
            forward.impulse = 0;
            side.impulse = 0;
        }
    }

    /**
     * Makes the rows of this step. The springs' impulses of the last one are the first guess; grip starts from nothing, because what several
     * wheels hold against each other would never fade.
     *
     * @param body takes what the springs give
     * @param forwards the body's forward axis in the world
     * @param groundSpeed room for three numbers
     */
    void prepare(SolverBody body, double[] forwards, double[] groundSpeed) {
        if (obstacle != null) {
            prepareObstacle(body);
        }
        if (!grounded) {
            return;
        }
        speedOfGround(groundSpeed);
        spring.set(hit.nx, hit.ny, hit.nz, px, py, pz, body);
        stop.set(hit.nx, hit.ny, hit.nz, px, py, pz, body);
        double[] way = swivel == null ? forwards : swivel.driving();
        double along = way[0] * hit.nx + way[1] * hit.ny + way[2] * hit.nz;
        double fx = way[0] - along * hit.nx;
        double fy = way[1] - along * hit.ny;
        double fz = way[2] - along * hit.nz;
        double scale = 1 / Math.sqrt(fx * fx + fy * fy + fz * fz);
        fx *= scale;
        fy *= scale;
        fz *= scale;
        forward.set(fx, fy, fz, px, py, pz, body);
        side.set(hit.ny * fz - hit.nz * fy, hit.nz * fx - hit.nx * fz, hit.nx * fy - hit.ny * fx, px, py, pz, body);
        groundForward = groundSpeed[0] * fx + groundSpeed[1] * fy + groundSpeed[2] * fz;
        groundSide = groundSpeed[0] * side.dx() + groundSpeed[1] * side.dy() + groundSpeed[2] * side.dz();
        groundUp = groundSpeed[0] * hit.nx + groundSpeed[1] * hit.ny + groundSpeed[2] * hit.nz;
        double damping = spring.speed(body.v) - groundUp < 0 ? compressing : releasing;
        double soft = damping + TimeStep.SECONDS * stiffness;
        softness = soft > 0 ? 1 / (TimeStep.SECONDS * soft) : 0;
        bias = soft > 0 ? stiffness * Math.min(rest, rest - gap) / soft : 0;
        spring.push(body.v, spring.impulse);
        stop.push(body.v, stop.impulse);
        forward.impulse = 0;
        side.impulse = 0;
    }

    private void prepareObstacle(SolverBody body) {
        block.set(ahead.nx, ahead.ny, ahead.nz, wx, wy, wz, body);
        block.impulse = 0;
        double level = Math.max(Math.hypot(ahead.nx, ahead.nz), LEAST_LEVEL);
        slide.set(ahead.nz / level, 0, -ahead.nx / level, wx, wy, wz, body);
        slide.impulse = 0;
        groundPush = 0;
        groundSlide = 0;
        if (!obstacle.isFixed()) {
            obstacle.velocityAt(wx, wy, wz, speedOfObstacle);
            groundPush = ahead.nx * speedOfObstacle[0] + ahead.ny * speedOfObstacle[1] + ahead.nz * speedOfObstacle[2];
            groundSlide = slide.dx() * speedOfObstacle[0] + slide.dy() * speedOfObstacle[1] + slide.dz() * speedOfObstacle[2];
        }
    }

    /**
     * What can move gives way as it is pushed. The grip across is not given to it: that would be a speed of its own in the next step, before the
     * floor has held it, and the wheel would follow instead of standing.
     */
    private void solveObstacle(double[] v) {
        double allowed = room > 0 ? -room / TimeStep.SECONDS : -CORRECTION * room / TimeStep.SECONDS;
        double yielding = obstacle.isFixed() ? 0 : 1 / obstacle.mass;
        double apart = block.speed(v) - groundPush + yielding * block.impulse;
        block.add(v, (allowed - apart) / (block.mobility + yielding), 0, Double.POSITIVE_INFINITY);
        double hold = OBSTACLE_GRIP * block.impulse;
        slide.add(v, -(slide.speed(v) - groundSlide) / slide.mobility, -hold, hold);
    }

    /**
     * One iteration of the solver.
     *
     * @param v velocities of the centre of mass, changed
     */
    void solve(double[] v) {
        if (obstacle != null) {
            solveObstacle(v);
        }
        if (!grounded) {
            return;
        }
        if (softness > 0) {
            double error = spring.speed(v) - groundUp - bias + softness * spring.impulse;
            spring.add(v, -error / (spring.mobility + softness), 0, mostForce * TimeStep.SECONDS);
        }
        double allowed = gap > 0 ? -gap / TimeStep.SECONDS : -CORRECTION * gap / TimeStep.SECONDS;
        stop.add(v, -(stop.speed(v) - groundUp - allowed) / stop.mobility, 0, Double.POSITIVE_INFINITY);
        if (isDriven()) {
            double grip = GRIP * (spring.impulse + stop.impulse);
            if (motor == null) {
                solveServo(v, grip);
            } else {
                motor.solve(forward, v, forward.speed(v) - groundForward, target, reach, grip);
            }
        }
        if (object.getType() != Wheel.IDLER && !slides()) {
            double mostSide = sideGrip * (spring.impulse + stop.impulse);
            side.add(v, -(side.speed(v) - groundSide + scrub * side.impulse) / (side.mobility + scrub), -mostSide, mostSide);
        }
    }

    /**
     * The servo drives the wheel towards its target with the force that it has; the gears hold it with all that the tyre can: it neither rolls back
     * nor coasts on.
     */
    private void solveServo(double[] v, double grip) {
        double rolling = forward.speed(v) - groundForward;
        double motor = Math.min(grip, motorImpulse * strength());
        double least = -motor;
        double most = motor;
        if (geared) {
            double standing = forward.impulse - rolling / forward.mobility;
            least = target < 0 ? -Math.min(grip, Math.max(motor, -standing)) : -grip;
            most = target > 0 ? Math.min(grip, Math.max(motor, standing)) : grip;
        }
        forward.add(v, (target - rolling) / forward.mobility, least, most);
    }

    /**
     * Turns the wheel by what it rolled in this step.
     *
     * @param v velocities of the centre of mass after it
     */
    void roll(double[] v) {
        double speed = motor == null ? rollByServo(v) : rollByMotor(v);
        spin = speed / reach;
        angle += speed * TimeStep.SECONDS / reach;
    }

    private double rollByMotor(double[] v) {
        double force = grounded ? forward.impulse / TimeStep.SECONDS : 0;
        boolean slips = !grounded || Math.abs(forward.impulse) >= GRIP * (spring.impulse + stop.impulse);
        load = Math.max(-1, Math.min(1, force / motor.stall(reach)));
        return slips ? motor.slipping(force, target, reach) : forward.speed(v) - groundForward;
    }

    private double rollByServo(double[] v) {
        double speed = target;
        load = 0;
        if (grounded) {
            double rolled = forward.speed(v) - groundForward;
            double grip = GRIP * (spring.impulse + stop.impulse);
            double motor = motorImpulse * strength();
            boolean slips = isDriven() && Math.abs(forward.impulse) >= grip;
            speed = slips ? target : rolled;
            load = motor > 0 ? Math.min(1, Math.abs(forward.impulse) / motor) : 0;
            boolean stands = rolled * Math.signum(target) < Math.min(STALLED * Math.abs(target), STANDING);
            stalled = isDriven() && target != 0 && stands ? Math.min(stalled + TimeStep.SECONDS, 2 * STALL_TIME)
                : Math.max(0, stalled - RECOVERY * TimeStep.SECONDS);
        } else if (!isDriven()) {
            speed = 0;
        }
        return speed;
    }

    /** Share of the motor's force that its controller allows now. */
    private double strength() {
        return Math.max(STALL_SHARE, Math.min(1, 2 - stalled / STALL_TIME));
    }

    /** Gives a movable obstacle its push, with the arguments of {@link #reaction}. */
    boolean push(double[] impulse, double[] at) {
        if (obstacle == null || obstacle.isFixed() || block.impulse == 0) {
            return false;
        }
        impulse[0] = -block.dx() * block.impulse;
        impulse[1] = -block.dy() * block.impulse;
        impulse[2] = -block.dz() * block.impulse;
        at[0] = wx;
        at[1] = wy;
        at[2] = wz;
        return true;
    }

    /**
     * Gives the ground, if it can move, what it takes to carry the wheel.
     *
     * @param impulse takes {x, y, z}, Ns
     * @param at takes the point
     */
    boolean reaction(double[] impulse, double[] at) {
        if (!grounded || under.isFixed()) {
            return false;
        }
        double normal = spring.impulse + stop.impulse;
        impulse[0] = -(hit.nx * normal + forward.dx() * forward.impulse + side.dx() * side.impulse);
        impulse[1] = -(hit.ny * normal + forward.dy() * forward.impulse + side.dy() * side.impulse);
        impulse[2] = -(hit.nz * normal + forward.dz() * forward.impulse + side.dz() * side.impulse);
        at[0] = px;
        at[1] = py;
        at[2] = pz;
        return true;
    }

    /**
     * Velocity of the ground under the wheel, m/s.
     *
     * @param into takes {x, y, z}
     */
    private void speedOfGround(double[] into) {
        into[0] = 0;
        into[1] = 0;
        into[2] = 0;
        if (grounded && !under.isFixed()) {
            under.velocityAt(px, py, pz, into);
        }
    }

    /** What stands before the wheel; null if nothing does. */
    Body getObstacle() {
        return obstacle;
    }

    /** The speed over ground that the servo is to reach, m/s. */
    double getTarget() {
        return target;
    }

    /** The body the wheel stands on; null in the air. */
    Body getGround() {
        return under;
    }

    boolean isGrounded() {
        return grounded;
    }

    /** Radians turned since the start, + forward. */
    double getAngle() {
        return angle;
    }

    /** How fast it turns, rad/s, + forward. */
    double getSpin() {
        return spin;
    }

    /** Share of the greatest motor force: 0 to 1 of a servo, -1 to 1 of a motor. */
    double getLoad() {
        return load;
    }

    /** Where the wheel is in the body frame, spin included. */
    public Pose place() {
        return swivel == null ? place(x, y, z, length, angle) : place(swivel.x(), y, swivel.z(), length, angle, swivel.heading());
    }

    private boolean slides() {
        return swivel != null && swivel.isSliding();
    }

    private double centreX() {
        return swivel == null ? x : swivel.x();
    }

    private double centreZ() {
        return swivel == null ? z : swivel.z();
    }

    /** The same for a wheel that points to the left of ahead by a heading, radians. Any thread. */
    static Pose place(double x, double y, double z, double hanging, double turned, double heading) {
        double half = Math.IEEEremainder(turned, 2 * HALF_TURN) / 2;
        double sin = Math.sin(heading / 2);
        double cos = Math.cos(heading / 2);
        return new Pose(x, y - hanging, z, cos * Math.sin(half), sin * Math.cos(half), -sin * Math.sin(half), cos * Math.cos(half));
    }

    /** Where a wheel that is fastened at (x, y, z) is when it hangs this far, metres, and has turned this much, radians. Any thread. */
    static Pose place(double x, double y, double z, double hanging, double turned) {
        double half = Math.IEEEremainder(turned, 2 * HALF_TURN) / 2;
        return new Pose(x, y - hanging, z, Math.sin(half), 0, 0, Math.cos(half));
    }

    /**
     * A castor follows the way of its axis.
     *
     * @param body the robot's, after a step
     * @param speed room for three numbers
     */
    void trail(Body body, double[] speed) {
        if (swivel == null || !grounded || object.getTrail() == 0) {
            return;
        }
        Pose pose = body.getPose();
        double[] axis = pose.transform(x, y, z);
        body.velocityAt(axis[0], axis[1], axis[2], speed);
        double[] inBody = pose.rotateBack(speed[0], speed[1], speed[2]);
        body.angularVelocity(speed);
        swivel.trail(inBody[0], inBody[2], pose.rotateBack(speed[0], speed[1], speed[2])[1]);
    }

    /** Turns the body's frame into the wheel's, spin included. */
    void place(Frame frame) {
        if (swivel != null) {
            frame.times(place());
            return;
        }
        double half = Math.IEEEremainder(angle, 2 * HALF_TURN) / 2;
        frame.times(x, y - length, z, Math.sin(half), 0, 0, Math.cos(half));
    }

    /** How far its centre hangs below where it is fastened, metres. */
    double getLength() {
        return length;
    }
}
