// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.List;
import org.SEAR.POJOs.Wheel;

/**
 * Centre of mass of a robot: the centroid of its components. With masses on two components or more this is final.
 * Otherwise the mass distribution is unknown. Real robots carry their battery so that they stand on their wheels. A
 * centroid outside the wheels or close to tipping is therefore replaced by the middle of the wheels.
 */
public final class CentreOfMass {
    /** Smallest distance from tipping, as a share of that of the middle of the wheels. */
    private static final double MIN_SHARE = 0.6;

    private CentreOfMass() {
    }

    /**
     * Returns the centre of mass: {x, y, z} in the body frame.
     * @param centroid of the components
     * @param weighed number of components with a mass; if 0, the centre is no higher than the wheels' mounts
     */
    public static double[] place(double[] centroid, long weighed, List<Wheel> wheels) {
        if (wheels.size() < 3 || weighed > 1) {
            return centroid;
        }
        double midX = 0;
        double midY = 0;
        double midZ = 0;
        for (Wheel wheel : wheels) {
            midY += wheel.getY() / wheels.size();
            midX += wheel.getX() / wheels.size();
            midZ += wheel.getZ() / wheels.size();
        }
        double y = weighed > 0 ? centroid[1] : Math.min(centroid[1], midY);
        if (room(centroid[0], centroid[2], wheels) >= MIN_SHARE * room(midX, midZ, wheels)) {
            return new double[] {centroid[0], y, centroid[2]};
        }
        return new double[] {midX, y, midZ};
    }

    /** Returns the distance of a point from the nearest edge of the wheels' convex hull, metres; negative outside. */
    static double room(double x, double z, List<Wheel> wheels) {
        double least = Double.POSITIVE_INFINITY;
        for (Wheel a : wheels) {
            for (Wheel b : wheels) {
                double ex = b.getX() - a.getX();
                double ez = b.getZ() - a.getZ();
                double length = Math.hypot(ex, ez);
                if (length > 0 && isEdge(a, ex, ez, wheels)) {
                    least = Math.min(least, (ex * (z - a.getZ()) - ez * (x - a.getX())) / length);
                }
            }
        }
        return least == Double.POSITIVE_INFINITY ? 0 : least;
    }

    /** Whether all wheels are on one side of the line from a wheel along (ex, ez). */
    private static boolean isEdge(Wheel a, double ex, double ez, List<Wheel> wheels) {
        boolean any = false;
        for (Wheel wheel : wheels) {
            double side = ex * (wheel.getZ() - a.getZ()) - ez * (wheel.getX() - a.getX());
            if (side < 0) {
                return false;
            }
            any |= side > 0;
        }
        return any;
    }

    /**
     * Returns x of a wheel's contact point in the body frame when the robot drives forward, metres. A caster trails its
     * pivot.
     */
    public static double footX(Wheel wheel) {
        return wheel.getX() - wheel.getTrail() * Math.sin(Math.toRadians(wheel.getRy()));
    }

    /** Returns z of that point. */
    public static double footZ(Wheel wheel) {
        return wheel.getZ() - wheel.getTrail() * Math.cos(Math.toRadians(wheel.getRy()));
    }
}
