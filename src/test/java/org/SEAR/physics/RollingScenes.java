// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Bodies without rolling friction on slopes, compared with closed forms. The slope falls towards -x. */
final class RollingScenes {
    private static final double G = 9.81;
    /** Largest relative difference from the closed form. */
    private static final double SHARE = 1e-3;

    private RollingScenes() {
    }

    private static void slope(double degrees) {
        Floor slope = new Floor("slope", 400, 400);
        slope.rotate(0, 0, degrees);
        slope.setRollingFriction(0);
        slope.setFriction(2);
    }

    private static void put(Shape thing, double above, double degrees) {
        double slope = Math.toRadians(degrees);
        thing.move(-above * Math.sin(slope), above * Math.cos(slope), 0);
        thing.setRollingFriction(0);
        thing.setFriction(2);
    }

    /** Rolls a ball of 5 cm radius; at 30 degrees it reaches 210 rad/s. */
    static void ball(double degrees, double seconds, Findings into) throws Exception {
        ball(0.05, degrees, seconds, into);
    }

    static void ball(double radius, double degrees, double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            slope(degrees);
            put(new Sphere("thing", radius, 2), radius, degrees);
            roll(stage, "ball of " + radius + " m down " + degrees + " degrees for " + seconds + " s", degrees, 5.0 / 7,
                radius, seconds, into);
        }
    }

    /** Rolls a cylinder of 5 cm radius. */
    static void cylinder(double degrees, double seconds, Findings into) throws Exception {
        cylinder(0.05, 0.1, degrees, seconds, into);
    }

    static void cylinder(double radius, double length, double degrees, double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            slope(degrees);
            Cylinder cylinder = new Cylinder("thing", radius, length, 2);
            put(cylinder, radius, degrees);
            cylinder.rotate(90, 0, 0);
            roll(stage, "cylinder of " + radius + " m down " + degrees + " degrees for " + seconds + " s", degrees,
                2.0 / 3, radius, seconds, into);
        }
    }

    private static void roll(Stage stage, String scene, double degrees, double share, double radius, double seconds,
        Findings into) throws Exception {
        BodyRun run = stage.start();
        Pose from = run.pose("thing");
        run.run(seconds);
        double a = share * G * Math.sin(Math.toRadians(degrees));
        double[] v = run.velocities("thing");
        into.in(scene);
        into.within("way, m", a * seconds * seconds / 2, SHARE, Rest.distance(from, run.pose("thing")));
        into.within("speed, m/s", a * seconds, SHARE, Rest.speed(v));
        into.within("spin, rad/s", a * seconds / radius, SHARE, Math.sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]));
    }

    /**
     * A cone on its side rolls about its apex like a pendulum: with phi, the angle of its contact line from straight
     * down, phi'' = -K sin phi. It starts at 60 degrees and runs until it is straight below its apex.
     */
    static void cone(double degrees, Findings into) throws Exception {
        double radius = 0.1;
        double height = 0.2;
        double start = Math.toRadians(60);
        double slope = Math.toRadians(degrees);
        double lean = Math.atan2(radius, height);
        double about = 0.3 * radius * radius * Math.cos(lean) * Math.cos(lean)
            + (0.15 * radius * radius + 0.6 * height * height) * Math.sin(lean) * Math.sin(lean);
        double k = G * Math.sin(slope) * 0.75 * height * Math.cos(lean) * Math.tan(lean) * Math.tan(lean) / about;
        try (Stage stage = new Stage()) {
            slope(degrees);
            Cone cone = new Cone("thing", radius, height, 2);
            cone.setRollingFriction(0);
            cone.setFriction(2);
            Pose pose = coneOnItsSide(start, slope, lean, height);
            double[] turned = degrees(pose);
            cone.move(pose.x, pose.y, pose.z);
            cone.rotate(turned[0], turned[1], turned[2]);
            BodyRun run = stage.start();
            into.in("cone on its side, slope of " + degrees + " degrees");
            double seconds = 0;
            double phi = start;
            double rate = 0;
            while (phi > 0) {
                run.step();
                double[] next = pendulum(phi, rate, -k, run.time() - seconds);
                seconds = run.time();
                phi = next[0];
                rate = next[1];
            }
            into.near("angle when it hangs straight down, of 60 degrees", 60 - Math.toDegrees(phi), 60 * 1.2 * SHARE,
                60 - Math.toDegrees(angleOf(run.pose("thing"), slope, height)));
            double[] v = run.velocities("thing");
            into.within("its spin then, rad/s", Math.abs(rate) / Math.tan(lean), 5 * SHARE,
                Math.sqrt(v[3] * v[3] + v[4] * v[4] + v[5] * v[5]));
        }
    }

    /** Returns the pose of a cone with its apex at the origin and its contact line phi radians from straight down. */
    private static Pose coneOnItsSide(double phi, double slope, double lean, double height) {
        Pose plane = Pose.ofDegrees(0, 0, 0, 0, 0, Math.toDegrees(slope));
        Pose turn = Pose.ofDegrees(0, 0, 0, 0, Math.toDegrees(phi), 0);
        Pose lying = Pose.ofDegrees(0, 0, 0, 0, 0, -90 - Math.toDegrees(lean));
        Pose apex = new Pose(0, -height / 2, 0, 0, 0, 0, 1);
        return plane.times(turn).times(lying).times(apex);
    }

    /** Returns the angle of the contact line from straight down the slope, radians. */
    private static double angleOf(Pose pose, double slope, double height) {
        double[] axis = pose.rotate(0, -1, 0);
        double along = axis[0] * Math.cos(slope) + axis[1] * Math.sin(slope);
        return Math.atan2(axis[2], -along);
    }

    /** Returns the rotation of a pose in the convention of {@code rotate}: degrees about x, y and z. */
    static double[] degrees(Pose pose) {
        double[] x = pose.rotate(1, 0, 0);
        double[] y = pose.rotate(0, 1, 0);
        double[] z = pose.rotate(0, 0, 1);
        double ry = Math.atan2(-x[2], x[0]);
        double rz = Math.asin(Math.max(-1, Math.min(1, x[1])));
        double rx = Math.atan2(-z[1], y[1]);
        return new double[] {Math.toDegrees(rx), Math.toDegrees(ry), Math.toDegrees(rz)};
    }

    /** Advances phi'' = k sin phi by one interval with Runge-Kutta: {phi, its rate}. */
    static double[] pendulum(double phi, double rate, double k, double seconds) {
        int parts = 20;
        double h = seconds / parts;
        for (int i = 0; i < parts; i++) {
            double a1 = k * Math.sin(phi);
            double v2 = rate + h / 2 * a1;
            double a2 = k * Math.sin(phi + h / 2 * rate);
            double v3 = rate + h / 2 * a2;
            double a3 = k * Math.sin(phi + h / 2 * v2);
            double v4 = rate + h * a3;
            double a4 = k * Math.sin(phi + h * v3);
            phi += h / 6 * (rate + 2 * v2 + 2 * v3 + v4);
            rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
        }
        return new double[] {phi, rate};
    }
}
