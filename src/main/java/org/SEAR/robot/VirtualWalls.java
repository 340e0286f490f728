// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.raycast.Hit;

/**
 * Beams of Roomba's virtual walls: objects whose name begins with {@code virtualWall}. They are infrared light, so
 * solid objects block them. Simulation thread.
 */
public final class VirtualWalls {
    private static final String PREFIX = "virtualwall";
    /**
     * Length of the beam, radius of its halo, metres, and half of its angle, radians (a real one reaches 2.4 m in a
     * narrow beam with a halo of 0.4 m).
     */
    private static final double LENGTH = 2.4;
    private static final double HALO = 0.4;
    private static final double HALF_ANGLE = Math.toRadians(10);

    private final List<Body> walls = new ArrayList<>();
    private final RaycastScenes scenes;
    private final Hit hit = new Hit();

    /** @param scenes with all objects that block a beam */
    public VirtualWalls(RaycastScenes scenes) {
        this.scenes = scenes;
    }

    /** Adds the body if it is a virtual wall. */
    public void consider(Body body) {
        if (body.name.toLowerCase(Locale.ROOT).startsWith(PREFIX)) {
            walls.add(body);
        }
    }

    /**
     * Whether a point is in a beam.
     * @param x world frame, metres, likewise y and z
     * @param robot number of the sensing robot, which does not block the beam
     */
    boolean reach(double x, double y, double z, int robot) {
        for (int i = 0; i < walls.size(); i++) {
            Pose wall = walls.get(i).getPose();
            double[] inWall = wall.rotateBack(x - wall.x, y - wall.y, z - wall.z);
            double distance = Math.hypot(inWall[0], inWall[2]);
            boolean inBeam = distance <= HALO || distance <= LENGTH && Math.abs(Math.atan2(inWall[0], inWall[2]))
                <= HALF_ANGLE;
            if (inBeam && sees(walls.get(i), x, y, z, robot)) {
                return true;
            }
        }
        return false;
    }

    /** Whether no solid object is in between. */
    private boolean sees(Body body, double x, double y, double z, int robot) {
        Pose wall = body.getPose();
        double dx = wall.x - x;
        double dy = wall.y - y;
        double dz = wall.z - z;
        double distance = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double way = distance == 0 ? Double.POSITIVE_INFINITY
            : scenes.ground.cast(x, y, z, dx / distance, dy / distance, dz / distance, distance, robot, hit);
        return way == Double.POSITIVE_INFINITY || scenes.body(hit.shape) == body;
    }
}
