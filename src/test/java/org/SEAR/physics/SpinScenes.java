package org.SEAR.physics;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cone;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.Model;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Torque-free bodies and a top, which conserve energy and angular momentum. */
final class SpinScenes {
    private static final double G = 9.81;
    private static final double SHARE = 0.01;
    private static final double SECONDS = 10;
    private static final double HIGH = 600;

    private SpinScenes() {
    }

    /** A box thrown about its middle axis flips over repeatedly (Dzhanibekov). */
    static void tumblingBox(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            new Box("thing", 0.4, 0.1, 0.2, 1).move(0, HIGH, 0);
            tumble("box tumbling about its middle axis", stage, 0.01, 10, 0.01, true, into);
        }
    }

    /** A T-handle as on a space station. Its convex hull has the mass. */
    static void tumblingT(Findings into) throws Exception {
        try (Stage stage = new Stage(2)) {
            Path file = stage.folder().resolve("assets/t.obj");
            Files.createDirectories(file.getParent());
            StringBuilder text = new StringBuilder();
            int count = 0;
            for (double[] box : new double[][] {{-0.15, 0.15, 0.1, 0.14, -0.02, 0.02}, {-0.02, 0.02, -0.1, 0.1, -0.02, 0.02}}) {
                for (int i = 0; i < 8; i++) {
                    text.append("v ").append(box[i & 1]).append(' ').append(box[2 + (i >> 1 & 1)]).append(' ').append(box[4 + (i >> 2)]).append('\n');
                }
                for (int[] side : new int[][] {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}) {
                    text.append("f ").append(side[0] + count).append(' ').append(side[1] + count).append(' ').append(side[2] + count).append('\n');
                    text.append("f ").append(side[0] + count).append(' ').append(side[2] + count).append(' ').append(side[3] + count).append('\n');
                }
                count += 8;
            }
            Files.write(file, text.toString().getBytes(StandardCharsets.UTF_8));
            new Model("thing", "t.obj", 1).move(0, HIGH, 0);
            tumble("T tumbling about its middle axis", stage, 0.01, 10, 0.01, true, into);
        }
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
     * @param wy of the first angular velocity, rad/s, about the middle axis if {@code tips}, else about y; likewise wx
     *     and wz about the other axes
     * @param tips whether the body must flip about its middle axis
     */
    private static void tumble(String scene, Stage stage, double wx, double wy, double wz, boolean tips, Findings into) throws Exception {
        BodyRun run = stage.start();
        into.in(scene);
        int middle = tips ? middle(run) : 1;
        double[] spin = {wx, tips ? wx : wy, wz};
        if (tips) {
            spin[middle] = wy;
        }
        run.set("thing", 0, 0, 0, spin[0], spin[1], spin[2]);
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
            off = Math.max(off, length(now[0] - momentum[0], now[1] - momentum[1], now[2] - momentum[2]) / length(momentum));
            over = Math.min(over, axis(run, middle)[middle]);
        }
        into.atLeast("least energy of turning, shares of the first", 1 - SHARE, least / energy);
        into.atMost("greatest energy of turning, shares of the first", 1 + SHARE, most / energy);
        into.atMost("angular momentum, off by a share", SHARE, off);
        if (tips) {
            into.atMost("least cosine of its middle axis (-1: turned over)", -0.95, over);
        }
    }

    private static double[] axis(BodyRun run, int axis) {
        Pose pose = run.pose("thing");
        return pose.rotate(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? 1 : 0);
    }

    private static double[] moments(BodyRun run) {
        return run.body("thing").solids.get(0).convex().inertia();
    }

    private static int middle(BodyRun run) {
        double[] moments = moments(run);
        for (int i = 0; i < 3; i++) {
            double a = moments[(i + 1) % 3];
            double b = moments[(i + 2) % 3];
            if (moments[i] > Math.min(a, b) && moments[i] < Math.max(a, b)) {
                return i;
            }
        }
        throw new IllegalStateException("two moments of inertia are the same");
    }

    /** Returns the angular velocity in the body's own frame, rad/s. */
    private static double[] own(BodyRun run) {
        double[] v = run.velocities("thing");
        return run.pose("thing").rotateBack(v[3], v[4], v[5]);
    }

    private static double energy(BodyRun run) {
        double[] moments = moments(run);
        double[] w = own(run);
        return (moments[0] * w[0] * w[0] + moments[1] * w[1] * w[1] + moments[2] * w[2] * w[2]) / 2;
    }

    private static double[] momentum(BodyRun run) {
        double[] moments = moments(run);
        double[] w = own(run);
        return run.pose("thing").rotate(moments[0] * w[0], moments[1] * w[1], moments[2] * w[2]);
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
            run.set("thing", 0, 0, -round * far * Math.sin(lean), own * Math.sin(lean), round + own * Math.cos(lean), 0);
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
