// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;

/**
 * Wheel that finds the ground as it moves along its suspension. Its position in the body frame is the suspension's
 * mount; its centre hangs below by up to the rest length. Simulation thread.
 */
public final class RaycastWheel {
    /** Cosine between driving direction and straight ahead below which a wheel measures no distance ahead. */
    private static final double ACROSS = 0.1;

    public final Wheel object;
    /** Scaled radius, metres. */
    public final double radius;
    /** Mount in the body frame, metres. */
    public final double x;
    public final double y;
    public final double z;
    /** Distance along its driving direction per radian, metres. */
    final double reach;
    private final Swivel swivel;
    private final WheelShape shape;
    private final GroundContact ground = new GroundContact();
    private final Suspension suspension;
    private final Grip grip;
    private final Obstacle obstacle = new Obstacle();
    /** Null for balls and casters. */
    private WheelMotor motor;
    private final Vec3 from = new Vec3();
    private final Vec3 lead = new Vec3();
    private double reported;
    private double length;
    private double angle;
    private double spin;
    private double rolled;
    private double seconds;
    private double pending;
    private final WheelErrors errors;
    private final int number;
    /** Ratio of its radius to the nominal one. */
    private final double size;
    private final Rim rim;
    /** x of its centre with the true track, metres. */
    private final double aside;
    /** Rotation that its encoder has counted, radians, and number of counted steps. */
    private double counted;
    private long steps;

    /**
     * @param number of the wheel on its robot
     * @param robot mass of the robot, kg
     */
    RaycastWheel(Wheel wheel, Spring spring, WheelErrors errors, int number, double robot) {
        object = wheel;
        this.errors = errors;
        this.number = number;
        size = wheel.isDriven() ? errors.size(number) : 1;
        radius = wheel.getRadius() * wheel.getScaleY();
        x = wheel.getX();
        y = wheel.getY();
        z = wheel.getZ();
        swivel = Swivel.of(wheel);
        aside = wheel.isDriven() ? x * errors.track() : x;
        reach = size * (swivel == null ? radius : radius * swivel.share());
        shape = new WheelShape(wheel);
        rim = new Rim(wheel, shape, reach, robot);
        motor = rim.mass > 0 ? new FreeWheel() : null;
        suspension = new Suspension(spring);
        grip = new Grip(wheel, wheel.getType() != Wheel.IDLER && (swivel == null || !swivel.isSliding()),
            spring.carried);
        length = spring.rest;
    }

    public boolean isDriven() {
        return object.isDriven();
    }

    void setMotor(WheelMotor newMotor) {
        motor = newMotor;
    }

    /** Motor; null for none. */
    WheelMotor getMotor() {
        return motor instanceof FreeWheel ? null : motor;
    }

    /**
     * Sets the target of a drive command.
     * @param speed over the ground of a wheel of nominal size, m/s, unless its motor has its own command
     * @param part ratio of its speed to that of the robot's middle, as steered
     */
    void follow(double speed, double part) {
        reported = speed;
        if (motor != null) {
            motor.follow(size * speed, part);
        }
    }

    Grip getGrip() {
        return grip;
    }

    /** Direction of the wheel; null if it always points ahead. */
    Swivel getSwivel() {
        return swivel;
    }

    /**
     * Finds ground and obstacle, once per step.
     * @param body the robot's pose
     * @param owner number of the robot, whose parts are neither
     * @param up of the body, world frame, likewise {@code ahead}
     * @param motion of the robot at the start of the step
     * @param coasting speed of the robot without a command, m/s, + forward, 0 at rest
     */
    void look(RaycastScenes scenes, Pose body, int owner, Vec3 up, Vec3 ahead, BodyMotion motion, double coasting) {
        double rest = suspension.rest();
        shape.ahead.set(swivel == null ? ahead : swivel.rolling());
        from.transform(body, centreX(), y, centreZ());
        double down = motion.predict(from, up, lead);
        ground.look(scenes, from, lead, up, shape, rest + Math.max(0, down), length, motion.isDeep(), owner);
        if (ground.touches()) {
            length = Math.max(0, Math.min(rest, ground.seen()));
            grip.setGround(ground.friction(scenes));
        } else {
            length = rest;
            suspension.release();
            grip.release();
        }
        from.transform(body, centreX(), y - length, centreZ());
        obstacle.look(scenes, from, shape.ahead, reported != 0 ? reported : coasting,
            radius, owner);
    }

    /**
     * Sets up the rows of a substep.
     * @param body takes the impulses of the springs
     * @param ahead the body's forward axis in the world, likewise {@code up}
     */
    void prepare(SolverBody body, Vec3 ahead, Vec3 up) {
        feel();
        pending = body.seconds();
        rim.begin(body, up, shape.ahead);
        obstacle.prepare(body);
        if (ground.touches()) {
            ground.prepare(body);
            suspension.prepare(ground, body);
            ground.wedge().prepare(body);
            grip.prepare(ground, swivel == null ? ahead : swivel.driving(), motor != null && motor.holds(), body);
        } else if (motor != null) {
            rim.turnFreely(motor.slipping(rim, 0, pending));
        }
    }

    /**
     * Solves one pass.
     * @param v velocities of the centre of mass, changed
     */
    void solve(double[] v) {
        obstacle.solve(v);
        if (ground.touches()) {
            suspension.solve(v);
            ground.wedge().solve(v, suspension.impulse() * ground.lean());
            grip.solve(motor, rim, v, suspension.impulse(), pending);
        }
    }

    /** Ends the last substep. */
    private void feel() {
        if (pending == 0) {
            return;
        }
        boolean grounded = ground.touches();
        boolean held = grounded && grip.holds();
        if (grounded) {
            grip.feel(radius, pending);
        }
        if (motor != null) {
            double impulse = grounded ? grip.driving() : 0;
            if (grounded) {
                rim.turn(held ? 0 : grip.slips() ? motor.slipping(rim, impulse, pending) : grip.rolling());
            }
            motor.feel(impulse + rim.reaction(), grounded && !held ? grip.rolling() : 0, grounded, pending);
        } else {
            rim.turn(grounded ? grip.rolling() : 0);
        }
        rolled += rim.speed() * pending;
        seconds += pending;
        pending = 0;
    }

    /**
     * Rotates the wheel by the distance rolled in a step, and lets it follow the ground; a caster follows its path.
     * @param body of the robot, after the step; null if it sleeps
     */
    void roll(SolverBody body) {
        if (body == null) {
            rim.rest();
        }
        feel();
        if (ground.touches() && body != null) {
            length = Math.max(0, Math.min(suspension.rest(), ground.reached(body)));
        }
        if (seconds > 0) {
            spin = rolled / seconds / reach;
            angle += rolled / reach;
            counted += errors.counted(number, ++steps) * (rolled / reach);
            if (swivel != null && ground.touches()) {
                swivel.trail(grip.sliding(), grip.rolling());
            }
        }
        rolled = 0;
        seconds = 0;
    }

    /** Obstacle in front of the wheel. */
    public Obstacle getObstacle() {
        return obstacle;
    }

    /** Supporting body; null in the air. */
    public Body getGround() {
        return ground.under();
    }

    /** Body of a second contact, as with a kerb; null for none. */
    Body getSecondGround() {
        return ground.wedge().body();
    }

    public boolean isGrounded() {
        return ground.touches();
    }

    /** Rotation since the start, radians, + forward. */
    public double getAngle() {
        return angle;
    }

    /** Rotation since the start by its encoder, radians, + forward. */
    public double getEncoder() {
        return counted + errors.noise(number, steps);
    }

    /**
     * Distance of the robot straight ahead that corresponds to {@link #getEncoder} at nominal size, metres. NaN if it
     * drives across the robot.
     */
    double getForward() {
        double ahead = swivel == null ? 1 : swivel.ahead();
        return Math.abs(ahead) < ACROSS ? Double.NaN : getEncoder() * reach / size / ahead;
    }

    /** Angular velocity, rad/s, + forward. */
    double getSpin() {
        return spin;
    }

    /** Share of the greatest motor force: 0 to 1 without a {@link MotorDrive}, -1 to 1 with one. */
    public double getLoad() {
        return motor == null ? 0 : motor.load();
    }

    /** Distance of its centre below its mount, metres. */
    public double getLength() {
        return length;
    }

    /** The same without load. */
    public double getRest() {
        return suspension.rest();
    }

    private double centreX() {
        return swivel == null ? aside : swivel.x();
    }

    private double centreZ() {
        return swivel == null ? z : swivel.z();
    }

    /** Pose of the wheel in the body frame, spin included. */
    public Pose place() {
        return swivel == null ? WheelPoses.place(x, y, z, length, angle)
            : WheelPoses.place(swivel.x(), y, swivel.z(), length, angle, swivel.heading());
    }

    /** Transforms the body's frame into the wheel's, spin included. */
    public void place(Frame frame) {
        if (swivel != null) {
            frame.times(place());
            return;
        }
        double half = Math.IEEEremainder(angle, 2 * Math.PI) / 2;
        frame.times(x, y - length, z, Math.sin(half), 0, 0, Math.cos(half));
    }
}
