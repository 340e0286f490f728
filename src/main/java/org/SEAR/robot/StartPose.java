// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;

/**
 * Start pose of a robot: its own pose times that of its dynamics. An upside-down pose is a misplaced heading, as in the
 * dissertation's Listing 2, which has 180 degrees at the wrong axis. The robot then stands upright, turned by 180
 * degrees, with a warning. A part of a machine starts as written.
 */
public final class StartPose {
    private static final double HALF_TURN = 180;

    private StartPose() {
    }

    /** Returns the start pose of a robot's body as written, before the ground lifts it; its own without a Dynamics. */
    public static Pose of(SEARrobot robot) {
        return robot.getComponents().stream().filter(Dynamics.class::isInstance).findFirst()
            .map(dynamics -> of(robot, dynamics, new ArrayList<>())).orElse(ObjectPose.of(robot));
    }

    /** @param warnings takes a warning for each correction */
    static Pose of(SEARrobot robot, SearObject dynamics, List<String> warnings) {
        Pose written = ObjectPose.of(robot).times(ObjectPose.of(dynamics));
        if (robot.getMachine() != null || !isUpsideDown(written)) {
            return written;
        }
        SearObject turned = isUpsideDown(ObjectPose.of(dynamics)) ? dynamics : robot;
        warnings.add(String.format(Locale.ROOT, "robot %s would start upside down (%s is rotated by %s, %s, %s "
            + "degrees). SEAR set it upright and"
            + " turned it by 180 degrees instead. A heading is the second angle, for example 0, 180, 0",
            robot.getName(), turned.getName(),
            degrees(turned.getRx()), degrees(turned.getRy()), degrees(turned.getRz())));
        return meant(robot).times(meant(dynamics));
    }

    /** Returns the heading only, plus half a turn if the object is upside down. */
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
