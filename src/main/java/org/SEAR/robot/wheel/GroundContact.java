// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.ConstraintRow;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.SolverBody;
import org.SEAR.raycast.Hit;

/**
 * Contact of one wheel with the ground: one ray per step along the suspension finds it, substeps update it. Simulation
 * thread.
 */
final class GroundContact {
    /**
     * Smallest cosine between ground normal and suspension of ground that supports a wheel; steeper ground is a wall.
     * Downward-facing normals do not support either: the robot is on its back.
     */
    private static final double STEEPEST = 0.35;
    /**
     * Cosine of full support; between both it fades. Ground in contact supports a wheel down to the second cosine.
     * Without this hysteresis a robot on its tail would hop.
     */
    private static final double CARRYING = 0.5;
    private static final double LETTING_GO = 0.3;
    /**
     * Largest penetration into a movable body, as a share of the wheel's diameter, at which the wheel stands on it.
     * Deeper overlaps, and bodies in a deep overlap, are resolved as contacts of bodies first.
     */
    private static final double DEEPEST = 0.25;

    /** Ground normal and contact point, world frame. */
    final Vec3 normal = new Vec3();
    final Vec3 point = new Vec3();
    private final Hit hit = new Hit();
    private Body under;
    private boolean touches;
    private double share;
    private double seen;
    private double gap;

    /**
     * Finds the ground, once per step.
     * @param from start of the ray, world frame
     * @param up along the suspension
     * @param wheel from there to the lowest point of the wheel at full compression, metres
     * @param rest further distance to that point without load, metres
     * @param owner number of the robot, whose parts are not ground
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
        touches = under != null && (under.isFixed() || seen > -DEEPEST * wheel && !under.isDeep());
        if (touches) {
            under.wake();
        } else {
            under = null;
        }
        share = Math.max(0, Math.min(1, (Math.abs(lean) - STEEPEST) / (CARRYING - STEEPEST)));
        point.set(from).add(-distance, up);
    }

    /** Returns the ground's coefficient of friction. */
    double friction(RaycastScenes scenes) {
        return scenes.solid(hit.shape).getSurface().friction(under.isRobot());
    }

    /** Updates the gap for a substep. */
    void prepare(SolverBody body) {
        gap = seen + body.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
        SolverBody carrier = carrier();
        if (carrier != null) {
            carrier.hold();
            gap -= carrier.travel(normal.x, normal.y, normal.z, point.x, point.y, point.z);
        }
    }

    /** Returns the supporting body if it moves; else null. */
    private SolverBody carrier() {
        return under.solver();
    }

    /** Sets up a row of the wheel at this contact along a direction. */
    void aim(ConstraintRow row, Vec3 along, SolverBody body) {
        row.set(along.x, along.y, along.z, point.x, point.y, point.z, body, carrier());
    }

    boolean touches() {
        return touches;
    }

    /** Share of the suspension force that the ground takes, 0 to 1, by its slope. */
    double share() {
        return share;
    }

    /**
     * Length of the suspension at which the wheel just touches the ground, metres, as found by the ray; negative:
     * beyond full compression.
     */
    double seen() {
        return seen;
    }

    /** The same, updated for this substep. */
    double gap() {
        return gap;
    }

    /** Supporting body; null in the air. */
    Body under() {
        return under;
    }
}
