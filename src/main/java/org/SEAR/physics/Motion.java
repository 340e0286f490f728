package org.SEAR.physics;

import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.linearmath.Transform;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ManifoldClipper;

/**
 * How a body moves within one step: along a straight line from where it is, for as long as nothing is in its way. The path is counted in shares of
 * the step: 0 where the body is now, 1 where it would be at the end. Simulation thread.
 */
final class Motion {
    /** What moves less than this in a step is seen by the contacts before it touches, metres: they look twice as far. */
    private static final float SLOW = ManifoldClipper.BREAKING / 2;
    /** The same for what bounces: contacts would brake it before it touches. */
    private static final float SLOW_BOUNCING = 0.0025f;
    /** A body owes no more than this much of its time, in steps. */
    private static final float MOST_OWED = 2;

    /** Normals whose cosine is greater are the same. */
    private static final float SAME = 0.9999f;

    private final RigidBody rigid;
    private final float reach;
    private final boolean bounces;
    private final Vector3f linear = new Vector3f();
    private final Vector3f angular = new Vector3f();
    private final Transform now = new Transform();
    private boolean fast;
    private boolean touches;
    private boolean bounced;
    private boolean carried;
    private boolean flies;
    private float time;
    private float owed;
    /** What the way is longer than the velocity says, metres. */
    private final Vector3f shift = new Vector3f();
    private final Vector3f before = new Vector3f();
    private final Vector3f normal = new Vector3f();
    private boolean oneNormal;
    private float end;
    private int stops;
    private boolean bounceAhead;
    private final Transform then = new Transform();
    private float thenShare;
    private final Turning turning = new Turning();
    private boolean started;

    /**
     * @param reach distance of the body's farthest point from its centre of mass, metres
     * @param bounces whether it has a restitution
     */
    Motion(RigidBody rigid, double reach, boolean bounces) {
        this.rigid = rigid;
        this.reach = (float) reach;
        this.bounces = bounces;
    }

    /** Looks at the velocities before the contacts are known, gravity included. */
    void predict(float step) {
        rigid.getLinearVelocity(linear);
        rigid.getAngularVelocity(angular);
        rigid.getCenterOfMassTransform(now);
        fast = (linear.length() + angular.length() * reach) * step > (bounces ? SLOW_BOUNCING : SLOW);
        touches = false;
        bounced = false;
        oneNormal = true;
    }

    /** Whether it may move so far in this step that contacts don't see what is in its way. */
    boolean isFast() {
        return fast;
    }

    /** Widens the box around the body by the way that it may go in the step. */
    void widen(Vector3f low, Vector3f high, float step) {
        float turn = (float) Math.min(angular.length() * step, Math.PI) * reach;
        low.set(low.x + Math.min(0, linear.x * step) - turn, low.y + Math.min(0, linear.y * step) - turn,
            low.z + Math.min(0, linear.z * step) - turn);
        high.set(high.x + Math.max(0, linear.x * step) + turn, high.y + Math.max(0, linear.y * step) + turn,
            high.z + Math.max(0, linear.z * step) + turn);
    }

    /**
     * Says that contacts hold the body.
     *
     * @param bounce whether one of them throws it back
     * @param along their normal, either way
     */
    void touch(boolean bounce, Vector3f along) {
        if (touches) {
            oneNormal = oneNormal && Math.abs(normal.dot(along)) > SAME;
        }
        normal.set(along);
        touches = true;
        bounced |= bounce;
    }

    /** Whether contacts held the body in the last step. */
    boolean isTouching() {
        return touches;
    }

    /** Says whether wheels on the ground carry the body. */
    void setCarried(boolean on) {
        carried = on;
    }

    /** Plans the step's way when the contacts are solved. */
    void plan(float step, float gravity) {
        rigid.getLinearVelocity(linear);
        rigid.getAngularVelocity(angular);
        rigid.getCenterOfMassTransform(now);
        flies = bounced || !touches && !carried;
        time = bounced ? step + owed : step;
        owed = 0;
        shift.set(0, 0, 0);
        if (flies) {
            // the velocity holds the whole step's gravity, but for what has bounced, which falls from now on
            shift.y = bounced ? -gravity * time * time / 2 : gravity * step * step / 2;
        } else if (touches && oneNormal && !carried) {
            // along the surface the velocity has changed evenly during the step
            shift.sub(before, linear);
            shift.scaleAdd(-shift.dot(normal), normal, shift);
            shift.scale(step / 2);
        }
        end = 1;
        stops = 0;
        thenShare = 0;
        started = false;
        bounceAhead = false;
        float way = (linear.length() + angular.length() * reach) * time;
        if (!fast && way > SLOW) {
            end = SLOW / way;
        }
    }

    /** Where the centre of mass is after a share of the step. */
    void at(float share, Transform into) {
        float part = Math.min(share, end);
        if (part == 0) {
            into.set(now);
            return;
        }
        if (part != thenShare) {
            if (!started) {
                turning.start(now.basis);
                started = true;
            }
            turning.turn(angular, part * time, then);
            then.origin.scaleAdd(part * time, linear, now.origin);
            then.origin.scaleAdd(part, shift, then.origin);
            thenShare = part;
        }
        into.set(then);
    }

    /** Where the centre of mass is before the contacts are solved. */
    Transform start() {
        return now;
    }

    /** How far it moves along a direction in the whole step, metres; 0 from where it stops. */
    double along(double nx, double ny, double nz, float share) {
        return share >= end ? 0 : (linear.x * time + shift.x) * nx + (linear.y * time + shift.y) * ny + (linear.z * time + shift.z) * nz;
    }

    /**
     * How far any of its points moves by turning in the whole step, metres.
     *
     * @param round axis of a shape that looks the same when turned about it; null for none
     */
    double turning(Vector3f round, float share) {
        if (share >= end) {
            return 0;
        }
        double square = angular.lengthSquared();
        if (round != null) {
            double about = angular.dot(round);
            square = Math.max(0, square - about * about);
        }
        return Math.sqrt(square) * time * reach;
    }

    /** How far any of its points may move from a share of the step on, metres. */
    double length(float share) {
        return share >= end ? 0 : (linear.length() + angular.length() * reach) * time + shift.length();
    }

    /** How far the way of any of its points is from a straight line, by turning, metres. */
    double bend() {
        float turned = angular.length() * time;
        return Math.min(2, turned * turned / 8) * reach;
    }

    /** The share of the step at which it stops. */
    float getEnd() {
        return end;
    }

    /** How often it was stopped in this step. */
    int getStops() {
        return stops;
    }

    /**
     * Stops it there.
     *
     * @param bounce whether what it meets will throw it back
     */
    void stop(float share, boolean bounce) {
        end = share;
        stops++;
        bounceAhead = bounce;
    }

    /** Goes the way. A body that was stopped has the speed that it had there; what will bounce gets the lost time back afterwards. */
    void go(float step, float gravity, Transform scratch) {
        at(1, scratch);
        rigid.proceedToTransform(scratch);
        if (flies && (end < 1 || bounced)) {
            float known = bounced ? 0 : gravity * step;
            linear.y += known - gravity * end * time;
            if (end < 1 && bounceAhead) {
                // the next step adds its gravity before the contact is solved
                linear.y += gravity * step;
                owed = Math.min((1 - end) * time, MOST_OWED * step);
            }
            rigid.setLinearVelocity(linear);
        }
        before.set(linear);
    }
}
