// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertTrue;

import com.jme3.math.Vector3f;
import com.sun.management.OperatingSystemMXBean;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.TimeUnit;
import org.SEAR.POJOs.Terrain;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.view.terrain.TerrainView;
import org.junit.Test;
import org.junit.runner.RunWith;

/** A terrain in the window: a whole SRTM tile of 3601 x 3601 samples. */
@RunWith(UnderXvfb.class)
public class TerrainPictureTest {
    private static final int POSTS = 3601;
    private static final int MEASURED = 25;

    private Views open(Path project) throws Exception {
        Views view = new Views(project, new WindowOptions().setSize(1024, 640));
        view.world.runner.setPaused(true);
        return view;
    }

    private static Path folder() throws IOException {
        Path folder = Files.createTempDirectory("terrain").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        Files.createDirectories(folder.resolve("assets"));
        return folder;
    }

    /** Makes mountains like those of an SRTM tile. */
    private static Path mountains() throws IOException {
        Path folder = folder();
        ByteBuffer posts = ByteBuffer.allocate(2 * POSTS * POSTS);
        for (int row = 0; row < POSTS; row++) {
            for (int column = 0; column < POSTS; column++) {
                double x = row / 97.0;
                double z = column / 83.0;
                double height = 900 + 500 * Math.sin(x) * Math.cos(z) + 180 * Math.sin(3.7 * x + z) * Math.sin(2.9 * z)
                    + 50 * Math.sin(11.3 * x) * Math.cos(12.7 * z - x) + 12 * Math.sin(31 * x + 5 * z)
                    * Math.sin(29 * z);
                posts.putShort((short) height);
            }
        }
        posts.flip();
        try (FileChannel file = FileChannel.open(folder.resolve("assets/N46E007.hgt"), StandardOpenOption.CREATE,
            StandardOpenOption.WRITE)) {
            file.write(posts);
        }
        new Terrain("Alps", "N46E007.hgt");
        return folder;
    }

    private static void fly(Views view, float x, float y, float z, float yaw, float pitch) throws Exception {
        view.ask(() -> {
            view.scene().camera().fly(new Vector3f(x, y, z), yaw, pitch);
            return null;
        });
        view.frames(3);
    }

    /** Returns the CPU time of the whole process per picture, ms. */
    private static double cost(Views view) {
        OperatingSystemMXBean system = (OperatingSystemMXBean) ManagementFactory.getOperatingSystemMXBean();
        view.frames(3);
        long frames = view.app().frames;
        long before = system.getProcessCpuTime();
        view.frames(MEASURED);
        return (system.getProcessCpuTime() - before) / (double) TimeUnit.MILLISECONDS.toNanos(1) / (
            view.app().frames - frames);
    }

    @Test
    public void aWholeTileIsSeenToItsHorizonAtAFewTimesTheCostOfAnEmptyWorld() throws Exception {
        Path empty = folder();
        double nothing;
        try (Views view = open(empty)) {
            nothing = cost(view);
        }
        try (Views view = open(mountains())) {
            TerrainView terrain = view.scene().terrain();
            HeightGrid field = terrain.field();
            float ground = (float) field.height(3000, 2000);
            fly(view, 3000, ground + 1.5f, 2000, 0.7f, 0.05f);
            double near = cost(view);
            BufferedImage picture = view.picture("terrain-near");
            Color below = Colors.mean(picture, 512, 600);
            assertTrue("ground: " + below, below.getGreen() > below.getBlue() + 10);
            fly(view, -45_000, 3200, -30_000, 0.7f, 0.12f);
            double far = cost(view);
            picture = view.picture("terrain-far");
            Color sky = Colors.mean(picture, 512, 60);
            Color land = Colors.mean(picture, 512, 560);
            assertTrue("sky: " + sky, sky.getBlue() > sky.getRed() + 20);
            assertTrue("land: " + land, land.getGreen() > land.getBlue());
            System.out.printf("a picture costs %.0f ms of a processor without terrain, %.0f on it, %.0f above it; %d "
                + "tiles seen, %d kept%n", nothing, near, far, terrain.seen(), terrain.kept());
            assertTrue("on it " + near + " ms, without " + nothing, near < 15 * nothing);
            assertTrue("above it " + far + " ms, without " + nothing, far < 15 * nothing);
            long made = terrain.made();
            view.frames(20);
            assertTrue("a camera at rest makes no tiles", terrain.made() == made);
        }
    }
}
