// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.stream.IntStream;
import org.SEAR.POJOs.BrownLens;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.Pose;
import org.SEAR.parallel.WorkerPool;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.solid.RayRound;
import org.junit.Test;

/** Pixels of the camera: lens, light, shadow, sky. */
public class CameraRendererTest {
    private static final int WIDTH = 64;
    private static final int HEIGHT = 48;
    private static final int GREY = 0x808080;

    private static CameraRenderer eye(double... distortion) {
        return new CameraRenderer(WIDTH, HEIGHT, lens(distortion), 0.01, 1000);
    }

    private static BrownLens lens(double... distortion) {
        return new BrownLens(50, 31.5, 23.5, distortion.length == 0 ? new double[4] : distortion);
    }

    /** A grey plate with a grey box above a part of it. */
    private static BeamScene plate() {
        BeamScene scene = new BeamScene();
        scene.setPose(scene.addBox(10, 0.1, 10, BeamScene.WORLD), 0, -0.1, 0, 0, 0, 0, 1);
        scene.setPose(scene.addBox(0.5, 0.5, 0.5, BeamScene.WORLD), 0, 1.5, 0, 0, 0, 0, 1);
        scene.commit();
        return scene;
    }

    private static final class Flat extends Appearance {
        private final double[] up;

        Flat(double... up) {
            super(20, true);
            this.up = up;
        }

        @Override
        protected void normal(SurfaceHit spot) {
            spot.setNormal(up[0], up[1], up[2]);
        }

        @Override
        protected void color(SurfaceHit spot) {
            spot.setColor(GREY);
        }
    }

    @Test
    public void aPixelLooksAlongItsRayOfTheLens() {
        double[] distortion = {-0.25, 0.06, 0.002, -0.001};
        BrownLens lens = lens(distortion);
        CameraRenderer eye = eye(distortion);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            assertEquals("column of pixel " + i, i % WIDTH, lens.column(-eye.left(i), -eye.up(i)), 1e-9);
            assertEquals("row of pixel " + i, i / WIDTH, lens.row(-eye.left(i), -eye.up(i)), 1e-9);
        }
        CameraRenderer plain = eye();
        assertEquals("the left edge, between two pixels", 31.5 / 50, plain.left(0), 1e-12);
        assertEquals(23.5 / 50, plain.up(0), 1e-12);
        assertTrue("a barrel shows more", eye.left(0) > plain.left(0) && eye.up(0) > plain.up(0));
    }

    @Test
    public void theSunLightsFacesTowardsItAndTheBoxCastsAShadow() {
        RenderJob down = new RenderJob(plate(), shape -> new Flat(0, 1, 0), Pose.ofDegrees(0, 0.9, 0, 90, 0, 0),
            BeamScene.WORLD);
        double[] sun = Daylight.toSun();
        int lit = (int) (128 * (Daylight.sky()[0] + Daylight.sun()[0] * sun[1]) + 0.5);
        int shaded = (int) (128 * (Daylight.sky()[0] + Daylight.sun()[0] * sun[1]) * (1 - Daylight.SHADOW) + 0.5);
        int[] picture = eye().colors(down);
        int dark = 0;
        for (int rgb : picture) {
            int red = rgb >> 16;
            assertTrue("red " + red + ", in the sun " + lit + ", in the shadow " + shaded, red == lit || red == shaded);
            dark += red == shaded ? 1 : 0;
        }
        double x = 1.0 * -sun[0] / sun[1];
        double z = 1.0 * -sun[2] / sun[1];
        assertTrue("the shadow is a metre wide, towards " + x + ", " + z, dark > 300 && dark < 2500);
        int away = eye().colors(new RenderJob(plate(), shape -> new Flat(0, -1, 0), Pose.ofDegrees(0, 0.9, 0, 90, 0, 0),
            BeamScene.WORLD))[0] >> 16;
        assertEquals("what looks away has the sky's light only", (int) (128 * Daylight.sky()[0] + 0.5), away);
    }

    @Test
    public void theSkyIsTheWindows() {
        RenderJob up = new RenderJob(new BeamScene(), shape -> null, Pose.ofDegrees(0, 1, 0, -30, 0, 0),
            BeamScene.WORLD);
        int middle = eye().colors(up)[24 * WIDTH + 32];
        float[] ring = Daylight.rings()[8];
        assertEquals(30, ring[0], 0);
        assertEquals(255 * ring[1], middle >> 16, 3);
        assertEquals(255 * ring[3], middle & 0xff, 3);
        int land = eye().colors(new RenderJob(new BeamScene(), shape -> null, Pose.ofDegrees(0, 1, 0, 60, 0, 0),
            BeamScene.WORLD))[0];
        assertTrue("below the horizon is land", (land >> 8 & 0xff) > (land & 0xff));
    }

    /**
     * Boxes and a cylinder on hills: each strip has the same pixels, whichever thread renders it and whatever it
     * rendered before.
     */
    @Test
    public void anyNumberOfThreadsMakesTheSameBytes() {
        float[] heights = new float[60 * 60];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (float) (0.3 * Math.sin(i / 60 * 0.3) * Math.cos(i % 60 * 0.2));
        }
        BeamScene scene = plate();
        scene.setPose(scene.addHeights(new HeightField(60, 60, -15, -15, 0.5, 0.5, heights), BeamScene.WORLD), 0, 0.2,
            0, 0, 0, 0, 1);
        scene.setPose(scene.addSolid(RayRound.cylinder(0.3, 0.8), BeamScene.WORLD), 1, 1, 3, 0, 0, 0, 1);
        scene.commit();
        BrownLens lens = new BrownLens(277, 159.5, 119.5, new double[] {-0.1, 0.01, 0, 0});
        RenderJob sight = new RenderJob(scene, shape -> new Flat(0, 1, 0), Pose.ofDegrees(0, 1, -4, 8, 10, 0),
            BeamScene.WORLD);
        CameraRenderer alone = new CameraRenderer(320, 240, lens, 0.01, 1000);
        int[] colors = alone.colors(sight);
        float[] depths = alone.depths(sight);
        assertTrue("hills, things and sky", IntStream.of(colors).distinct().count() > 100);
        for (int threads : new int[] {1, 2, 4}) {
            CameraRenderer eye = new CameraRenderer(320, 240, lens, 0.01, 1000);
            try (WorkerPool pool = new WorkerPool(threads)) {
                eye.setWorkers(pool);
                for (int picture = 0; picture < 3; picture++) {
                    assertArrayEquals(threads + " threads", colors, eye.colors(sight));
                    assertArrayEquals(threads + " threads", depths, eye.depths(sight), 0);
                }
            }
        }
    }

    @Test
    public void aStripAllocatesNothing() {
        Painter painter = new Painter(new org.SEAR.raycast.PictureBeams(8, new double[64], new double[64]),
            0.02, 0.01, 100);
        Appearance skin = new Flat(0, 1, 0);
        RenderJob down = new RenderJob(plate(), shape -> skin, Pose.ofDegrees(0, 0.9, 0, 90, 0, 0), BeamScene.WORLD);
        Appearance[] skins = {skin, skin};
        boolean[] casting = {true, true};
        int[] picture = new int[64];
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long id = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        for (int i = 0; i < 30; i++) {
            long before = threads.getThreadAllocatedBytes(id);
            painter.colors(down, 0, skins, casting, picture);
            least = Math.min(least, threads.getThreadAllocatedBytes(id) - before);
        }
        assertEquals(0, least);
        assertTrue(picture[0] != 0);
    }
}
