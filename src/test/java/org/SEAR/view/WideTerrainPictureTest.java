// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import com.jme3.math.Vector3f;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Files;
import java.nio.file.Path;
import org.SEAR.POJOs.Terrain;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.terrain.WideMap;
import org.junit.Test;
import org.junit.runner.RunWith;

/** A terrain of 10812 x 10812 samples in the window, in a heap of 192 MB. */
@RunWith(UnderXvfb.class)
public class WideTerrainPictureTest {
    private static final int WIDE = 10812;

    private static void fly(Views view, float x, float y, float z, float yaw, float pitch) throws Exception {
        view.ask(() -> {
            view.scene().camera().fly(new Vector3f(x, y, z), yaw, pitch);
            return null;
        });
        view.frames(3);
    }

    @Test
    public void groundThatIsTooLargeForTheMemoryIsSeenFromAnywhere() throws Exception {
        Path folder = Files.createTempDirectory("wide").resolve("SEARproject");
        System.setProperty("sear.project", folder.toString());
        Files.createDirectories(folder.resolve("assets"));
        new WideMap(WIDE).write(folder.resolve("assets/wide.tif"));
        new Terrain("wide", "wide.tif");
        try (Views view = new Views(folder, new WindowOptions().setSize(1024, 640))) {
            view.world.runner.setPaused(true);
            HeightTiles ground = (HeightTiles) view.scene().terrain().field();
            float there = (float) ground.height(120_000, -90_000);
            fly(view, 120_000, there + 1.5f, -90_000, 0.7f, 0.05f);
            BufferedImage picture = view.picture("terrain-wide-near");
            Color below = Colors.mean(picture, 512, 600);
            assertTrue("ground: " + below, below.getGreen() > below.getBlue() + 10);
            long made = ground.made();
            view.frames(20);
            assertEquals("a camera at rest brings no ground", made, ground.made());
            fly(view, -45_000, ground.highest() + 1200, -30_000, 0.7f, 0.12f);
            picture = view.picture("terrain-wide-far");
            Color sky = Colors.mean(picture, 512, 60);
            assertTrue("sky: " + sky, sky.getBlue() > sky.getRed() + 20);
            Color land = Colors.mean(picture, 512, 560);
            assertTrue("land: " + land, land.getGreen() > land.getBlue());
            assertTrue(ground.held() <= HeightTiles.room());
        }
    }
}
