// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.servo;

import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.POJOs.Servo;
import org.SEAR.devices.ServoHardware;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Rotation;
import org.SEAR.geometry.TimeStep;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.solid.Hinge;
import org.SEAR.project.ObjectPose;

/**
 * Servo that turns to a commanded angle. Its motor has the linear characteristic of a small DC motor: torque =
 * stallTorque (power - speed / no-load speed). It drives at full power and brakes in time; without load it reaches full
 * speed immediately. While turning it yields to contacts; once there it holds its angle. Simulation thread.
 */
public final class ServoDrive implements ServoHardware {
    /** Share of the no-load speed below which a servo counts as stalled. */
    private static final double STALLED = 0.01;
    /** Share of the torque used for braking, which leaves a reserve. */
    private static final double BRAKING = 0.99;
    /** Share of the unobstructed motion below which a servo is blocked, and for how many steps before SEAR warns. */
    private static final double HELD = 0.1;
    private static final int HELD_FOR = 60;
    /** Angle within which a loaded servo has arrived, degrees, as in real ones; otherwise it would jitter. */
    private static final double DEAD_BAND = 0.05;

    private final Servo object;
    private final String robot;
    private final Consumer<String> reported;
    private final Pose axis;
    private final ServoLoad load = new ServoLoad();
    private final Hinge hinge;
    private final Rotation rotation = new Rotation();
    private final DeadTime delay;
    /** Last command, and the one that takes effect, degrees. */
    private double commanded;
    private double due;
    private double wanted;
    private double angle;
    /** Angle of the parts, which follow the motor with play, degrees. */
    private double horn;
    /** Speed of a servo with load, rad/s. */
    private double spin;
    /** Angle when the step began, degrees, and whether it turns in the step. */
    private double before;
    private boolean turns;
    /** Number of steps for which it has been blocked. */
    private int held;
    private boolean complained;

    /** @param told takes, once per run, a warning about a load that is too heavy */
    public ServoDrive(Servo object, String robot, Consumer<String> told) {
        this.object = object;
        this.robot = robot;
        this.reported = told;
        this.axis = ObjectPose.of(object);
        hinge = new Hinge();
        delay = new DeadTime(object.getDelay());
        restart();
    }

    /** Moves the servo to its start: 0 degrees, or the nearest legal angle. */
    public void restart() {
        wanted = Math.max(object.getMinAngle(), Math.min(object.getMaxAngle(), 0));
        angle = wanted;
        horn = wanted;
        commanded = wanted;
        due = wanted;
        delay.restart(wanted);
        spin = 0;
        turns = false;
        held = 0;
        hinge.restart();
        complained = false;
    }

    /** Load, to be filled and placed by the caller. */
    public ServoLoad getLoad() {
        return load;
    }

    @Override
    public String getName() {
        return object.getName();
    }

    @Override
    public void setAngle(double degrees) {
        if (!(degrees >= object.getMinAngle() && degrees <= object.getMaxAngle())) {
            throw new IllegalArgumentException("servo " + object.getName() + " of robot " + robot + ": angle is "
                + degrees + ", legal: "
                + Parameter.format(object.getMinAngle()) + " to " + Parameter.format(object.getMaxAngle()) + " deg");
        }
        commanded = degrees;
        if (!delay.isUsed()) {
            wanted = degrees;
        }
    }

    /**
     * Turns for one step.
     * @param body pose of the robot in the world
     * @param gravity m/s^2
     * @param at pose of the servo in the body frame
     * @return whether the angle changed
     */
    public boolean step(Pose body, double gravity, Pose at) {
        before = angle;
        double hornBefore = horn;
        command();
        held = hinge.ahead() == 0 ? 0 : held;
        double was = spin;
        double moment = 0;
        if (!load.isEmpty()) {
            rotation.set(body);
            moment = turnLoad(rotation.inX(0, -gravity, 0), rotation.inY(0, -gravity, 0), rotation.inZ(0, -gravity, 0));
        } else if (angle != wanted) {
            double most = object.getSpeed() * TimeStep.SECONDS;
            angle = Math.abs(wanted - angle) <= most ? wanted : angle + Math.copySign(most, wanted - angle);
        }
        follow();
        turns = horn != hornBefore;
        if (turns) {
            double turning = Math.toRadians(horn - hornBefore);
            double fastest = Math.toRadians(object.getSpeed());
            double accelerating = load.isEmpty() ? 0 : load.inertia() * (spin - was) / TimeStep.SECONDS;
            hinge.plan(at, object.getStallTorque(), fastest, load.inertia(), turning,
                turning / TimeStep.SECONDS / fastest + (accelerating - moment) / object.getStallTorque());
        }
        return turns;
    }

    private void command() {
        double now = delay.isUsed() ? delay.pass(commanded) : due;
        if (now != due) {
            due = now;
            wanted = now;
        }
    }

    /** Moves the parts with the motor. */
    private void follow() {
        horn = Math.max(angle - object.getPlay() / 2, Math.min(angle + object.getPlay() / 2, horn));
    }

    /** Corrects the angle if a contact stopped this servo in the step. */
    public void giveWay() {
        if (hinge.ahead() == 0) {
            return;
        }
        double to = angle + Math.toDegrees(hinge.ahead());
        horn += Math.toDegrees(hinge.ahead());
        held = Math.abs(to - wanted) > DEAD_BAND && Math.abs(to - before) < HELD * Math.abs(angle - before)
            ? held + 1 : 0;
        if (held == HELD_FOR && !complained) {
            complained = true;
            reported.accept(String.format(Locale.ROOT, "servo %s of robot %s is blocked at %.1f deg, on its way to "
                + "%.1f deg, by a contact, as a"
                + " gripper is by its object. If it should move on, give it more than its stallTorque of %s N m "
                + "(%s.setStallTorque(...))",
                object.getName(), robot, to, wanted, Parameter.format(object.getStallTorque()), object.getName()));
        }
        angle = Math.max(object.getMinAngle(), Math.min(object.getMaxAngle(), to));
        spin = load.isEmpty() || angle != to ? 0 : spin + hinge.deviation();
        if (Math.abs(angle - wanted) < DEAD_BAND) {
            wanted = angle;
            spin = 0;
        }
        follow();
    }

    /** Its hinge if it turns in this step; else null. */
    public Hinge getHinge() {
        return turns ? hinge : null;
    }

    private double turnLoad(double gx, double gy, double gz) {
        double moment = load.moment(gx, gy, gz);
        double way = Math.toRadians(wanted - angle);
        double ahead = Math.signum(way);
        if (way != 0 && ahead * moment < (STALLED - 1) * object.getStallTorque()) {
            complain(moment, load.greatest(gx, gy, gz));
        }
        double fastest = Math.toRadians(object.getSpeed());
        double settling = load.inertia() * fastest / object.getStallTorque();
        double decay = settling > 0 ? Math.exp(-TimeStep.SECONDS / settling) : 0;
        double least = reached(-1, moment, decay);
        double most = reached(1, moment, decay);
        double loss = BRAKING * fastest * (1 - ahead * moment / object.getStallTorque()) * (1 - decay);
        double allowed = ahead * Math.min(fastest, approach(Math.abs(way) / TimeStep.SECONDS, loss));
        double next = Math.max(least, Math.min(most, allowed));
        double turned = next * TimeStep.SECONDS;
        if (next != allowed) {
            double end = steady(next == most ? 1 : -1, moment);
            turned = end * TimeStep.SECONDS + (spin - end) * settling * (1 - decay);
        }
        spin = next;
        move(turned, next == allowed && Math.abs(way) <= Math.abs(turned));
        return moment;
    }

    private void move(double turned, boolean arrives) {
        double to = arrives ? wanted : angle + Math.toDegrees(turned);
        angle = Math.max(object.getMinAngle(), Math.min(object.getMaxAngle(), to));
        if (angle != to) {
            spin = 0;
        }
    }

    /** Returns the final speed, rad/s. */
    private double steady(double power, double moment) {
        return Math.toRadians(object.getSpeed()) * (power + moment / object.getStallTorque());
    }

    /** Returns the speed after a step, rad/s. */
    private double reached(double power, double moment, double decay) {
        double end = steady(power, moment);
        return end + (spin - end) * decay;
    }

    /**
     * Returns the greatest speed from which it can still stop, rad/s, in the fewest steps with the same loss each.
     * @param within speed that reaches the target in one step, rad/s
     * @param loss smallest loss of speed per step by its torque, rad/s
     */
    private static double approach(double within, double loss) {
        if (loss <= 0) {
            return 0;
        }
        double steps = Math.max(1, Math.ceil((Math.sqrt(1 + 8 * within / loss) - 1) / 2));
        return within / steps + loss * (steps - 1) / 2;
    }

    private void complain(double moment, double greatest) {
        if (!complained) {
            complained = true;
            reported.accept(String.format(Locale.ROOT,
                "servo %s of robot %s is too weak to turn its load to %.1f deg: at %.1f deg the weight pulls with"
                + " %.3g N m, and its stallTorque is %s N m. Give it more than %.3g N m, the most it needs "
                + "(%s.setStallTorque(...)), or"
                + " mount less, nearer to its axis", object.getName(), robot, wanted, angle, Math.abs(moment),
                Parameter.format(object.getStallTorque()), greatest, object.getName()));
        }
    }

    /** Returns its rotation about its axis, in the frame of its own mount. */
    public Pose turn() {
        double half = Math.toRadians(horn) / 2;
        double[] along = axis.rotate(0, Math.sin(half), 0);
        Pose turned = new Pose(0, 0, 0, along[0], along[1], along[2], Math.cos(half));
        double[] moved = turned.rotate(axis.x, axis.y, axis.z);
        return new Pose(axis.x - moved[0], axis.y - moved[1], axis.z - moved[2], turned.qx, turned.qy,
            turned.qz, turned.qw);
    }

    @Override
    public double getAngle() {
        return angle;
    }

    /** Angle of the parts that it turns, degrees. */
    public double getHornAngle() {
        return horn;
    }

    @Override
    public double getMinAngle() {
        return object.getMinAngle();
    }

    @Override
    public double getMaxAngle() {
        return object.getMaxAngle();
    }
}
