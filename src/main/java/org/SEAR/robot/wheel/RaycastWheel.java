package org.SEAR.robot.wheel;

import org.SEAR.POJOs.Wheel;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;

/**
 * A wheel that feels the ground with one ray along its suspension, as Bullet's vehicle does: the wheel's place in the body frame is where the
 * suspension is fastened, and the wheel's centre hangs below it by up to the rest length. Simulation thread.
 */
public final class RaycastWheel {
    public final Wheel object;
    /** Metres, scaled. */
    public final double radius;
    /** Where it is fastened in the body frame, metres. */
    public final double x;
    public final double y;
    public final double z;
    /** Metres that it goes along its driving direction for each radian. */
    final double reach;
    private final Swivel swivel;
    private final GroundContact ground = new GroundContact();
    private final Suspension suspension;
    private final Grip grip;
    private final Obstacle obstacle = new Obstacle();
    /** Null if nothing drives it. */
    private WheelMotor motor;
    private final Vec3 from = new Vec3();
    private double reported;
    private double length;
    private double angle;
    private double spin;
    private double rolled;
    private double seconds;
    private double pending;

    RaycastWheel(Wheel wheel, Spring spring) {
        object = wheel;
        radius = wheel.getRadius() * wheel.getScaleY();
        x = wheel.getX();
        y = wheel.getY();
        z = wheel.getZ();
        swivel = Swivel.of(wheel);
        reach = swivel == null ? radius : radius * swivel.share();
        suspension = new Suspension(spring);
        grip = new Grip(wheel, wheel.getType() != Wheel.IDLER && (swivel == null || !swivel.isSliding()), spring.carried);
        length = spring.rest;
    }

    public boolean isDriven() {
        return object.isDriven();
    }

    /** Has a motor turn it. */
    void setMotor(WheelMotor newMotor) {
        motor = newMotor;
    }

    /** What turns it; null for nothing. */
    WheelMotor getMotor() {
        return motor;
    }

    /**
     * What the robot was told.
     *
     * @param speed with which it is to roll over the ground, m/s, unless its motor has an order of its own
     * @param part of the speed of the robot's middle, as it is steered
     */
    void follow(double speed, double part) {
        reported = speed;
        if (motor != null) {
            motor.follow(speed, part);
        }
    }

    /** Its friction. */
    Grip getGrip() {
        return grip;
    }

    /** Where it points; null if that is always ahead. */
    Swivel getSwivel() {
        return swivel;
    }

    /**
     * Looks for ground, and for what stands before it, once a step.
     *
     * @param body the robot's frame
     * @param owner whose parts are neither
     * @param up of the body, world frame, likewise {@code ahead}
     * @param coasting which way the robot moves, if it is not told to: forward if positive, 0 if it stands
     */
    void look(RaycastScenes scenes, Pose body, int owner, Vec3 up, Vec3 ahead, double coasting) {
        double rest = suspension.rest();
        from.transform(body, centreX(), y + radius, centreZ());
        ground.look(scenes, from, up, 2 * radius, rest, owner);
        if (ground.touches()) {
            length = Math.max(0, ground.seen());
            grip.setGround(ground.friction(scenes));
        } else {
            length = rest;
            suspension.release();
            grip.release();
        }
        from.transform(body, centreX(), y - length, centreZ());
        obstacle.look(scenes, from, swivel == null ? ahead : swivel.rolling(), reported != 0 ? reported : coasting, radius, owner);
    }

    /**
     * Makes the rows of a substep.
     *
     * @param body takes what the springs give
     * @param ahead the body's forward axis in the world
     */
    void prepare(SolverBody body, Vec3 ahead) {
        feel();
        pending = body.seconds();
        obstacle.prepare(body);
        if (ground.touches()) {
            ground.prepare(body);
            suspension.prepare(ground, body);
            grip.prepare(ground, swivel == null ? ahead : swivel.driving(), motor != null && motor.holds(), body);
        }
    }

    /**
     * One pass of the solver.
     *
     * @param v velocities of the centre of mass, changed
     */
    void solve(double[] v) {
        obstacle.solve(v);
        if (ground.touches()) {
            suspension.solve(v);
            grip.solve(motor, v, suspension.impulse(), pending);
        }
    }

    /** Takes notice of what the last substep came to. */
    private void feel() {
        if (pending == 0) {
            return;
        }
        boolean grounded = ground.touches();
        double speed = grounded && !grip.holds() ? grip.rolling() : 0;
        if (grounded) {
            grip.feel(radius, pending);
        }
        if (motor != null) {
            double impulse = grounded ? grip.driving() : 0;
            motor.feel(impulse, speed, grounded, pending);
            speed = grounded && !grip.slips() ? speed : motor.slipping(impulse / pending);
        }
        rolled += speed * pending;
        seconds += pending;
        pending = 0;
    }

    /** Turns the wheel by what it rolled in a step; a caster follows its way. */
    void roll() {
        feel();
        if (seconds > 0) {
            spin = rolled / seconds / reach;
            angle += rolled / reach;
            if (swivel != null && ground.touches()) {
                swivel.trail(grip.sliding(), grip.rolling());
            }
        }
        rolled = 0;
        seconds = 0;
    }

    /** What stands before the wheel. */
    public Obstacle getObstacle() {
        return obstacle;
    }

    /** The body the wheel stands on; null in the air. */
    public Body getGround() {
        return ground.under();
    }

    public boolean isGrounded() {
        return ground.touches();
    }

    /** Radians turned since the start, + forward. */
    public double getAngle() {
        return angle;
    }

    /** How fast it turns, rad/s, + forward. */
    double getSpin() {
        return spin;
    }

    /** Share of the greatest motor force: 0 to 1 without a {@link MotorDrive}, -1 to 1 with one. */
    public double getLoad() {
        return motor == null ? 0 : motor.load();
    }

    /** How far its centre hangs below where it is fastened, metres. */
    public double getLength() {
        return length;
    }

    /** The same when nothing presses it. */
    public double getRest() {
        return suspension.rest();
    }

    private double centreX() {
        return swivel == null ? x : swivel.x();
    }

    private double centreZ() {
        return swivel == null ? z : swivel.z();
    }

    /** Where the wheel is in the body frame, spin included. */
    public Pose place() {
        return swivel == null ? WheelPoses.place(x, y, z, length, angle)
            : WheelPoses.place(swivel.x(), y, swivel.z(), length, angle, swivel.heading());
    }

    /** Turns the body's frame into the wheel's, spin included. */
    public void place(Frame frame) {
        if (swivel != null) {
            frame.times(place());
            return;
        }
        double half = Math.IEEEremainder(angle, 2 * Math.PI) / 2;
        frame.times(x, y - length, z, Math.sin(half), 0, 0, Math.cos(half));
    }
}
