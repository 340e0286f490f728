// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.Body;
import org.SEAR.physics.RobotBodies;
import org.SEAR.physics.solid.Solid;

/** Parts of one robot's body that touch an object now. A sleeping body keeps its last contacts. Simulation thread. */
final class PartTouches {
    /** Overlap of a bumper's two switches on each side of the middle, radians: a hit from the front closes both. */
    private static final double BUMPER_OVERLAP = Math.toRadians(15);

    private final Map<String, Integer> solids = new HashMap<>();
    private final Map<String, Spot> spots = new LinkedHashMap<>();
    private final boolean[] touched;
    private final int wheelsFrom;
    private final Body body;
    private boolean any;
    private boolean bumpedLeft;
    private boolean bumpedRight;

    PartTouches(RobotBuilder from) {
        from.object.getComponents().stream().filter(from.shapes::containsKey)
            .forEach(part -> solids.put(part.getName(), from.solidOf(part)));
        from.object.getComponents().stream().filter(from.shapes::containsKey)
            .forEach(part -> spots.put(part.getName(), new Spot(from.bodyOf(part), from.shapes.get(part))));
        touched = new boolean[RobotBodies.whole(from.body).solids.size()];
        body = from.body;
        wheelsFrom = touched.length - from.wheelSolids.size();
    }

    /** A part as a solid of one of the robot's bodies. */
    private static final class Spot {
        private final Body body;
        private final int solid;

        Spot(Body body, Solid solid) {
            this.body = body;
            this.solid = body.solids.indexOf(solid);
        }

        double force() {
            return RobotBodies.getPressed(body, solid) / TimeStep.SECONDS;
        }
    }

    void restart() {
        spots.values().forEach(spot -> RobotBodies.release(spot.body));
        clear();
        release();
    }

    void clear() {
        Arrays.fill(touched, false);
        any = false;
    }

    /** Whether a solid belongs to a wheel. */
    boolean isWheel(int solid) {
        return solid >= wheelsFrom;
    }

    /** @param solid its index in the body */
    void add(int solid) {
        touched[solid] = true;
        any = true;
    }

    /** Notes the contact of an obstacle with a solid at a point of the world. */
    void press(int solid, double x, double y, double z) {
        add(solid);
        Pose pose = body.getPose();
        double[] inBody = pose.rotateBack(x - pose.x, y - pose.y, z - pose.z);
        double angle = Math.atan2(inBody[0], inBody[2]);
        bumpedLeft |= angle >= -BUMPER_OVERLAP && angle <= Math.PI / 2;
        bumpedRight |= angle <= BUMPER_OVERLAP && angle >= -Math.PI / 2;
    }

    /** Releases the bumper. */
    void release() {
        bumpedLeft = false;
        bumpedRight = false;
    }

    boolean isBumpedLeft() {
        return bumpedLeft;
    }

    boolean isBumpedRight() {
        return bumpedRight;
    }

    /**
     * Returns the sum of the normal forces on a part, the mean of the last step, N.
     * @param part name of a component; null for all parts without the wheels
     */
    double force(String part) {
        Spot spot = part == null ? null : spots.get(part);
        return part == null ? spots.values().stream().mapToDouble(Spot::force).sum() : spot == null ? 0 : spot.force();
    }

    /** @param part name of a component; null for any part, wheels included */
    boolean is(String part) {
        Integer solid = part == null ? null : solids.get(part);
        return part == null ? any : solid != null && touched[solid];
    }
}
