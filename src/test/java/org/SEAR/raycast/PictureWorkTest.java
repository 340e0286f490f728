// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Locale;
import java.util.Random;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.junit.Test;

/**
 * Cost of a picture's beams in tested blocks, triangles and boxes: work that neighbours share is done once per tile.
 */
public class PictureWorkTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 240;
    private static final double PITCH = 0.0036;
    private static final int POSTS = 317;
    private static final double SPACING = 0.0633;
    private static final double RANGE = 1000;

    private final double[] depths = new double[WIDTH * HEIGHT];
    private final int[] shapes = new int[WIDTH * HEIGHT];
    private final int[] parts = new int[WIDTH * HEIGHT];
    private final RayCaster work = BeamScene.casters().rays;

    private static PictureBeams beams() {
        double[] left = new double[WIDTH * HEIGHT];
        double[] up = new double[WIDTH * HEIGHT];
        for (int i = 0; i < left.length; i++) {
            left[i] = PITCH * ((WIDTH - 1) / 2.0 - i % WIDTH);
            up[i] = PITCH * ((HEIGHT - 1) / 2.0 - i / WIDTH);
        }
        return new PictureBeams(WIDTH, left, up);
    }

    private void cast(BeamScene scene, PictureBeams beams, Pose pose, double start) {
        scene.castPicture(beams, pose, start, RANGE, BeamScene.WORLD, 0, beams.tilesAcross * beams.tilesDown, depths,
            shapes, parts);
    }

    private static HeightField hills() {
        float[] heights = new float[POSTS * POSTS];
        for (int i = 0; i < heights.length; i++) {
            int row = i / POSTS;
            int column = i % POSTS;
            heights[i] = (float) (Math.sin(row * 0.08) * Math.cos(column * 0.06)
                + 0.3 * Math.sin(row * 0.21 + column * 0.17));
        }
        return new HeightField(POSTS, POSTS, -10, -10, SPACING, SPACING, heights);
    }

    @Test
    public void aPictureOfTerrainLooksAtFewBlocksAndTriangles() {
        HeightField field = hills();
        BeamScene scene = new BeamScene();
        scene.addHeights(field, BeamScene.WORLD);
        scene.commit();
        PictureBeams beams = beams();
        Random random = new Random(7);
        double[] picture = new double[2];
        double[] single = new double[2];
        int pictures = 20;
        for (int i = 0; i < pictures; i++) {
            double x = 10 * random.nextDouble() - 5;
            double z = 10 * random.nextDouble() - 5;
            Pose pose = Pose.ofDegrees(x, field.height(x, z) + 0.3, z, 10, 360 * random.nextDouble(), 0);
            long nodes = work.nodes();
            long triangles = work.triangles;
            cast(scene, beams, pose, 0.02);
            picture[0] += work.nodes() - nodes;
            picture[1] += work.triangles - triangles;
            nodes = work.nodes();
            triangles = work.triangles;
            for (int pixel = i; pixel < WIDTH * HEIGHT; pixel += 20) {
                double[] way = pose.rotate(beams.left(pixel), beams.up(pixel), 1);
                scene.cast(pose.x, pose.y, pose.z, way[0], way[1], way[2], RANGE, BeamScene.WORLD, null);
            }
            single[0] += 20.0 * (work.nodes() - nodes);
            single[1] += 20.0 * (work.triangles - triangles);
        }
        double pixels = (double) pictures * WIDTH * HEIGHT;
        String measured = String.format(Locale.ROOT, "%.2f blocks and %.2f triangles a pixel; one by one it is "
            + "%.1f and %.1f", picture[0] / pixels, picture[1] / pixels, single[0] / pixels, single[1] / pixels);
        assertTrue(measured, picture[0] < 2.2 * pixels && picture[1] < 4 * pixels && picture[0] < single[0] / 8);
    }

    @Test
    public void groundThatIsTurnedIsMetWhereSingleBeamsMeetIt() {
        HeightField field = hills();
        PictureBeams beams = beams();
        Random random = new Random(11);
        int met = 0;
        for (int i = 0; i < 6; i++) {
            BeamScene scene = new BeamScene();
            Pose ground = Pose.ofDegrees(3, 1, -2, 40 * random.nextDouble(), 360 * random.nextDouble(),
                40 * random.nextDouble());
            scene.setPose(scene.addHeights(field, BeamScene.WORLD), ground.x, ground.y, ground.z, ground.qx, ground.qy,
                ground.qz, ground.qw);
            scene.commit();
            Pose pose = ground.times(Pose.ofDegrees(2 * random.nextDouble(), 2 - i, 1, 60 * random.nextDouble() - 20,
                360 * random.nextDouble(), 15));
            double start = i % 2 == 0 ? 0 : 0.5;
            cast(scene, beams, pose, start);
            for (int pixel = i; pixel < depths.length; pixel += 37) {
                double length = Math.sqrt(1 + beams.left(pixel) * beams.left(pixel)
                    + beams.up(pixel) * beams.up(pixel));
                double[] way = pose.rotate(beams.left(pixel) / length, beams.up(pixel) / length, 1 / length);
                double[] from = pose.transform(start * beams.left(pixel), start * beams.up(pixel), start);
                double single = scene.cast(from[0], from[1], from[2], way[0], way[1], way[2], (RANGE - start) * length,
                    BeamScene.WORLD, null);
                assertEquals("picture " + i + ", pixel " + pixel, start + single / length, depths[pixel], 1e-9);
                met += single < RANGE ? 1 : 0;
            }
        }
        assertTrue("so few have met the ground: " + met, met > 4000);
    }

    @Test
    public void mostBoxesAreAskedForOneOfTheirSides() {
        Random random = new Random(3);
        BeamScene scene = new BeamScene();
        scene.setPose(scene.addBox(5, 0.05, 5, BeamScene.WORLD), 0, -0.05, 0, 0, 0, 0, 1);
        for (int wall = 0; wall < 4; wall++) {
            double at = wall % 2 == 0 ? 5.05 : -5.05;
            boolean across = wall < 2;
            scene.setPose(scene.addBox(across ? 5 : 0.05, 1, across ? 0.05 : 5, BeamScene.WORLD), across ? 0 : at, 1,
                across ? at : 0, 0, 0, 0, 1);
        }
        for (int i = 0; i < 20; i++) {
            double around = Math.toRadians(18 * i);
            Pose pose = Pose.ofDegrees(3.5 * Math.sin(around), 0.4, 3.5 * Math.cos(around), 0,
                360 * random.nextDouble(), 20);
            scene.setPose(scene.addBox(0.3, 0.4, 0.2, BeamScene.WORLD), pose.x, pose.y, pose.z, pose.qx, pose.qy,
                pose.qz, pose.qw);
        }
        scene.commit();
        PictureBeams beams = beams();
        long boxes = work.boxes;
        long asked = work.asked;
        double tiles = 0;
        for (int turn = 0; turn < 360; turn += 30) {
            cast(scene, beams, Pose.ofDegrees(0, 0.3, 0, 10, turn, 0), 0);
            tiles += beams.tilesAcross * beams.tilesDown;
        }
        String measured = (work.boxes - boxes) / tiles + " boxes a tile, of " + (work.asked - asked) / tiles
            + " all sides";
        assertTrue(measured, work.boxes - boxes < 1.5 * tiles && work.asked - asked < 0.4 * tiles);
    }

    @Test
    public void testsOfOneOrAllSidesAgreeToTheBit() {
        BeamScene scene = new BeamScene();
        scene.setPose(scene.addBox(5, 0.05, 5, BeamScene.WORLD), 0, -0.05, 0, 0, 0, 0, 1);
        Pose turned = Pose.ofDegrees(0.4, 0.5, 2, 10, 30, 20);
        scene.setPose(scene.addBox(0.3, 0.4, 0.2, BeamScene.WORLD), turned.x, turned.y, turned.z, turned.qx, turned.qy,
            turned.qz, turned.qw);
        scene.commit();
        PictureBeams all = beams();
        Pose pose = Pose.ofDegrees(0, 0.3, 0, 10, 5, 0);
        cast(scene, all, pose, 0);
        double[] left = new double[WIDTH * HEIGHT];
        double[] up = new double[WIDTH * HEIGHT];
        // The same beams in another order: the beams of a tile are far apart and test all sides.
        for (int i = 0; i < left.length; i++) {
            left[i] = all.left(mixed(i));
            up[i] = all.up(mixed(i));
        }
        double[] wanted = new double[left.length];
        for (int i = 0; i < left.length; i++) {
            wanted[i] = depths[mixed(i)];
        }
        long asked = work.asked;
        cast(scene, new PictureBeams(WIDTH, left, up), pose, 0);
        assertTrue(work.asked - asked > all.tilesAcross * all.tilesDown);
        assertArrayEquals(wanted, depths, 0);
    }

    /** Returns a permutation that places neighbours far apart. */
    private static int mixed(int i) {
        return (int) (i * 30_011L % (WIDTH * HEIGHT));
    }
}
