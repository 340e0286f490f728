// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Model;
import org.SEAR.POJOs.Shape;
import org.SEAR.POJOs.Sphere;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Structures that stand: walls, pyramids, towers, arches, stacks, piles. Lengths in metres, masses in kg. */
final class StructureScenes {
    private static final double GRAVITY = 9.81;
    /** Length of a brick with its joint, height, width. */
    private static final double[] BRICK = {0.24, 0.071, 0.115};
    private static final double BRICK_MASS = 3.5;
    private static final double JOINT = 0.002;
    private static final int BRICKS = 10;
    private static final double ARCH_FRICTION = 0.9;

    private final List<String> names = new ArrayList<>();
    private final List<Double> masses = new ArrayList<>();
    /** Moment of inertia of each box about its longest-inertia axis, kg m^2: an upper bound of its kinetic energy. */
    private final List<Double> inertias = new ArrayList<>();

    private void add(double sizeX, double height, double sizeZ, double mass, double x, double y, double z) {
        Box box = new Box("box" + names.size(), sizeX, sizeZ, height, mass);
        box.move(x, y, z);
        add(box, mass, sizeX, height, sizeZ);
    }

    /** Adds a body; its bounding box bounds its moments of inertia. */
    private void add(Shape body, double mass, double sizeX, double sizeY, double sizeZ) {
        names.add(body.getName());
        masses.add(mass);
        double most = sizeX * sizeX + sizeY * sizeY + sizeZ * sizeZ
            - Math.pow(Math.min(sizeX, Math.min(sizeY, sizeZ)), 2);
        inertias.add(mass * most / 12);
    }

    private void brick(double share, double x, int row, double z) {
        add(share * BRICK[0] - JOINT, BRICK[1], BRICK[2], share * BRICK_MASS, x, (row + 0.5) * BRICK[1], z);
    }

    /** A wall in running bond, half bricks at its ends, joints laid by hand. */
    static StructureScenes wall(int rows, int seed) {
        StructureScenes scene = new StructureScenes();
        Random random = new Random(seed);
        for (int row = 0; row < rows; row++) {
            boolean shifted = row % 2 == 1;
            for (int i = 0; i < BRICKS + row % 2; i++) {
                boolean half = shifted && (i == 0 || i == BRICKS);
                double x = shifted ? i == 0 ? -BRICK[0] / 4 : i == BRICKS ? (BRICKS - 0.75) * BRICK[0]
                    : (i - 0.5) * BRICK[0] : i * BRICK[0];
                scene.brick(half ? 0.5 : 1, x + JOINT * 0.45 * (2 * random.nextDouble() - 1), row,
                    2 * JOINT * (random.nextDouble() - 0.5));
            }
        }
        return scene;
    }

    /** A wall in stack bond: every joint above another. */
    static StructureScenes stackBond(int rows) {
        StructureScenes scene = new StructureScenes();
        for (int row = 0; row < rows; row++) {
            for (int i = 0; i < BRICKS; i++) {
                scene.brick(1, i * BRICK[0], row, 0);
            }
        }
        return scene;
    }

    /** A flat pyramid of cubes of 0.1 m, or one with a square base. */
    static StructureScenes pyramid(int rows, boolean square) {
        StructureScenes scene = new StructureScenes();
        double size = 0.1;
        for (int row = 0; row < rows; row++) {
            for (int i = 0; i < rows - row; i++) {
                for (int k = 0; k < (square ? rows - row : 1); k++) {
                    scene.add(size, size, size, 1, (i + row * 0.5) * size * 1.05, (row + 0.5) * size,
                        (k + (square ? row * 0.5 : 0)) * size * 1.05);
                }
            }
        }
        return scene;
    }

    /**
     * A Jenga tower: three bricks a storey, across those below.
     * @param gaps number of storeys, every second from the bottom, whose middle brick has been pushed out
     */
    static StructureScenes jenga(int storeys, int gaps) {
        StructureScenes scene = new StructureScenes();
        for (int storey = 0; storey < storeys; storey++) {
            boolean gap = storey % 2 == 0 && storey / 2 < gaps;
            for (int i = -1; i <= 1; i += gap ? 2 : 1) {
                double y = (storey + 0.5) * 0.015;
                if (storey % 2 == 0) {
                    scene.add(0.025, 0.015, 0.075, 0.02, i * 0.0255, y, 0);
                } else {
                    scene.add(0.075, 0.015, 0.025, 0.02, 0, y, i * 0.0255);
                }
            }
        }
        return scene;
    }

    /**
     * A semicircular arch of wedges on the floor.
     * @param ratio thickness of the arch over the radius of its centre line
     */
    static StructureScenes arch(Stage stage, int wedges, double ratio) throws IOException {
        StructureScenes scene = new StructureScenes();
        double radius = 0.5;
        double width = 0.2;
        double inner = radius * (1 - ratio / 2);
        double outer = radius * (1 + ratio / 2);
        double half = Math.PI / wedges / 2;
        Path file = Files.createDirectories(stage.folder().resolve("assets")).resolve("wedge.obj");
        double[][] corners = {{-inner * Math.sin(half), inner * Math.cos(half)},
            {inner * Math.sin(half), inner * Math.cos(half)},
            {outer * Math.sin(half), outer * Math.cos(half)}, {-outer * Math.sin(half), outer * Math.cos(half)}};
        StringBuilder text = new StringBuilder();
        for (int side = -1; side <= 1; side += 2) {
            for (double[] corner : corners) {
                text.append(String.format(Locale.ROOT, "v %.12f %.12f %.12f%n", corner[0], corner[1] - radius,
                    side * width / 2));
            }
        }
        text.append("f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        Files.writeString(file, text);
        double area = (outer * outer - inner * inner) * Math.sin(2 * half) / 2;
        double mass = 2000 * area * width;
        for (int i = 0; i < wedges; i++) {
            double angle = Math.PI / 2 - (2 * i + 1) * half;
            Model wedge = new Model("wedge" + i, "wedge.obj", mass);
            wedge.setFriction(ARCH_FRICTION);
            wedge.rotate(0, 0, -Math.toDegrees(angle));
            wedge.move(radius * Math.sin(angle), radius * Math.cos(angle), 0);
            scene.add(wedge, mass, outer * 2 * half, outer - inner, width);
        }
        return scene;
    }

    /** A card house: leaning pairs, with a flat card from peak to peak, one pair fewer on each storey. */
    static StructureScenes cards(int storeys) {
        StructureScenes scene = new StructureScenes();
        double lean = Math.toRadians(15);
        double length = 0.1;
        double thick = 0.002;
        double width = 0.07;
        double mass = 0.01;
        double high = thick * Math.sin(lean) + length * Math.cos(lean);
        double apart = 2 * (length * Math.sin(lean) + thick * Math.cos(lean)) + 0.001;
        for (int storey = 0; storey < storeys; storey++) {
            double base = storey * (high + thick);
            for (int i = 0; i < storeys - storey; i++) {
                double peak = (i + storey * 0.5) * apart;
                for (int side = -1; side <= 1; side += 2) {
                    Box card = new Box("box" + scene.names.size(), thick, width, length, mass);
                    card.rotate(0, 0, side * Math.toDegrees(lean));
                    card.move(peak + side * (thick * Math.cos(lean) + length * Math.sin(lean)) / 2, base + high / 2, 0);
                    scene.add(card, mass, thick, length, width);
                }
                if (i > 0) {
                    scene.add(apart - 0.0005, thick, width, mass, peak - apart / 2, base + high + thick / 2, 0);
                }
            }
        }
        return scene;
    }

    /** A flat pyramid of cans, each on the rims of two. */
    static StructureScenes cans(int rows) {
        StructureScenes scene = new StructureScenes();
        double radius = 0.033;
        double height = 0.115;
        for (int row = 0; row < rows; row++) {
            for (int i = 0; i < rows - row; i++) {
                scene.upright(radius, height, 0.35, (i + row * 0.5) * (2 * radius + 0.001), (row + 0.5) * height);
            }
        }
        return scene;
    }

    /** A stack of plates. */
    static StructureScenes plates(int count) {
        StructureScenes scene = new StructureScenes();
        for (int i = 0; i < count; i++) {
            scene.upright(0.13, 0.02, 0.5, 0, (i + 0.5) * 0.02);
        }
        return scene;
    }

    private void upright(double radius, double height, double mass, double x, double y) {
        Cylinder cylinder = new Cylinder("cylinder" + names.size(), radius, height, mass);
        cylinder.move(x, y, 0);
        add(cylinder, mass, 2 * radius, height, 2 * radius);
    }

    /** Four fixed walls around a square. */
    private static void rim(double side) {
        for (int i = -1; i <= 1; i += 2) {
            new Box("rimX" + (i + 1), 0.05, side + 0.1, 0.4, 0).move(i * (side / 2 + 0.025), 0.2, 0);
            new Box("rimZ" + (i + 1), side, 0.05, 0.4, 0).move(0, 0.2, i * (side / 2 + 0.025));
        }
    }

    /** Balls in layers above a tray with a rim. */
    static StructureScenes tray(int row, int layers) {
        StructureScenes scene = new StructureScenes();
        double radius = 0.05;
        rim(2 * radius * row + 0.03);
        for (int i = 0; i < row * row * layers; i++) {
            double shift = i / (row * row) % 2 * 0.01;
            scene.ball(radius, (i % row - (row - 1) * 0.5) * 2 * radius + shift,
                radius + i / (row * row) * 2.02 * radius,
                (i / row % row - (row - 1) * 0.5) * 2 * radius + shift / 2);
        }
        return scene;
    }

    private void ball(double radius, double x, double y, double z) {
        Sphere ball = new Sphere("ball" + names.size(), radius, 0.5);
        ball.move(x, y, z);
        add(ball, 0.5, 2 * radius, 2 * radius, 2 * radius);
    }

    /** Boxes, cylinders and balls in random poses, which fall onto one pile within walls. */
    static StructureScenes mixed(int count, int seed) {
        StructureScenes scene = new StructureScenes();
        rim(1.2);
        Random random = new Random(seed);
        for (int i = 0; i < count; i++) {
            double x = 0.16 * (i % 6 - 2.5) + 0.02 * random.nextDouble();
            double y = 0.15 + 0.17 * (i / 36);
            double z = 0.16 * (i / 6 % 6 - 2.5) + 0.02 * random.nextDouble();
            if (i % 3 == 2) {
                scene.ball(0.03 + 0.03 * random.nextDouble(), x, y, z);
            } else {
                double wide = 0.06 + 0.04 * random.nextDouble();
                double tall = 0.06 + 0.04 * random.nextDouble();
                Shape body = i % 3 == 0 ? new Box("mixed" + i, wide, 0.08, tall, 1)
                    : new Cylinder("mixed" + i, wide / 2, tall, 1);
                body.rotate(360 * random.nextDouble(), 360 * random.nextDouble(), 360 * random.nextDouble());
                body.move(x, y, z);
                scene.add(body, 1, wide, tall, i % 3 == 0 ? 0.08 : wide);
            }
        }
        return scene;
    }

    /** Lets bodies fall and come to rest: no energy is gained, and all sleep after some seconds. */
    void settle(Stage stage, String scene, double seconds, Findings into) throws Exception {
        BodyRun run = stage.start();
        into.in(scene);
        double before = potential(run);
        double gained = 0;
        while (run.time() < seconds) {
            run.step();
            gained = Math.max(gained, energy(run) - before);
        }
        into.equal("bodies awake after " + seconds + " s", 0, run.busy());
        into.atMost("energy gained, J", 0.01 * before, gained);
    }

    /** Leaves the structure alone for a minute: it rests within a second, does not move, and gains no energy. */
    void rest(Stage stage, String scene, double allowed, Findings into) throws Exception {
        BodyRun run = stage.start();
        into.in(scene);
        List<Pose> start = new ArrayList<>();
        names.forEach(name -> start.add(run.pose(name)));
        double before = energy(run);
        double gained = 0;
        while (run.time() < 1) {
            run.step();
            gained = Math.max(gained, energy(run) - before);
        }
        into.equal("bodies awake after 1 s", 0, run.busy());
        while (run.time() < 60) {
            run.run(1);
            gained = Math.max(gained, energy(run) - before);
        }
        double moved = 0;
        for (int i = 0; i < names.size(); i++) {
            Pose now = run.pose(names.get(i));
            moved = Math.max(moved, Math.sqrt(Math.pow(now.x - start.get(i).x, 2) + Math.pow(now.y - start.get(i).y, 2)
                + Math.pow(now.z - start.get(i).z, 2)));
        }
        into.atMost("largest displacement after 60 s, mm", allowed, 1000 * moved);
        // Residual velocities of 1e-5 m/s lift the structure by up to 0.3 micrometres until it sleeps
        into.atMost("energy gained, J", 1e-6 * GRAVITY * masses.stream().mapToDouble(m -> m).sum(), gained);
    }

    /** Runs for some seconds; returns how far a body has sunk, metres. */
    double sinks(Stage stage, int body, double seconds) throws Exception {
        BodyRun run = stage.start();
        double before = run.pose(names.get(body)).y;
        run.run(seconds);
        return before - run.pose(names.get(body)).y;
    }

    /**
     * Hits the box at the top with an impulse along z, N s; the structure falls. Returns all poses after some seconds.
     */
    List<Pose> hit(Stage stage, double impulse, double seconds) throws Exception {
        BodyRun run = stage.start();
        run.run(1);
        int top = names.size() - 1;
        run.set(names.get(top), 0, 0, impulse / masses.get(top), 0, 0, 0);
        run.run(seconds);
        List<Pose> poses = new ArrayList<>();
        names.forEach(name -> poses.add(run.pose(name)));
        return poses;
    }

    private double potential(BodyRun run) {
        double energy = 0;
        for (int i = 0; i < names.size(); i++) {
            energy += masses.get(i) * GRAVITY * run.pose(names.get(i)).y;
        }
        return energy;
    }

    /** Potential and, from above, kinetic energy of all boxes, J. */
    private double energy(BodyRun run) {
        double energy = 0;
        for (int i = 0; i < names.size(); i++) {
            double[] v = run.velocities(names.get(i));
            energy += masses.get(i) * (GRAVITY * run.pose(names.get(i)).y
                + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2)
                + inertias.get(i) * (v[3] * v[3] + v[4] * v[4] + v[5] * v[5]) / 2;
        }
        return energy;
    }
}
