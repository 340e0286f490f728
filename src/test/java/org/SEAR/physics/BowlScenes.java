// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.DoubleBinaryOperator;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Balls in bowls and on domes of meshes, and boxes on bumpy meshes. */
final class BowlScenes {
    private static final double G = 9.81;
    /** Radius of bowls and domes, metres. */
    private static final double CURVATURE = 1;
    private static final double BALL = 0.1;
    /** Half of a bowl's length, metres. */
    private static final double LENGTH = 0.2;
    /** Closed forms hold to this share. */
    private static final double SHARE = 5e-3;
    /** Largest loss of energy per period of a swing, and on the path over a dome, as shares of the energy. */
    private static final double LOSS_IN_BOWL = 3.5e-3;
    private static final double LOSS_ON_DOME = 3e-3;

    private BowlScenes() {
    }

    private static Model mesh(Stage stage, double length, double width, double cell, DoubleBinaryOperator height)
            throws IOException {
        return mesh(stage, length, width, cell, height, false);
    }

    /**
     * Makes a fixed mesh of a height field over the rectangle |x| at most length, |z| at most width, metres.
     * @param shuffled whether the triangles are in another order
     */
    private static Model mesh(Stage stage, double length, double width, double cell, DoubleBinaryOperator height,
            boolean shuffled) throws IOException {
        int along = (int) Math.round(2 * length / cell);
        int across = Math.max(1, (int) Math.round(2 * width / cell));
        StringBuilder obj = new StringBuilder();
        for (int i = 0; i <= along; i++) {
            for (int k = 0; k <= across; k++) {
                double x = 2 * length * i / along - length;
                double z = 2 * width * k / across - width;
                obj.append(String.format(Locale.ROOT, "v %.8f %.8f %.8f%n", x, height.applyAsDouble(x, z), z));
            }
        }
        List<String> faces = new ArrayList<>();
        for (int i = 0; i < along; i++) {
            for (int k = 0; k < across; k++) {
                int at = i * (across + 1) + k + 1;
                int next = at + across + 1;
                faces.add(String.format(Locale.ROOT, "f %d %d %d%n", at, at + 1, next));
                faces.add(String.format(Locale.ROOT, "f %d %d %d%n", at + 1, next + 1, next));
            }
        }
        if (shuffled) {
            Collections.shuffle(faces, new Random(1));
        }
        faces.forEach(obj::append);
        Path assets = Files.createDirectories(stage.folder().resolve("assets"));
        Files.write(assets.resolve("mesh.obj"), obj.toString().getBytes(StandardCharsets.UTF_8));
        Model mesh = new Model("mesh", "mesh.obj");
        mesh.setFriction(1);
        mesh.setRollingFriction(0);
        return mesh;
    }

    private static double sphere(double x, double z) {
        return Math.sqrt(CURVATURE * CURVATURE - x * x - z * z);
    }

    private static Sphere ball() {
        Sphere ball = new Sphere("ball", BALL, 1);
        ball.setFriction(1);
        ball.setRollingFriction(0);
        return ball;
    }

    /** Energy of the ball, J: kinetic and potential. */
    private static double energy(BodyRun run) {
        double[] v = run.velocities("ball");
        double spin = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
        return (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2 + 0.2 * BALL * BALL * spin + G * run.pose("ball").y;
    }

    /**
     * A ball rolls to and fro in a bowl.
     * @param cell size of the mesh's cells, metres
     */
    static void bowl(double cell, double degrees, double seconds, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            mesh(stage, LENGTH, Math.max(0.006, cell), cell, (x, z) -> -sphere(x, z));
            double radius = CURVATURE - BALL;
            double start = Math.toRadians(degrees);
            // the start is off the mesh's symmetry axis
            double beside = 0.0037;
            ball().move(radius * Math.sin(start), -Math.sqrt(radius * radius * Math.cos(start) * Math.cos(start)
                - beside * beside), beside);
            BodyRun run = stage.start();
            double before = run.pose("ball").x;
            double first = 0;
            double last = 0;
            int crossings = 0;
            double off = 0;
            double swing = G * radius * (1 - Math.cos(start));
            double lowest = 0;
            // the flat cells are up to 0.3 mm beside the bowl: the start moves the ball onto them
            run.run(0.25);
            double whole = energy(run);
            double gain = 0;
            double loss = 0;
            while (run.time() < seconds) {
                run.step();
                Pose at = run.pose("ball");
                off = Math.max(off, Math.abs(Math.sqrt(at.x * at.x + at.y * at.y + at.z * at.z) - radius));
                lowest = Math.min(lowest, at.y);
                double change = (energy(run) - whole) / swing;
                gain = Math.max(gain, change);
                loss = Math.min(loss, change);
                if (before < 0 != at.x < 0) {
                    last = run.time() - Math.abs(at.x) / (Math.abs(at.x) + Math.abs(before)) / 60;
                    first = crossings++ == 0 ? last : first;
                }
                before = at.x;
            }
            double period = 2 * (last - first) / (crossings - 1);
            into.in("ball in a bowl of cells of " + cell + " m");
            into.within("period, s", period(cell, whole / G - lowest), SHARE, period);
            into.atMost("largest deviation from the surface, m", 1e-3, off);
            into.atMost("gain of energy, share of the swing's", LOSS_IN_BOWL, gain);
            into.atMost("loss of energy per period, share of the swing's", LOSS_IN_BOWL, -loss * period / seconds);
        }
    }

    /**
     * Returns the period of a ball that rolls on the flat cells of a bowl, seconds. Its centre follows straight lines
     * that are a radius above the cells, with 5/7 of the acceleration of a sliding body.
     * @param height of the turning points above the lowest line, metres
     */
    private static double period(double cell, double height) {
        int cells = (int) Math.round(2 * LENGTH / cell);
        double[] x = new double[cells + 1];
        double[] y = new double[cells + 1];
        double lowest = 0;
        for (int i = 1; i < cells; i++) {
            double[] before = normal(i - 1, cells);
            double[] after = normal(i, cells);
            double scale = BALL / (1 + before[0] * after[0] + before[1] * after[1]);
            x[i] = edge(i, cells) + scale * (before[0] + after[0]);
            y[i] = -sphere(edge(i, cells), 0) + scale * (before[1] + after[1]);
            lowest = Math.min(lowest, y[i]);
        }
        double seconds = 0;
        for (int i = 1; i < cells - 1; i++) {
            double low = Math.min(y[i], y[i + 1]) - lowest;
            double high = Math.max(y[i], y[i + 1]) - lowest;
            if (low < height) {
                // distance over mean speed
                double share = high > height ? (height - low) / (high - low) : 1;
                double speeds = Math.sqrt(10 * G / 7 * (height - low))
                    + Math.sqrt(Math.max(0, 10 * G / 7 * (height - high)));
                seconds += 2 * share * Math.hypot(x[i + 1] - x[i], y[i + 1] - y[i]) / speeds;
            }
        }
        return 2 * seconds;
    }

    private static double edge(int i, int cells) {
        return 2 * LENGTH * i / cells - LENGTH;
    }

    private static double[] normal(int i, int cells) {
        double dx = edge(i + 1, cells) - edge(i, cells);
        double dy = sphere(edge(i, cells), 0) - sphere(edge(i + 1, cells), 0);
        double length = Math.hypot(dx, dy);
        return new double[] {-dy / length, dx / length};
    }

    /** A ball rolls over the top of a dome, from -10 to 10 degrees: theta'' = 5 g sin theta / 7 (R + r). */
    static void dome(double cell, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            mesh(stage, 0.24, Math.max(0.015, cell), cell, BowlScenes::sphere);
            double radius = CURVATURE + BALL;
            double start = Math.toRadians(-10);
            double speed = 0.65;
            Sphere ball = ball();
            ball.move(radius * Math.sin(start), radius * Math.cos(start), 0.0037);
            ball.setVelocity(speed * Math.cos(start), -speed * Math.sin(start), 0);
            ball.setSpin(0, 0, -Math.toDegrees(speed / BALL));
            BodyRun run = stage.start();
            double theta = start;
            double rate = speed / radius;
            double whole = 0;
            double off = 0;
            double gain = 0;
            double loss = 0;
            while (theta < -start) {
                double seconds = run.time();
                run.step();
                double[] next = RollingScenes.pendulum(theta, rate, 5 * G / (7 * radius), run.time() - seconds);
                theta = next[0];
                rate = next[1];
                Pose at = run.pose("ball");
                off = Math.max(off, Math.abs(Math.sqrt(at.x * at.x + at.y * at.y + at.z * at.z) - radius));
                whole = run.time() < 0.1 ? energy(run) : whole;
                double change = (energy(run) - whole) / (0.7 * speed * speed);
                gain = Math.max(gain, change);
                loss = Math.min(loss, change);
            }
            Pose at = run.pose("ball");
            into.in("ball on a dome of cells of " + cell + " m");
            into.near("angle, share of 20 degrees", 0, SHARE,
                (Math.atan2(at.x, at.y) - theta) / (-2 * start));
            into.atMost("largest deviation from the surface, m", 1e-3, off);
            into.atMost("gain of energy, share of the first", SHARE, gain);
            into.atMost("loss of energy, share of the first", LOSS_ON_DOME, -loss);
        }
    }

    /** A box falls flat on a bumpy mesh and comes to rest. */
    static void bumps(double cell, double height, int seed, Findings into) throws Exception {
        try (Stage stage = new Stage()) {
            Random random = new Random(seed);
            mesh(stage, 0.25, 0.25, cell, (x, z) -> height * random.nextDouble());
            new Box("box", 0.3, 0.2, 0.2, 5).move(0.01 * seed, height + 0.11, 0);
            BodyRun run = stage.start();
            double highest = 0;
            double resting = 10;
            while (run.time() < 3) {
                run.step();
                highest = Math.max(highest, run.pose("box").y);
                if (run.busy() == 0) {
                    resting = Math.min(resting, run.time());
                }
            }
            into.in("box on bumps of " + height + " m, cells of " + cell + " m, seed " + seed);
            into.atMost("rests after, s", 2, resting);
            into.atMost("highest, m", height + 0.111, highest);
            into.atLeast("height, m", 0.1 - 1e-3, run.pose("box").y);
        }
    }

    /** Positions and velocities of a box, a ball and a log after half a second on bumps, as text with all digits. */
    static String onBumps(boolean shuffled) throws Exception {
        try (Stage stage = new Stage()) {
            Random random = new Random(5);
            mesh(stage, 0.5, 0.5, 0.02, (x, z) -> 0.005 * random.nextDouble(), shuffled);
            new Box("box", 0.3, 0.3, 0.2, 5).move(0.2, 0.12, 0);
            ball().move(-0.3, BALL + 0.02, 0.2);
            Cylinder log = new Cylinder("log", 0.05, 0.3, 3);
            log.rotate(90, 0, 0);
            log.move(-0.2, 0.07, -0.2);
            BodyRun run = stage.start();
            run.run(0.5);
            StringBuilder poses = new StringBuilder();
            for (String name : new String[] {"box", "ball", "log"}) {
                Pose at = run.pose(name);
                double[] v = run.velocities(name);
                poses.append(at.x + " " + at.y + " " + at.z + " " + Arrays.toString(v) + "\n");
            }
            return poses.toString();
        }
    }
}
