// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import org.SEAR.geometry.Pose;
import org.junit.Test;

/** The beams of a picture return the results of single beams, whatever the tiles, the hierarchy and earlier casts. */
public class PictureBeamsTest {
    private static final double NEAR = 1e-9;

    /** Returns the beams of a pinhole camera; the last beam of a row is bent slightly, as by a lens. */
    private static PictureBeams beams(int width, int height, double pitch) {
        double[] left = new double[width * height];
        double[] up = new double[width * height];
        for (int i = 0; i < left.length; i++) {
            left[i] = pitch * ((width - 1) / 2.0 - i % width);
            up[i] = pitch * ((height - 1) / 2.0 - i / width) + 1e-3 * left[i] * left[i];
        }
        return new PictureBeams(width, left, up);
    }

    private static final class Cast {
        final double[] depths;
        final int[] shapes;
        final int[] parts;

        Cast(BeamScene scene, PictureBeams beams, Pose pose, double start, double range) {
            int count = beams.width * beams.height;
            depths = new double[count];
            shapes = new int[count];
            parts = new int[count];
            scene.castPicture(beams, pose, start, range, BeamScene.WORLD, 0, beams.tilesAcross * beams.tilesDown,
                depths, shapes, parts);
        }
    }

    @Test
    public void depthsAreThoseOfSingleBeams() {
        Hit hit = new Hit();
        int met = 0;
        for (long seed = 1; seed <= 200; seed++) {
            RandomScenes world = new RandomScenes(seed);
            world.shapes(1 + world.random.nextInt(40), 4);
            PictureBeams beams = beams(1 + world.random.nextInt(30), 1 + world.random.nextInt(30),
                world.between(0.002, 0.2));
            Pose pose = world.pose(4);
            double range = world.between(1, 8);
            Cast cast = new Cast(world.scene, beams, pose, 0, range);
            for (int i = 0; i < cast.depths.length; i++) {
                double length = Math.sqrt(1 + beams.left(i) * beams.left(i) + beams.up(i) * beams.up(i));
                double[] way = pose.rotate(beams.left(i) / length, beams.up(i) / length, 1 / length);
                hit.shape = -1;
                double single = world.scene.cast(pose.x, pose.y, pose.z, way[0], way[1], way[2], range * length,
                    BeamScene.WORLD, hit);
                assertEquals("seed " + seed + ", pixel " + i, single / length, cast.depths[i], NEAR);
                assertEquals("seed " + seed + ", pixel " + i, hit.shape, cast.shapes[i]);
                met += hit.shape >= 0 ? 1 : 0;
            }
        }
        assertTrue("so few have met something: " + met, met > 5000);
    }

    @Test
    public void beamsThatBeginFurtherAheadSkipNearerObjects() {
        for (long seed = 1; seed <= 100; seed++) {
            RandomScenes world = new RandomScenes(seed);
            world.shapes(20, 3);
            PictureBeams beams = beams(17, 9, 0.05);
            Pose pose = world.pose(3);
            double start = world.between(0, 2);
            Cast cast = new Cast(world.scene, beams, pose, start, 20);
            for (int i = 0; i < cast.depths.length; i++) {
                double length = Math.sqrt(1 + beams.left(i) * beams.left(i) + beams.up(i) * beams.up(i));
                double[] way = pose.rotate(beams.left(i) / length, beams.up(i) / length, 1 / length);
                double[] from = pose.transform(start * beams.left(i), start * beams.up(i), start);
                double single = world.scene.cast(from[0], from[1], from[2], way[0], way[1], way[2],
                    (20 - start) * length, BeamScene.WORLD, null);
                assertEquals("seed " + seed + ", pixel " + i, start + single / length, cast.depths[i], NEAR);
            }
        }
    }

    @Test
    public void theSameBytesInHoweverManyPiecesAndAfterMovesOfAll() {
        for (long seed = 1; seed <= 40; seed++) {
            RandomScenes world = new RandomScenes(seed);
            world.shapes(40, 4);
            PictureBeams beams = beams(50, 37, 0.03);
            Pose pose = world.pose(3);
            Cast whole = new Cast(world.scene, beams, pose, 0.1, 9);
            Cast pieces = new Cast(world.scene, beams, Pose.IDENTITY, 0, 3);
            for (int at = beams.tilesDown - 1; at >= 0; at--) {
                strip(world.scene, beams, pose, at, pieces);
            }
            assertSame("seed " + seed + ", strip by strip", whole, pieces);
            double[][] frames = new double[world.scene.size()][12];
            Pose[] back = new Pose[frames.length];
            for (int shape = 0; shape < frames.length; shape++) {
                world.scene.frame(shape, frames[shape]);
                back[shape] = poseOf(world.scene, shape);
            }
            for (int turn = 0; turn < 5; turn++) {
                for (int shape = 0; shape < frames.length; shape++) {
                    world.place(shape, turn < 4 ? world.pose(4) : back[shape]);
                }
                world.scene.commit();
            }
            assertSame("seed " + seed + ", by a worn hierarchy", whole, new Cast(world.scene, beams, pose, 0.1, 9));
        }
    }

    /** Casts a row of tiles one by one from the right. */
    private static void strip(BeamScene scene, PictureBeams beams, Pose pose, int row, Cast into) {
        int count = beams.width * PictureBeams.TILE;
        double[] depths = new double[count];
        int[] shapes = new int[count];
        int[] parts = new int[count];
        for (int tile = (row + 1) * beams.tilesAcross - 1; tile >= row * beams.tilesAcross; tile--) {
            scene.castPicture(beams, pose, 0.1, 9, BeamScene.WORLD, tile, tile + 1, depths, shapes, parts);
        }
        int first = row * count;
        int rest = Math.min(count, into.depths.length - first);
        System.arraycopy(depths, 0, into.depths, first, rest);
        System.arraycopy(shapes, 0, into.shapes, first, rest);
        System.arraycopy(parts, 0, into.parts, first, rest);
    }

    private static Pose poseOf(BeamScene scene, int shape) {
        double[] pose = new double[BeamScene.POSE * scene.size()];
        scene.poses(pose);
        int at = BeamScene.POSE * shape;
        return new Pose(pose[at], pose[at + 1], pose[at + 2], pose[at + 3], pose[at + 4], pose[at + 5], pose[at + 6]);
    }

    private static void assertSame(String what, Cast wanted, Cast cast) {
        assertArrayEquals(what, wanted.depths, cast.depths, 0);
        assertArrayEquals(what, wanted.shapes, cast.shapes);
        assertArrayEquals(what, wanted.parts, cast.parts);
    }

    @Test
    public void aCopyAnswersTheSameAndStaysWhenTheSceneMoves() {
        RandomScenes world = new RandomScenes(5);
        world.shapes(30, 4);
        world.scene.setVisible(3, false);
        world.scene.commit();
        PictureBeams beams = beams(64, 48, 0.03);
        Pose pose = world.pose(3);
        Cast before = new Cast(world.scene, beams, pose, 0, 9);
        BeamScene copy = world.scene.copy();
        double[] poses = new double[BeamScene.POSE * world.scene.size()];
        world.scene.poses(poses);
        for (int shape = 0; shape < 30; shape++) {
            world.place(shape, world.pose(4));
        }
        world.scene.commit();
        assertSame("the copy", before, new Cast(copy, beams, pose, 0, 9));
        double[] later = new double[poses.length];
        world.scene.poses(later);
        copy.setPoses(later);
        assertSame("the copy that followed", new Cast(world.scene, beams, pose, 0, 9),
            new Cast(copy, beams, pose, 0, 9));
        copy.setPoses(poses);
        assertSame("the copy that went back", before, new Cast(copy, beams, pose, 0, 9));
    }

    @Test
    public void shadowsAreWhereABeamToTheLightMeetsSomething() {
        int shaded = 0;
        for (long seed = 1; seed <= 200; seed++) {
            RandomScenes world = new RandomScenes(seed);
            world.shapes(30, 3);
            double[] light = world.pose(1).rotate(0, 0, 1);
            boolean[] casting = new boolean[30];
            for (int i = 0; i < casting.length; i++) {
                casting[i] = world.random.nextInt(5) > 0;
            }
            int count = 40;
            double[] points = new double[3 * count];
            int[] own = new int[count];
            byte[] lit = new byte[count];
            for (int i = 0; i < count; i++) {
                for (int axis = 0; axis < 3; axis++) {
                    points[3 * i + axis] = world.between(-1, 1);
                }
                own[i] = -1;
                lit[i] = (byte) (world.random.nextInt(4) > 0 ? 1 : 0);
            }
            byte[] asked = lit.clone();
            world.scene.castShadows(light, casting, points, own, lit, count);
            for (int i = 0; i < count; i++) {
                boolean free = true;
                for (int shape = 0; shape < casting.length; shape++) {
                    free &= !casting[shape] || BeamScene.casters().rays.test(world.scene.shapes(), shape, points[3 * i],
                        points[3 * i + 1],
                        points[3 * i + 2], light[0], light[1], light[2], Double.MAX_VALUE) == Double.POSITIVE_INFINITY;
                }
                assertEquals("seed " + seed + ", point " + i, asked[i] == 1 && free ? 1 : 0, lit[i]);
                shaded += asked[i] - lit[i];
            }
        }
        assertTrue("so few are in the shadow: " + shaded, shaded > 500);
    }

    @Test
    public void aPictureAllocatesNothing() {
        RandomScenes world = new RandomScenes(3);
        world.shapes(30, 4);
        PictureBeams beams = beams(64, 48, 0.03);
        Pose pose = world.pose(3);
        Cast cast = new Cast(world.scene, beams, pose, 0, 9);
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int i = 0; i < 20; i++) {
            long before = threads.getThreadAllocatedBytes(id);
            world.scene.castPicture(beams, pose, 0, 9, BeamScene.WORLD, 0, beams.tilesAcross * beams.tilesDown,
                cast.depths, cast.shapes, cast.parts);
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        assertEquals(0, least);
    }

    @Test
    public void aPictureIsARectangle() {
        String message = assertThrows(IllegalArgumentException.class,
            () -> new PictureBeams(3, new double[4], new double[4])).getMessage();
        assertEquals("picture of 4 left and 4 up coordinates in rows of 3, legal: equal numbers, one or more full rows "
            + "of 1 or more", message);
        assertThrows(IllegalArgumentException.class, () -> new PictureBeams(1, new double[4], new double[3]));
        assertThrows(IllegalArgumentException.class, () -> new PictureBeams(0, new double[0], new double[0]));
    }
}
