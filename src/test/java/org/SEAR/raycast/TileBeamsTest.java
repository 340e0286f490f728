// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.geometry.HeightTilesTest;
import org.SEAR.geometry.Pose;
import org.junit.Test;

/** Beams of all kinds hit tiles, to the bit, where they hit the field that the tiles are cut from. */
public class TileBeamsTest {
    private static final int HELD = 13;
    private static final double SPACING = 2;
    private static final int SIDE = 500;
    private static final int BEAMS = 361;
    private static final int WIDTH = 48;
    private static final int HEIGHT = 36;

    private final Random random = new Random(812);
    private final HeightField field = field();
    private final HeightTiles tiles = HeightTilesTest.of(field, HELD);
    private final BeamScene whole = scene(field);
    private final BeamScene cut = scene(tiles);

    private static HeightField field() {
        Random noise = new Random(3);
        float[] heights = new float[SIDE * SIDE];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (float) (30 * Math.sin(i / SIDE * 0.03) * Math.cos(i % SIDE * 0.02)
                + 0.7 * noise.nextDouble());
        }
        return new HeightField(SIDE, SIDE, -SIDE, -SIDE, SPACING, SPACING, heights);
    }

    private static BeamScene scene(HeightGrid grid) {
        BeamScene scene = new BeamScene();
        scene.addHeights(grid, BeamScene.WORLD);
        scene.addBox(3, 90, 5, BeamScene.WORLD);
        scene.setPose(1, 100, 0, 60, 0, 0, 0, 1);
        scene.commit();
        return scene;
    }

    private double between(double low, double high) {
        return low + random.nextDouble() * (high - low);
    }

    private Pose pose(int kind) {
        double x = kind % 5 == 0 ? field.x(256) : between(-480, 480);
        double z = kind % 7 == 0 ? field.z(384) : between(-480, 480);
        return Pose.ofDegrees(x, field.height(x, z) + between(0.3, kind % 3 == 0 ? 40 : 3), z, between(-180, 180),
            between(-12, 8), between(-5, 5));
    }

    @Test
    public void singleBeams() {
        Hit hit = new Hit();
        Hit expected = new Hit();
        int met = 0;
        for (int i = 0; i < 2000; i++) {
            Pose at = pose(i);
            double dx = i % 9 == 0 ? 0 : between(-1, 1);
            double dz = i % 11 == 0 ? 0 : between(-1, 1);
            double dy = i % 13 == 0 ? -1 : between(-0.2, 0.1);
            double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
            double range = i % 4 == 0 ? between(1, 500) : Double.POSITIVE_INFINITY;
            double t = whole.cast(at.x, at.y, at.z, dx / length, dy / length, dz / length, range,
                BeamScene.WORLD, expected);
            assertEquals(t, cut.cast(at.x, at.y, at.z, dx / length, dy / length, dz / length, range,
                BeamScene.WORLD, hit), 0);
            if (t < Double.POSITIVE_INFINITY) {
                met++;
                assertEquals(expected.shape, hit.shape);
                boolean edge = i % 5 == 0 && dx == 0 || i % 7 == 0 && dz == 0 || i % 13 == 0;
                if (!edge) {
                    assertArrayEquals(new double[] {expected.nx, expected.ny, expected.nz},
                        new double[] {hit.nx, hit.ny, hit.nz}, 0);
                }
            }
        }
        assertTrue("met " + met, met > 1200);
        assertTrue(tiles.held() <= HELD);
    }

    @Test
    public void fans() {
        double[] expected = new double[BEAMS];
        double[] ranges = new double[BEAMS];
        int[] shapesExpected = new int[BEAMS];
        int[] shapes = new int[BEAMS];
        for (int i = 0; i < 100; i++) {
            Pose at = pose(i);
            whole.castFan(at, -Math.PI / 2, Math.PI / (BEAMS - 1), BEAMS, 400, BeamScene.WORLD, expected,
                shapesExpected);
            cut.castFan(at, -Math.PI / 2, Math.PI / (BEAMS - 1), BEAMS, 400, BeamScene.WORLD, ranges, shapes);
            assertArrayEquals("fan " + i, expected, ranges, 0);
            assertArrayEquals("fan " + i, shapesExpected, shapes);
        }
    }

    private static PictureBeams pinhole() {
        double[] left = new double[WIDTH * HEIGHT];
        double[] up = new double[WIDTH * HEIGHT];
        for (int i = 0; i < left.length; i++) {
            left[i] = (WIDTH / 2.0 - i % WIDTH) / WIDTH;
            up[i] = (HEIGHT / 2.0 - i / WIDTH) / WIDTH;
        }
        return new PictureBeams(WIDTH, left, up);
    }

    @Test
    public void picturesAndTheirShadows() {
        PictureBeams beams = pinhole();
        int pixels = WIDTH * HEIGHT;
        int tilesOfPicture = beams.tilesAcross * beams.tilesDown;
        double[] expected = new double[pixels];
        double[] depths = new double[pixels];
        int[] shapesExpected = new int[pixels];
        int[] shapes = new int[pixels];
        int[] parts = new int[pixels];
        int met = 0;
        for (int i = 0; i < 12; i++) {
            Pose at = pose(i);
            whole.castPicture(beams, at, 0.1, 3000, BeamScene.WORLD, 0, tilesOfPicture, expected,
                shapesExpected, parts);
            cut.castPicture(beams, at, 0.1, 3000, BeamScene.WORLD, 0, tilesOfPicture, depths, shapes, parts);
            assertArrayEquals("picture " + i, expected, depths, 0);
            assertArrayEquals("picture " + i, shapesExpected, shapes);
            for (int shape : shapes) {
                met += shape == 0 ? 1 : 0;
            }
        }
        assertTrue("met " + met, met > pixels * 12 / 4);
        assertTrue(tiles.held() <= HELD);
    }

    @Test
    public void shadows() {
        int count = 600;
        double[] points = new double[3 * count];
        int[] own = new int[count];
        byte[] expected = new byte[count];
        byte[] lit = new byte[count];
        for (int i = 0; i < count; i++) {
            points[3 * i] = between(-300, 300);
            points[3 * i + 2] = between(-300, 300);
            points[3 * i + 1] = field.height(points[3 * i], points[3 * i + 2]);
            expected[i] = 1;
            lit[i] = 1;
        }
        double[] light = {0.8, 0.28, Math.sqrt(1 - 0.64 - 0.28 * 0.28)};
        whole.castShadows(light, new boolean[] {true, true}, points, own, expected, count);
        cut.castShadows(light, new boolean[] {true, true}, points, own, lit, count);
        assertArrayEquals(expected, lit);
        int dark = 0;
        for (byte one : lit) {
            dark += one == 0 ? 1 : 0;
        }
        assertTrue(dark + " in the shadow", dark > 20 && dark < count - 20);
    }

    @Test
    public void aBundleAndACopyOfTheScene() {
        double[] directions = {1, 0, 0, 0.6, -0.8, 0, 0, -1, 0};
        double[] ranges = {500, 500, 500};
        double[] expected = new double[1];
        double[] shortest = new double[1];
        BeamScene copy = cut.copy();
        for (int i = 0; i < 50; i++) {
            Pose at = pose(i);
            int line = whole.castBundle(at.x, at.y, at.z, directions, ranges, BeamScene.WORLD, expected);
            assertEquals(line, cut.castBundle(at.x, at.y, at.z, directions, ranges, BeamScene.WORLD, shortest));
            assertEquals(expected[0], shortest[0], 0);
            assertEquals(line, copy.castBundle(at.x, at.y, at.z, directions, ranges, BeamScene.WORLD, shortest));
            assertEquals(expected[0], shortest[0], 0);
        }
    }
}
