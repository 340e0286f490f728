package org.SEAR.robot;

import java.util.List;
import java.util.Locale;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.Scenes;
import org.SEAR.raycast.Hit;

/** What a user should know of a robot before it is driven. Simulation thread. */
public final class StartChecks {
    private StartChecks() {
    }

    /**
     * Says what keeps a robot from driving.
     *
     * @param scenes with everything at its start
     * @param warnings takes what is said
     */
    public static void check(RobotModel robot, Scenes scenes, List<String> warnings) {
        String name = robot.getObject().getName();
        if (robot.getObject().getWheels().isEmpty()) {
            warnings.add("robot " + name + " has no wheels and can't drive: robot.addWheel(Wheel(...)) adds one");
        }
        Pose pose = robot.getPose();
        double down = scenes.ground.cast(pose.x, pose.y, pose.z, 0, -1, 0, Double.MAX_VALUE, robot.getOwner(), new Hit());
        if (down == Double.POSITIVE_INFINITY) {
            warnings.add(String.format(Locale.ROOT, "robot %s has no ground below its start at x %.2f, y %.2f, z %.2f and will fall:"
                + " Floor(\"floor\", 20, 20) makes one at height 0", name, pose.x, pose.y, pose.z));
        }
    }
}
