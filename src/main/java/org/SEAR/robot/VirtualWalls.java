package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Body;

/** The beams of Roomba's virtual walls: objects whose name begins with {@code virtualWall}. Simulation thread. */
public final class VirtualWalls {
    private static final String PREFIX = "virtualwall";
    /** Length of the beam, metres, and half of its angle (facts: a virtual wall reaches 2.4 m in a narrow fan with a halo of 0.4 m). */
    private static final double LENGTH = 2.4;
    private static final double HALO = 0.4;
    private static final double HALF_ANGLE = Math.toRadians(10);

    private final List<Body> walls = new ArrayList<>();

    /** Keeps the body if it is a virtual wall. */
    public void consider(Body body) {
        if (body.name.toLowerCase(Locale.ROOT).startsWith(PREFIX)) {
            walls.add(body);
        }
    }

    /**
     * Whether a point is in a beam.
     *
     * @param x world frame, metres
     */
    boolean reach(double x, double y, double z) {
        for (int i = 0; i < walls.size(); i++) {
            Pose wall = walls.get(i).getPose();
            double[] inWall = wall.rotateBack(x - wall.x, y - wall.y, z - wall.z);
            double distance = Math.hypot(inWall[0], inWall[2]);
            if (distance <= HALO || distance <= LENGTH && Math.abs(Math.atan2(inWall[0], inWall[2])) <= HALF_ANGLE) {
                return true;
            }
        }
        return false;
    }
}
