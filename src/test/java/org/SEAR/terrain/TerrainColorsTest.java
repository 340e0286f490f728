// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Terrain;
import org.SEAR.files.Assets;
import org.SEAR.terrain.relief.GroundPicture;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Default colours of a terrain. */
public class TerrainColorsTest {
    private static final int RED = 0xffff0000;
    private static final int BLUE = 0xff0000ff;
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private Assets assets;
    private Path files;
    private Terrain terrain;
    private Ground ground;

    @Before
    public void terrain() throws IOException {
        System.setProperty("sear.project", folder.getRoot().getPath());
        files = Files.createDirectories(folder.getRoot().toPath().resolve("assets"));
        assets = new Assets(files);
        terrain = new Terrain("land", "terrain/jacksboro.tif");
        ground = TerrainLoader.load(TerrainArea.of("terrain/jacksboro.tif", java.util.List.of())
            .around(36.485, -84.2308, 2000, 1000), assets);
    }

    /** Writes a picture: red in the north-west, blue elsewhere. */
    private void paint(String name) throws IOException {
        BufferedImage image = new BufferedImage(100, 200, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 100 * 200; i++) {
            image.setRGB(i % 100, i / 100, i % 100 < 50 && i / 100 < 100 ? RED : BLUE);
        }
        ImageIO.write(image, "png", files.resolve(name).toFile());
    }

    @Test
    public void anyPictureFillsTheAreaNorthUp() throws IOException {
        paint("aerial.png");
        terrain.setImage("aerial.png");
        GroundPicture.Colors colors = TerrainColors.of(terrain, assets, ground);
        assertEquals(RED, colors.at(900, -450));
        assertEquals(RED, colors.at(20, -20));
        assertEquals(BLUE, colors.at(-20, -20));
        assertEquals(BLUE, colors.at(20, 20));
        int between = colors.at(500, 0);
        assertTrue(Integer.toHexString(between), (between >> 16 & 0xff) > 30 && (between & 0xff) > 30);
    }

    @Test
    public void aColourCountsWithoutAPictureAndNeitherMeansByHeight() throws IOException {
        assertNull(TerrainColors.of(terrain, assets, ground));
        terrain.setColor("#102030");
        assertEquals(0xff102030, TerrainColors.of(terrain, assets, ground).at(0, 0));
    }

    @Test
    public void aPictureThatIsNoneIsNamed() throws IOException {
        Files.writeString(files.resolve("broken.png"), "no picture");
        terrain.setImage("broken.png");
        try {
            TerrainColors.of(terrain, assets, ground);
            fail("it was read");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("broken.png"));
        }
    }
}
