package org.SEAR.robot;

import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;

/**
 * Where a robot starts: its own pose and that of its dynamics. One that would lie on its back is a heading that was meant, as in the dissertation's
 * Listing 2, whose 180 degrees stand at the wrong axis: the robot stands upright and is turned by 180 degrees, with a warning.
 */
final class StartPose {
    private static final double HALF_TURN = 180;

    private StartPose() {
    }

    /** @param warnings takes what was put right */
    static Pose of(SearObject robot, SearObject dynamics, List<String> warnings) {
        Pose written = ObjectPose.of(robot).times(ObjectPose.of(dynamics));
        if (!isUpsideDown(written)) {
            return written;
        }
        SearObject turned = isUpsideDown(ObjectPose.of(dynamics)) ? dynamics : robot;
        warnings.add(String.format(Locale.ROOT, "robot %s would start upside down (%s is rotated by %s, %s, %s degrees): it was set upright and"
            + " turned by 180 degrees instead; a heading is the second angle, for example 0, 180, 0", robot.getName(), turned.getName(),
            degrees(turned.getRx()), degrees(turned.getRy()), degrees(turned.getRz())));
        return meant(robot).times(meant(dynamics));
    }

    /** The heading alone, and half a turn more if it lies on its back. */
    private static Pose meant(SearObject object) {
        double turn = isUpsideDown(ObjectPose.of(object)) ? HALF_TURN : 0;
        return Pose.ofDegrees(object.getX(), object.getY(), object.getZ(), 0, object.getRy() + turn, 0);
    }

    private static boolean isUpsideDown(Pose pose) {
        return pose.rotate(0, 1, 0)[1] < 0;
    }

    private static String degrees(double angle) {
        return angle == Math.rint(angle) ? String.valueOf((long) angle) : String.valueOf(angle);
    }
}
