package org.SEAR.robot.wheel;

import java.util.List;
import org.SEAR.POJOs.Wheel;

/**
 * Where a robot's centre of mass lies. It is the centroid of the components. Who gives masses to two of them or more says with that where the weight
 * is. Else that is not known; but who built a real robot put its battery so that it stands on its wheels, so a centroid that lies outside the wheels
 * or close to tipping is replaced by the middle of the wheels.
 */
public final class CentreOfMass {
    /** Least distance from tipping, as a share of the distance that the middle of the wheels has. */
    private static final double MIN_SHARE = 0.6;

    private CentreOfMass() {
    }

    /**
     * The centre of mass: {x, y, z} in the body frame.
     *
     * @param centroid of the components
     * @param weighed how many components have masses; if none, what is heavy sits no higher than where the wheels are fastened
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

    /** Distance of a point from the nearest edge of the wheels' convex hull, metres; negative outside. */
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

    /** Whether all wheels lie on one side of the line from a wheel along (ex, ez). */
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

    /** Where a wheel touches when the robot drives forward, in the body frame: x, metres. A caster runs behind its axis. */
    public static double footX(Wheel wheel) {
        return wheel.getX() - wheel.getTrail() * Math.sin(Math.toRadians(wheel.getRy()));
    }

    /** Likewise z. */
    public static double footZ(Wheel wheel) {
        return wheel.getZ() - wheel.getTrail() * Math.cos(Math.toRadians(wheel.getRy()));
    }
}
