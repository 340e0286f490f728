// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Shape;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Logs on logs, rails and floors: contacts along a line. The logs lie along z. */
final class LogScenes {
    private static final double RADIUS = 0.1;
    private static final double LENGTH = 1;
    private static final double MASS = 10;

    private LogScenes() {
    }

    /** Places a log along z; {x, y} in radii. */
    private static Cylinder log(String name, double x, double y, double mass) {
        return log(name, x, y, 1, mass);
    }

    private static Cylinder log(String name, double x, double y, double scale, double mass) {
        Cylinder log = new Cylinder(name, scale * RADIUS, scale * LENGTH, mass);
        log.rotate(90, 0, 0);
        log.move(x * scale * RADIUS, y * scale * RADIUS, 0);
        return log;
    }

    private static void setSurface(Shape shape, double friction) {
        shape.setFriction(friction);
        shape.setRollingFriction(0);
    }

    /** A free log lies in the groove of two fixed logs. */
    static void onFixedLogs(double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage(10)) {
            log("left", -1, 1, 0);
            log("right", 1, 1, 0);
            log("top", 0, 1 + Math.sqrt(3), MASS);
            rests(stage, "log on two fixed logs", "top", seconds, into);
        }
    }

    /** A free log lies on the edges of two boxes, which are as far apart as its radius is long. */
    static void onRails(double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage(10)) {
            for (int side = -1; side <= 1; side += 2) {
                new Box(side < 0 ? "left" : "right", 0.2, 2, 0.5, 0).move(side * (RADIUS / 2 + 0.1), 0.25, 0);
            }
            log("top", 0, 0, MASS).move(0, 0.5 + RADIUS * Math.sqrt(0.75), 0);
            rests(stage, "log on the edges of two boxes", "top", seconds, into);
        }
    }

    /** A cone lies on its side in the groove of two fixed cones. */
    static void coneOnCones(double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage(10)) {
            double height = 0.4;
            double lean = Math.atan2(RADIUS, height);
            for (int i = 0; i < 3; i++) {
                Cone cone = new Cone("cone" + i, RADIUS, height, i < 2 ? 0 : 2);
                Pose pose = coneAmongThree(i, lean, height);
                double[] turned = degrees(pose);
                cone.rotate(turned[0], turned[1], turned[2]);
                cone.move(pose.x, pose.y + 1, pose.z);
            }
            rests(stage, "cone on two fixed cones", "cone2", seconds, into);
        }
    }

    /**
     * Three cones with a common apex touch each other along their sides. Their axes are at equal angles to the z axis:
     * the angle between two axes is twice the cone's half angle.
     */
    private static Pose coneAmongThree(int i, double lean, double height) {
        double tilt = Math.asin(2 * Math.sin(lean) / Math.sqrt(3));
        Pose about = Pose.ofDegrees(0, 0, 0, 0, 0, 120 * (i + 1));
        Pose lay = Pose.ofDegrees(0, 0, 0, 90 + Math.toDegrees(tilt), 0, 0);
        return about.times(lay).times(new Pose(0, -height / 2, 0, 0, 0, 0, 1));
    }

    private static double[] degrees(Pose pose) {
        double[] x = pose.rotate(1, 0, 0);
        double[] y = pose.rotate(0, 1, 0);
        double[] z = pose.rotate(0, 0, 1);
        return new double[] {Math.toDegrees(Math.atan2(-z[1], y[1])), Math.toDegrees(Math.atan2(-x[2], x[0])),
            Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, x[1]))))};
    }

    /**
     * A log rolls off a fixed one of thrice its radius: theta'' = 2 g sin theta / 3 (R + r). Its contact moves along
     * the surface of both.
     */
    static void overLog(Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            double apart = 4 * RADIUS;
            double theta = Math.toRadians(10);
            Cylinder under = new Cylinder("under", 3 * RADIUS, LENGTH, 0);
            under.rotate(90, 0, 0);
            setSurface(under, 2);
            setSurface(log("top", 4 * Math.sin(theta), 4 * Math.cos(theta), MASS), 2);
            BodyRun run = stage.start();
            double rate = 0;
            while (theta < Math.toRadians(35)) {
                double seconds = run.time();
                run.step();
                double[] next = RollingScenes.pendulum(theta, rate, 2 * 9.81 / (3 * apart), run.time() - seconds);
                theta = next[0];
                rate = next[1];
            }
            Pose at = run.pose("top");
            double[] v = run.velocities("top");
            into.in("log rolls off a log");
            into.within("angle, degrees", Math.toDegrees(theta), 5e-3, Math.toDegrees(Math.atan2(at.x, at.y)));
            into.near("distance of the axes, m", apart, 2e-4, Math.hypot(at.x, at.y));
            into.near("rolls along its axis by, m", 0, 1e-4, at.z);
            into.within("spin, rad/s", rate * apart / RADIUS, 1e-2, Math.abs(v[5]));
            into.near("spin across its axis, rad/s", 0, 1e-3, Math.hypot(v[3], v[4]));
        }
    }

    private static void rests(Stage stage, String scene, String name, double seconds, Findings into) throws Exception {
        BodyRun run = stage.start();
        Pose from = run.pose(name);
        double most = 0;
        while (run.time() < seconds) {
            run.step();
            most = Math.max(most, Rest.distance(from, run.pose(name)));
        }
        into.in(scene);
        into.atMost("largest movement, m", 1e-4, most);
        into.atMost("speed at the end, m/s", 1e-4, Rest.speed(run.velocities(name)));
    }

    /**
     * Three logs as a pile: stands if the friction of log on log is at least tan 15 degrees = 0.268, and that of log on
     * ground at least a third of it, 0.0893.
     * @param scale size as a multiple of logs of 0.1 m radius and 1 m length
     */
    static void pile(double scale, double logOnLog, double logOnGround, double seconds, boolean stands, Findings into)
        throws Exception {
        try (Stage stage = new Stage()) {
            double friction = Math.sqrt(logOnLog);
            setSurface(new Floor("floor", 10, 10), logOnGround / friction);
            setSurface(log("left", -1, 1, scale, MASS), friction);
            setSurface(log("right", 1, 1, scale, MASS), friction);
            setSurface(log("top", 0, 1 + Math.sqrt(3), scale, MASS), friction);
            BodyRun run = stage.start();
            double from = run.pose("top").y;
            run.run(seconds);
            into.in("three logs, scale " + scale + ", friction " + logOnLog + ", on the ground " + logOnGround);
            if (stands) {
                into.atMost("the top log sinks by, m", 1e-4, from - run.pose("top").y);
            } else {
                into.atLeast("the top log sinks by, m", 0.02, from - run.pose("top").y);
            }
        }
    }

    /** Logs in rows between two fixed stops, the lowest row without gaps: the pile stands at any friction. */
    static void rows(int rows, double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage(10)) {
            for (int side = -1; side <= 1; side += 2) {
                new Box(side < 0 ? "left" : "right", 0.2, 2, 1, 0).move(side * (rows * RADIUS + 0.1), 0.5, 0);
            }
            for (int row = 0; row < rows; row++) {
                for (int i = 0; i < rows - row; i++) {
                    log("log" + row + "_" + i, 2 * i + row - rows + 1, 1 + row * Math.sqrt(3), MASS);
                }
            }
            rests(stage, rows + " rows of logs", "log" + (rows - 1) + "_0", seconds, into);
        }
    }
}
