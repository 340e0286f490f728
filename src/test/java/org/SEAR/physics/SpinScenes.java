// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.geometry.InertiaTensor;
import org.SEAR.geometry.PrincipalAxes;
import org.SEAR.simulator.BodyRun;

/** Torque-free bodies and a top, which conserve energy and angular momentum. */
final class SpinScenes {
    private static final double G = 9.81;
    private static final double SHARE = 0.01;
    private static final double SECONDS = 10;
    private static final double HIGH = 600;

    /** Sides of a box in a model's file; corners count from 1. */
    private static final int[][] SIDES = {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3},
        {2, 4, 8, 6}};

    private SpinScenes() {
    }

    /** A box thrown about its middle axis flips over repeatedly (Dzhanibekov). */
    static void tumblingBox(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            new Box("thing", 0.4, 0.1, 0.2, 1).move(0, HIGH, 0);
            tumble("box tumbling about its middle axis", stage, 0.01, 10, 0.01, true, into);
        }
    }

    /** A T-handle as on a space station. */
    static void tumblingT(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            model(stage, "t.obj", new double[][] {{-0.15, 0.15, 0.1, 0.14, -0.02, 0.02},
                {-0.02, 0.02, -0.1, 0.1, -0.02, 0.02}});
            new Model("thing", "t.obj", 1).move(0, HIGH, 0);
            tumble("T tumbling about its middle axis", stage, 0.01, 10, 0.01, true, into);
        }
    }

    /** An L of two unequal legs with a foot to one side: all three products of inertia differ from 0. */
    static void tumblingL(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            model(stage, "l.obj", new double[][] {{0, 0.3, 0, 0.04, 0, 0.04}, {0, 0.04, 0.04, 0.2, 0, 0.04},
                {0.26, 0.3, 0, 0.04, 0.04, 0.14}});
            new Model("thing", "l.obj", 1).move(0, HIGH, 0);
            tumble("L tumbling about its middle axis", stage, 0.01, 10, 0.01, true, into);
        }
    }

    /** Writes a model made from boxes: {minX, maxX, minY, maxY, minZ, maxZ} each, metres. */
    private static void model(Stage stage, String name, double[][] boxes) throws IOException {
        Path file = stage.folder().resolve("assets").resolve(name);
        Files.createDirectories(file.getParent());
        StringBuilder text = new StringBuilder();
        int count = 0;
        for (double[] box : boxes) {
            for (int i = 0; i < 8; i++) {
                text.append("v ").append(box[i & 1]).append(' ').append(box[2 + (i >> 1 & 1)]).append(' ')
                    .append(box[4 + (i >> 2)]).append('\n');
            }
            for (int[] side : SIDES) {
                text.append('f');
                for (int corner : side) {
                    text.append(' ').append(corner + count);
                }
                text.append('\n');
            }
            count += 8;
        }
        Files.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
    }

    /** A long rod turns fast about its long axis and slowly about another: torque-free precession. */
    static void nutatingRod(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            new Cylinder("thing", 0.03, 0.5, 1).move(0, HIGH, 0);
            tumble("rod turning about two axes", stage, 3, 60, 0, false, into);
        }
    }

    /** A flat disc thrown with a wobble. */
    static void wobblingDisc(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            new Cylinder("thing", 0.2, 0.02, 1).move(0, HIGH, 0);
            tumble("disc turning at 100 rad/s with a wobble", stage, 10, 100, 0, false, into);
        }
    }

    /**
     * @param wy of the first angular velocity, rad/s, about the middle principal axis if {@code tips}, else about y;
     *     likewise wx and wz about the other axes
     * @param tips whether the body must flip about its middle axis
     */
    private static void tumble(String scene, Stage stage, double wx, double wy, double wz, boolean tips, Findings into)
        throws Exception {
        BodyRun run = stage.start();
        into.in(scene);
        PrincipalAxes axes = PrincipalAxes.of(tensor(run));
        int middle = tips ? middle(axes) : 1;
        double[] spin = {wx, tips ? wx : wy, wz};
        if (tips) {
            spin[middle] = wy;
        }
        double[] first = axis(run, axes, middle);
        double[] w = axes.frame.rotate(spin[0], spin[1], spin[2]);
        run.set("thing", 0, 0, 0, w[0], w[1], w[2]);
        double energy = energy(run);
        double[] momentum = momentum(run);
        double least = energy;
        double most = energy;
        double off = 0;
        double over = 1;
        while (run.time() < SECONDS) {
            run.step();
            least = Math.min(least, energy(run));
            most = Math.max(most, energy(run));
            double[] now = momentum(run);
            off = Math.max(off, length(now[0] - momentum[0], now[1] - momentum[1], now[2] - momentum[2])
                / length(momentum));
            double[] tipped = axis(run, axes, middle);
            over = Math.min(over, tipped[0] * first[0] + tipped[1] * first[1] + tipped[2] * first[2]);
        }
        into.atLeast("least energy of turning, shares of the first", 1 - SHARE, least / energy);
        into.atMost("greatest energy of turning, shares of the first", 1 + SHARE, most / energy);
        into.atMost("angular momentum, off by a share", SHARE, off);
        if (tips) {
            into.atMost("least cosine of its middle axis (-1: turned over)", -0.95, over);
        }
    }

    /** Returns the direction of a principal axis in the world. */
    private static double[] axis(BodyRun run, PrincipalAxes axes, int axis) {
        double[] own = axes.frame.rotate(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
        return run.pose("thing").rotate(own[0], own[1], own[2]);
    }

    private static InertiaTensor tensor(BodyRun run) {
        return run.body("thing").getMassProperties().inertia;
    }

    private static int middle(PrincipalAxes axes) {
        double[] moments = {axes.x, axes.y, axes.z};
        for (int i = 0; i < 3; i++) {
            double a = moments[(i + 1) % 3];
            double b = moments[(i + 2) % 3];
            if (moments[i] > Math.min(a, b) && moments[i] < Math.max(a, b)) {
                return i;
            }
        }
        throw new IllegalStateException("two moments of inertia are the same");
    }

    /** Returns the angular momentum in its own frame, N m s. */
    private static double[] ownMomentum(BodyRun run) {
        double[] w = own(run);
        double[][] rows = tensor(run).toRows();
        double[] momentum = new double[3];
        for (int i = 0; i < 3; i++) {
            momentum[i] = rows[i][0] * w[0] + rows[i][1] * w[1] + rows[i][2] * w[2];
        }
        return momentum;
    }

    /** Returns the angular velocity in its own frame, rad/s. */
    private static double[] own(BodyRun run) {
        double[] v = run.velocities("thing");
        return run.pose("thing").rotateBack(v[3], v[4], v[5]);
    }

    private static double energy(BodyRun run) {
        double[] momentum = ownMomentum(run);
        double[] w = own(run);
        return (momentum[0] * w[0] + momentum[1] * w[1] + momentum[2] * w[2]) / 2;
    }

    private static double[] momentum(BodyRun run) {
        double[] momentum = ownMomentum(run);
        return run.pose("thing").rotate(momentum[0], momentum[1], momentum[2]);
    }

    private static double length(double... v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    /**
     * A top (a cone on its tip), tilted by 20 degrees, starts so that it precesses without nutation. Its rate follows
     * the closed form.
     */
    static void top(Findings into) throws Exception {
        double radius = 0.05;
        double height = 0.1;
        double lean = Math.toRadians(20);
        double spin = 200;
        double far = 0.75 * height;
        double along = 0.3 * radius * radius;
        double across = 0.15 * radius * radius + 0.6 * height * height;
        double root = Math.sqrt(along * spin * along * spin - 4 * across * Math.cos(lean) * G * far);
        double round = (along * spin - root) / (2 * across * Math.cos(lean));
        try (Stage stage = new Stage()) {
            Floor floor = new Floor("floor", 2, 2);
            floor.setRollingFriction(0);
            Cone top = new Cone("thing", radius, height, 1);
            top.setRollingFriction(0);
            top.rotate(0, 0, 180 - 20);
            top.move(Math.sin(lean) * height / 2, Math.cos(lean) * height / 2, 0);
            BodyRun run = stage.start();
            double own = spin - round * Math.cos(lean);
            run.set("thing", 0, 0, -round * far * Math.sin(lean), own * Math.sin(lean),
                round + own * Math.cos(lean), 0);
            into.in("top of 200 rad/s on its tip, leant by 20 degrees");
            double energy = energyOfTop(run, far);
            double[] momentum = momentum(run);
            double turned = 0;
            double before = 0;
            double most = lean;
            while (run.time() < SECONDS) {
                run.step();
                double[] up = run.pose("thing").rotate(0, -1, 0);
                double now = Math.atan2(-up[2], up[0]);
                turned += Math.IEEEremainder(now - before, 2 * Math.PI);
                before = now;
                most = Math.max(most, Math.acos(Math.min(1, up[1])));
            }
            into.within("energy, J", energy, SHARE, energyOfTop(run, far));
            into.within("angular momentum upwards, for each kg", momentum[1], SHARE, momentum(run)[1]);
            into.within("precession in 10 s, rad", round * SECONDS, 0.02, turned);
            into.atMost("leant at most, degrees", 22, Math.toDegrees(most));
        }
    }

    /** Returns rotational, kinetic and potential energy per kg, J. */
    private static double energyOfTop(BodyRun run, double far) {
        double[] v = run.velocities("thing");
        return energy(run) + Rest.speed(v) * Rest.speed(v) / 2 + G * run.pose("thing").transform(0, -0.025, 0)[1];
    }
}
