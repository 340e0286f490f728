// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import java.util.Locale;
import java.util.function.UnaryOperator;
import org.SEAR.POJOs.PlacedObject;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.Pose;
import org.SEAR.grammar.Parameter;
import org.SEAR.physics.Body;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.physics.start.StartPoses;
import org.SEAR.project.problems.ProblemList;
import org.SEAR.project.problems.ProjectException;

/**
 * Sets objects and robots down on the ground before the first step. The ground must be in the scenes already. For one
 * use, simulation thread.
 */
final class GroundPlacement {
    /**
     * Half of the distance over which the slope below a robot is measured, metres, unless its wheels are further apart.
     */
    private static final double HALF_BASE = 0.1;

    /** Heading of an object without rotation, degrees. */
    private static final double EAST = 90;

    private final GeoOrigin origin;
    private final RaycastScenes scenes;
    private final ProblemList problems = new ProblemList();

    /** @param origin position of the world's origin on Earth; null if no terrain defines it */
    GroundPlacement(GeoOrigin origin, RaycastScenes scenes) {
        this.origin = origin;
        this.scenes = scenes;
    }

    /** Sets an environment object down; its rotation stays. */
    void setDown(PlacedObject object, Body body) {
        if (object.isOnGround()) {
            Pose written = body.getPose();
            setDown(object, body, pose -> turned(pose, written), new double[0][], "environment/");
        }
    }

    /**
     * Sets a robot down on its wheels, along the slope.
     *
     * @param feet contact points of its wheels, body frame
     */
    void setDownRobot(SEARrobot robot, Body body, double[][] feet) {
        if (robot.isOnGround()) {
            Pose written = robot.getPlaceHeading() == null ? body.getPose()
                : Pose.ofDegrees(0, 0, 0, 0, EAST - robot.getPlaceHeading(), 0);
            setDown(robot, body, pose -> alongSlope(turned(pose, written), feet), feet, "robot/");
        }
    }

    private static Pose turned(Pose place, Pose rotation) {
        return new Pose(place.x, 0, place.z, rotation.qx, rotation.qy, rotation.qz, rotation.qw);
    }

    /** @param turn gives the rotation to a pose at the right point */
    private void setDown(PlacedObject object, Body body, UnaryOperator<Pose> turn, double[][] feet, String folder) {
        String file = folder + object.getFileName() + ".xml";
        if (object.hasPlaceOnEarth() && origin == null) {
            problems.add(file, 0, "placeLatitude", Parameter.format(object.getPlaceLatitude()),
                "only with a Terrain whose map defines its position on Earth; placeAt(x, z), in metres, works without");
            return;
        }
        double[] point = object.hasPlaceOnEarth() ? origin.to(object.getPlaceLatitude(), object.getPlaceLongitude())
            : new double[] {object.getX(), object.getZ()};
        if (!StartPoses.stand(body, turn.apply(new Pose(point[0], 0, point[1], 0, 0, 0, 1)), feet, scenes)) {
            problems.add(file, 0, object.hasPlaceOnEarth() ? "placeLatitude, placeLongitude" : "x, z",
                where(object, point), "a place with ground: on the terrain, a floor, or a model that is the terrain");
        }
    }

    private static String where(PlacedObject object, double[] point) {
        return object.hasPlaceOnEarth()
            ? String.format(Locale.ROOT, "%s, %s (%.0f m north and %.0f m east of the origin)",
                Parameter.format(object.getPlaceLatitude()),
                Parameter.format(object.getPlaceLongitude()), point[0], point[1])
            : Parameter.format(point[0]) + ", " + Parameter.format(point[1]);
    }

    /** Tilts a pose to the slope of the ground and keeps its heading; returns it unchanged where the ground ends. */
    private Pose alongSlope(Pose level, double[][] feet) {
        double base = HALF_BASE;
        for (double[] foot : feet) {
            base = Math.max(base, Math.hypot(foot[0], foot[2]));
        }
        double northward = (scenes.groundHeight(level.x + base, level.z) - scenes.groundHeight(level.x - base, level.z))
            / (2 * base);
        double eastward = (scenes.groundHeight(level.x, level.z + base) - scenes.groundHeight(level.x, level.z - base))
            / (2 * base);
        double steep = Math.hypot(northward, eastward);
        if (!(steep > 0)) {
            return level;
        }
        double half = Math.atan(steep) / 2;
        double sine = Math.sin(half) / steep;
        Pose lean = new Pose(level.x, level.y, level.z, -eastward * sine, 0, northward * sine, Math.cos(half));
        return lean.times(Pose.ofDegrees(0, 0, 0, 0, stray(lean, level.rotate(0, 0, 1), northward, eastward), 0))
            .times(new Pose(0, 0, 0, level.qx, level.qy, level.qz, level.qw));
    }

    /**
     * Heading error, clockwise, degrees, that the tilt alone would cause for a robot facing obliquely up a slope.
     *
     * @param ahead intended forward direction, world frame
     * @param northward slope of the ground to the north, rise over run
     * @param eastward slope of the ground to the east, rise over run
     */
    private static double stray(Pose lean, double[] ahead, double northward, double eastward) {
        double[] before = lean.rotateBack(ahead[0], northward * ahead[0] + eastward * ahead[2], ahead[2]);
        return Math.toDegrees(Math.atan2(ahead[2], ahead[0]) - Math.atan2(before[2], before[0]));
    }

    /**
     * Reports all placement errors.
     *
     * @throws ProjectException that lists every object without ground or without a valid place
     */
    void end() throws ProjectException {
        problems.throwIfAny();
    }
}
