// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import java.util.Random;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.Triangles;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.Hit;

/**
 * Benchmark worlds for ray casting: a walled square with rotated boxes of 0.25 to 1 m, or hills of triangles or
 * elevations, and 100 poses of a LIDAR. Equal names give equal worlds. {@code room-N} is 10 m x 10 m with N boxes;
 * {@code hall-N} grows at 20 boxes per 100 m^2. {@code hills-N} has at least N triangles on 20 m x 20 m.
 * {@code field-N} is a height field of about N posts that grows at 100 000 posts per 20 m x 20 m.
 */
public final class BeamWorld {
    static final int BEAMS = 361;
    static final double SPREAD = Math.PI;
    static final double RANGE = 8;
    static final int POSES = 100;
    /** Length of the room's side, metres. */
    private static final double ROOM = 10;
    private static final double WALL = 0.1;
    private static final double WALL_HEIGHT = 2;
    private static final double BEAM_HEIGHT = 0.5;
    private static final double HILLS = 20;
    private static final double FIELD_POSTS = 100_000;
    private static final double MAST = 0.3;
    private static final double SPARSE = 20;

    final String name;
    /** Ten numbers per box: half sizes, position, quaternion. Empty for hills and fields. */
    double[][] boxes = new double[0][];
    /** Null except for hills. */
    Triangles triangles;
    /** Null except for fields. */
    HeightField field;
    final Pose[] poses = new Pose[POSES];
    private final Random random = new Random(2026);

    BeamWorld(String name) {
        this(name, true);
    }

    /** @param poses whether to create the LIDAR's poses */
    BeamWorld(String name, boolean poses) {
        this.name = name;
        int number = Integer.parseInt(name.substring(name.indexOf('-') + 1));
        if (name.startsWith("hills")) {
            triangles = hills((int) Math.ceil(Math.sqrt(number / 2.0)));
        } else if (name.startsWith("field")) {
            field = field((int) Math.round(Math.sqrt(number)), HILLS * Math.sqrt(number / FIELD_POSTS));
        } else {
            walledBoxes(number, name.startsWith("hall") ? ROOM * Math.sqrt(number / SPARSE) : ROOM);
        }
        if (poses) {
            standSomewhere();
        }
    }

    private double between(double low, double high) {
        return low + random.nextDouble() * (high - low);
    }

    private void walledBoxes(int number, double side) {
        boxes = new double[number + 4][];
        for (int wall = 0; wall < 4; wall++) {
            double at = (wall % 2 == 0 ? 1 : -1) * (side + WALL) / 2;
            boxes[wall] = wall < 2 ? new double[] {side / 2, WALL_HEIGHT / 2, WALL / 2, 0, WALL_HEIGHT / 2,
                at, 0, 0, 0, 1}
                : new double[] {WALL / 2, WALL_HEIGHT / 2, side / 2, at, WALL_HEIGHT / 2, 0, 0, 0, 0, 1};
        }
        for (int i = 4; i < boxes.length; i++) {
            double half = side / 2 - 0.5;
            Pose turned = Pose.ofDegrees(between(-half, half), BEAM_HEIGHT, between(-half, half), between(-180, 180),
                between(-180, 180), between(-180, 180));
            boxes[i] = new double[] {between(0.125, 0.5), between(0.125, 0.5), between(0.125, 0.5), turned.x, turned.y,
                turned.z, turned.qx, turned.qy, turned.qz, turned.qw};
        }
    }

    private Triangles hills(int cells) {
        float[] vertices = new float[3 * (cells + 1) * (cells + 1)];
        int[] indices = new int[6 * cells * cells];
        double[] wave = random.doubles(12, 0, 2 * Math.PI).toArray();
        int v = 0;
        int n = 0;
        for (int i = 0; i <= cells; i++) {
            for (int j = 0; j <= cells; j++) {
                double x = HILLS * ((double) i / cells - 0.5);
                double z = HILLS * ((double) j / cells - 0.5);
                vertices[v++] = (float) x;
                vertices[v++] = height(wave, x, z);
                vertices[v++] = (float) z;
                if (i < cells && j < cells) {
                    int a = i * (cells + 1) + j;
                    int c = a + cells + 1;
                    for (int index : new int[] {a, a + 1, c + 1, a, c + 1, c}) {
                        indices[n++] = index;
                    }
                }
            }
        }
        return new Triangles(vertices, indices);
    }

    private static float height(double[] wave, double x, double z) {
        double y = 0;
        for (int k = 0; k < wave.length; k++) {
            y += Math.sin((0.4 + 0.15 * k) * (x * Math.cos(wave[k]) + z * Math.sin(wave[k])) + 7 * wave[k]);
        }
        return (float) (y / 4);
    }

    /** @param side length, metres */
    private HeightField field(int posts, double side) {
        double[] wave = random.doubles(12, 0, 2 * Math.PI).toArray();
        double spacing = side / (posts - 1);
        float[] heights = new float[posts * posts];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = height(wave, i / posts * spacing - side / 2, i % posts * spacing - side / 2);
        }
        return new HeightField(posts, posts, -side / 2, -side / 2, spacing, spacing, heights);
    }

    BeamScene scene() {
        BeamScene scene = new BeamScene();
        for (double[] b : boxes) {
            int shape = scene.addBox(b[0], b[1], b[2], BeamScene.WORLD);
            scene.setPose(shape, b[3], b[4], b[5], b[6], b[7], b[8], b[9]);
        }
        if (triangles != null) {
            scene.addMesh(triangles, 1, 1, 1, BeamScene.WORLD);
        }
        if (field != null) {
            scene.addHeights(field, BeamScene.WORLD);
        }
        scene.commit();
        return scene;
    }

    /** Chooses poses outside all boxes if possible, or a mast's height above the hills. */
    private void standSomewhere() {
        BeamScene scene = scene();
        double half = triangles != null ? HILLS / 4 : field != null ? -field.lowX / 2 : boxes[0][0] - 0.5;
        Hit hit = new Hit();
        for (int i = 0; i < POSES; i++) {
            double x;
            double z;
            double y = BEAM_HEIGHT;
            int tries = 0;
            boolean inside;
            do {
                x = between(-half, half);
                z = between(-half, half);
                inside = false;
                if (boxes.length == 0) {
                    y = 100 - scene.cast(x, 100, z, 0, -1, 0, 200, BeamScene.WORLD, null) + MAST;
                } else {
                    inside = scene.cast(x, y, z, 0, 0, 1, 1e3, BeamScene.WORLD, hit) < 1e3 && hit.nz > 0;
                }
            } while (inside && ++tries < 1000);
            poses[i] = Pose.ofDegrees(x, y, z, 0, between(-180, 180), 0);
        }
    }

    static double startAngle() {
        return -SPREAD / 2;
    }

    static double stepAngle() {
        return SPREAD / (BEAMS - 1);
    }

    /** Returns the directions of all rays of all poses, three numbers each. */
    double[] directions() {
        double[] out = new double[3 * BEAMS * POSES];
        int at = 0;
        for (Pose pose : poses) {
            for (int i = 0; i < BEAMS; i++) {
                double angle = startAngle() + i * stepAngle();
                System.arraycopy(pose.rotate(Math.sin(angle), 0, Math.cos(angle)), 0, out, at, 3);
                at += 3;
            }
        }
        return out;
    }

    double[] ranges() {
        BeamScene scene = scene();
        double[] all = new double[BEAMS * POSES];
        double[] fan = new double[BEAMS];
        for (int i = 0; i < POSES; i++) {
            scene.castFan(poses[i], startAngle(), stepAngle(), BEAMS, RANGE, BeamScene.WORLD, fan, null);
            System.arraycopy(fan, 0, all, i * BEAMS, BEAMS);
        }
        return all;
    }
}
