// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.function.Consumer;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Vec3;
import org.SEAR.physics.Body;
import org.SEAR.physics.PhysicsWorld;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.start.StartPoses;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;

/**
 * Finds bodies whose centre of mass is inside a closed fixed mesh, as after a teleport. Contacts with the triangles
 * would keep them there, as they do not know on which side the body belongs. Simulation thread.
 */
final class WallExit {
    /** Steps between two searches. */
    private static final int INTERVAL = 30;
    /** Steps between two searches for a body inside a mesh, which may be a room. */
    private static final int ROOM_INTERVAL = 600;
    /** Largest number of surfaces above a body's centre before that of the mesh. */
    private static final int MAX_SURFACES = 8;
    /** Distance of the next ray from the surface that the last one has hit, metres. */
    private static final double BEYOND = 1e-4;

    private final PhysicsWorld physics;
    private final RaycastScenes scenes;
    private final WorldJoints joints;
    private final Mover mover;
    private final Consumer<String> reported;
    private final List<Body> movable = new ArrayList<>();
    private final List<Body> fixed = new ArrayList<>();
    private final Set<String> named = new HashSet<>();
    private final Hit hit = new Hit();
    /** Centre of mass, metres. */
    private final Vec3 at = new Vec3();
    /** Step of the next search by body. */
    private final long[] due;
    private long steps;

    /**
     * @param mover moves bodies, at rest
     * @param reported takes one warning per body
     */
    WallExit(World world, Mover mover, Consumer<String> reported) {
        physics = world.getPhysics();
        scenes = world.getScenes();
        joints = world.getJoints();
        this.mover = mover;
        this.reported = reported;
        physics.getBodies().forEach(body -> (body.isFixed() ? fixed : movable).add(body));
        due = new long[movable.size()];
    }

    /** Moves a body to a pose, at rest. */
    interface Mover {
        void move(String name, Pose start, Pose to);
    }

    /** Searches after a step, now and then. Uses the committed scenes. */
    void look() {
        if (++steps % INTERVAL == 0) {
            search(false);
        }
    }

    /**
     * Moves bodies in walls out of them, the shortest way.
     *
     * @param all whether sleeping bodies, too
     */
    void search(boolean all) {
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            boolean isDue = all || physics.isAwake(body) && steps >= due[i];
            if (isDue && isEnclosed(body) && !joints.holds(body)) {
                leave(body);
                due[i] = steps + ROOM_INTERVAL;
            }
        }
    }

    /** Tests whether the first surface of a fixed mesh above the centre of mass is seen from its back. */
    private boolean isEnclosed(Body body) {
        double[] centre = body.getCentre();
        at.transform(body.getPose(), centre[0], centre[1], centre[2]);
        double y = at.y;
        for (int i = 0; i < MAX_SURFACES; i++) {
            double up = scenes.ground.cast(at.x, y, at.z, 0, 1, 0, Double.MAX_VALUE, BeamScene.WORLD,
                hit);
            if (up == Double.POSITIVE_INFINITY) {
                return false;
            }
            if (scenes.body(hit.shape).isFixed() && scenes.solid(hit.shape).isMesh()) {
                return hit.ny > 0;
            }
            y += up + BEYOND;
        }
        return false;
    }

    private void leave(Body body) {
        Pose now = body.getPose();
        Pose out = StartPoses.leave(body, fixed, scenes.grounds());
        if (out == now) {
            return;
        }
        mover.move(body.name, body.getStart(), out);
        if (named.add(body.name)) {
            reported.accept(String.format(Locale.ROOT, "%s was inside a fixed object: SEAR moved it by (%.3f, %.3f, "
                + "%.3f) m, the shortest way out", body.name, out.x - now.x, out.y - now.y, out.z - now.z));
        }
    }
}
