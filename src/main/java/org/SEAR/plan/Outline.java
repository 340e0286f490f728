// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.project.ObjectPose;
import org.SEAR.robot.Robot;
import org.SEAR.simulator.Simulation;

/** Outline from above of an object or of a part of a robot. Immutable except for its array; any thread. */
public final class Outline {
    private static final String WHITE = "#ffffff";

    /** Name of the object or part. */
    public final String name;
    /** Whether it is a part of a robot. */
    public final boolean part;
    /** Corners in order, {x, z} in the world, metres. */
    public final double[][] points;
    /** Corners in order of each area to draw, {x, z} in the world, metres. */
    public final double[][][] areas;
    /** For example {@code #c49a6c}. */
    public final String color;
    /** Ground is below everything else. */
    public final boolean ground;

    private Outline(Shape shape, boolean part, double[][] points, double[][][] areas) {
        this.name = shape.getName();
        this.part = part;
        this.points = points;
        this.areas = areas.length == 0 ? new double[][][] {points} : areas;
        this.ground = shape.isGround();
        this.color = ground && !shape.hasColor() ? WHITE : shape.getColor();
    }

    /** Returns the outlines of the current world in drawing order: ground, objects, robots. Simulation thread. */
    public static List<Outline> of(Simulation world) {
        List<Outline> all = new ArrayList<>();
        List<SearObject> environment = world.getProject().getEnvironment();
        for (int i = 0; i < environment.size(); i++) {
            add(all, world, environment.get(i), false, world.snapshot().environment.get(i));
        }
        all.sort(Comparator.comparing((Outline one) -> !one.ground));
        for (Robot robot : world.getRobots()) {
            for (SearObject part : robot.getObject().getComponents()) {
                add(all, world, part, true, robot.getPose().times(ObjectPose.of(part)));
            }
        }
        return all;
    }

    private static void add(List<Outline> all, Simulation world, SearObject object, boolean part, Pose pose) {
        double[][] corners = world.getOutline(object);
        if (corners.length < 2 || !(object instanceof Shape)) {
            return;
        }
        double[][][] areas = world.getAreas(object);
        for (int i = 0; i < areas.length; i++) {
            areas[i] = fromAbove(areas[i], pose);
        }
        all.add(new Outline((Shape) object, part, hull(fromAbove(corners, pose)), areas));
    }

    private static double[][] fromAbove(double[][] corners, Pose pose) {
        double[][] points = new double[corners.length][];
        for (int i = 0; i < corners.length; i++) {
            double[] at = pose.transform(corners[i][0], corners[i][1], corners[i][2]);
            points[i] = new double[] {at[0], at[2]};
        }
        return points;
    }

    /** Returns the convex hull of points. */
    private static double[][] hull(double[][] points) {
        Arrays.sort(points, Comparator.<double[]>comparingDouble(p -> p[0]).thenComparingDouble(p -> p[1]));
        List<double[]> hull = new ArrayList<>();
        for (int pass = 0; pass < 2; pass++) {
            int first = hull.size();
            for (int i = 0; i < points.length; i++) {
                double[] p = points[pass == 0 ? i : points.length - 1 - i];
                while (hull.size() > first + 1 && turn(hull.get(hull.size() - 2), hull.get(hull.size() - 1), p) <= 0) {
                    hull.remove(hull.size() - 1);
                }
                hull.add(p);
            }
            hull.remove(hull.size() - 1);
        }
        return hull.toArray(new double[0][]);
    }

    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /**
     * Returns the bounding box of outlines: least x, greatest x, least z, greatest z, metres. Without outlines it
     * extends one metre around the origin.
     *
     * @param outlines may be empty
     */
    public static double[] box(List<Outline> outlines) {
        if (outlines.isEmpty()) {
            return new double[] {-1, 1, -1, 1};
        }
        double[] box = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY,
            Double.NEGATIVE_INFINITY};
        for (Outline outline : outlines) {
            for (double[] point : outline.points) {
                box[0] = Math.min(box[0], point[0]);
                box[1] = Math.max(box[1], point[0]);
                box[2] = Math.min(box[2], point[1]);
                box[3] = Math.max(box[3], point[1]);
            }
        }
        return box;
    }
}
