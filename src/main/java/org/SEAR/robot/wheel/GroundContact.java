package org.SEAR.robot.wheel;

import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;
import org.SEAR.raycast.Hit;

/** Where one wheel meets the ground: found by one ray a step along its suspension, and followed from substep to substep. Simulation thread. */
final class GroundContact {
    /**
     * Ground that leans more than this (cosine of the angle to the suspension) is a wall and carries no wheel. Nor does what is above it: the wheels
     * of a robot that lies on its back meet the ground from below.
     */
    private static final double STEEPEST = 0.35;
    /**
     * At this one it carries a wheel wholly, and the less the nearer it is to a wall; and what carries a wheel does so until it is as steep as the
     * other. Else a robot that stands on its tail would hop from carried to not carried and back.
     */
    private static final double CARRYING = 0.5;
    private static final double LETTING_GO = 0.3;
    /**
     * A wheel that is in something that moves by more than this share of its diameter does not stand on it, nor does any on what is far in something:
     * first they come apart as bodies do.
     */
    private static final double DEEPEST = 0.25;

    /** Of the ground, world frame. */
    final Vec3 normal = new Vec3();
    final Vec3 point = new Vec3();
    private final Hit hit = new Hit();
    private Body under;
    /** Which of its solids, and how much of the step is over, seconds. */
    private int solid;
    private double gone;
    private double next;
    private boolean touches;
    private double share;
    private double seen;
    private double gap;

    /**
     * Looks for ground, once a step.
     *
     * @param from where the ray starts, world frame
     * @param up along the suspension
     * @param wheel from there to the lowest point of the wheel when its suspension is wholly compressed, metres
     * @param rest how much farther that point is when nothing presses the wheel, metres
     * @param owner whose parts are not ground
     */
    void look(RaycastScenes scenes, Vec3 from, Vec3 up, double wheel, double rest, int owner) {
        double distance = scenes.ground.cast(from.x, from.y, from.z, -up.x, -up.y, -up.z, wheel + rest, owner, hit);
        normal.set(hit.nx, hit.ny, hit.nz);
        double lean = normal.dot(up);
        if (lean < 0) {
            normal.scale(-1);
        }
        seen = distance - wheel;
        boolean carries = distance < wheel + rest && Math.abs(lean) > (touches ? LETTING_GO : STEEPEST) && normal.y > 0;
        under = carries ? scenes.body(hit.shape) : null;
        next = 0;
        touches = under != null && (under.isFixed() || seen > -DEEPEST * wheel && !under.isDeep());
        if (touches) {
            under.wake();
            solid = under.solidOf(hit.shape);
        } else {
            under = null;
        }
        share = Math.max(0, Math.min(1, (Math.abs(lean) - STEEPEST) / (CARRYING - STEEPEST)));
        point.set(from).add(-distance, up);
    }

    /** Friction of what is below. */
    double friction(RaycastScenes scenes) {
        return scenes.solid(hit.shape).getSurface().friction(under.isRobot());
    }

    /** Takes over where the wheel and the ground are now. */
    void prepare(SolverBody body) {
        gone = next;
        next += body.seconds();
        gap = seen + body.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
        SolverBody carrier = carrier();
        if (carrier != null) {
            carrier.hold();
            gap -= carrier.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
        }
    }

    /** What it stands on, if that moves; else null. */
    private SolverBody carrier() {
        return under.solver();
    }

    /** Has a row of the wheel act here along a direction. */
    void aim(ConstraintRow row, Vec3 along, SolverBody body) {
        row.set(along.x, along.y, along.z, point.x, point.y, point.z, body, carrier());
        if (carrier() != null && solid >= 0) {
            row.carry(under, solid, point.x, point.y, point.z, gone);
        }
    }

    /** Whether the wheel is on the ground. */
    boolean touches() {
        return touches;
    }

    /** How much of what the suspension can give the ground takes, 0 to 1, as steep as it is for the wheel. */
    double share() {
        return share;
    }

    /** How far the wheel hangs when it just touches the ground, metres; negative if it can't go up so far. As the ray has seen it. */
    double seen() {
        return seen;
    }

    /** The same now. */
    double gap() {
        return gap;
    }

    /** What it stands on; null in the air. */
    Body under() {
        return under;
    }
}
