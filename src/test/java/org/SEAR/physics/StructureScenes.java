package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.SEAR.POJOs.Box;
import org.SEAR.geometry.Pose;
import org.SEAR.simulator.BodyRun;

/** Structures of boxes that stand: walls, pyramids, towers. Lengths in metres, masses in kg. */
final class StructureScenes {
    private static final double GRAVITY = 9.81;
    /** Length of a brick with its joint, height, width. */
    private static final double[] BRICK = {0.24, 0.071, 0.115};
    private static final double BRICK_MASS = 3.5;
    private static final double JOINT = 0.002;
    private static final int BRICKS = 10;

    private final List<String> names = new ArrayList<>();
    private final List<Double> masses = new ArrayList<>();
    /** Moment of inertia of each box about its longest-inertia axis, kg m^2: an upper bound of its kinetic energy. */
    private final List<Double> inertias = new ArrayList<>();

    private void add(double sizeX, double height, double sizeZ, double mass, double x, double y, double z) {
        String name = "box" + names.size();
        new Box(name, sizeX, sizeZ, height, mass).move(x, y, z);
        names.add(name);
        masses.add(mass);
        double most = sizeX * sizeX + height * height + sizeZ * sizeZ - Math.pow(Math.min(sizeX, Math.min(height, sizeZ)), 2);
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
                double x = shifted ? i == 0 ? -BRICK[0] / 4 : i == BRICKS ? (BRICKS - 0.75) * BRICK[0] : (i - 0.5) * BRICK[0] : i * BRICK[0];
                scene.brick(half ? 0.5 : 1, x + JOINT * 0.45 * (2 * random.nextDouble() - 1), row, 2 * JOINT * (random.nextDouble() - 0.5));
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
                    scene.add(size, size, size, 1, (i + row * 0.5) * size * 1.05, (row + 0.5) * size, (k + (square ? row * 0.5 : 0)) * size * 1.05);
                }
            }
        }
        return scene;
    }

    /** A Jenga tower: three bricks a storey, across those below. */
    static StructureScenes jenga(int storeys) {
        StructureScenes scene = new StructureScenes();
        for (int storey = 0; storey < storeys; storey++) {
            for (int i = -1; i <= 1; i++) {
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
        // what lifting every box by 0.02 mm, the slop of the position correction, takes
        into.atMost("energy gained, J", 2e-5 * GRAVITY * masses.stream().mapToDouble(m -> m).sum(), gained);
    }

    /** Hits the box at the top with an impulse along z, N s; the structure falls. Returns all poses after some seconds. */
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

    /** Potential and, from above, kinetic energy of all boxes, J. */
    private double energy(BodyRun run) {
        double energy = 0;
        for (int i = 0; i < names.size(); i++) {
            double[] v = run.velocities(names.get(i));
            energy += masses.get(i) * (GRAVITY * run.pose(names.get(i)).y + (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) / 2)
                + inertias.get(i) * (v[3] * v[3] + v[4] * v[4] + v[5] * v[5]) / 2;
        }
        return energy;
    }
}
