// SPDX-License-Identifier: Apache-2.0
package org.SEAR.files;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Generated pictures of markers and chessboards, which need no file. */
public class MadePicturesTest {
    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private BufferedImage read(String path) throws IOException {
        return ImageIO.read(new ByteArrayInputStream(new Assets(folder.getRoot().toPath()).readPicture(path)));
    }

    /** Returns the cells row by row; # is black. */
    private static String cells(BufferedImage image, int columns) {
        int size = image.getWidth() / columns;
        StringBuilder text = new StringBuilder();
        for (int row = 0; row < image.getHeight() / size; row++) {
            for (int column = 0; column < columns; column++) {
                int rgb = image.getRGB(column * size, row * size) & 0xffffff;
                assertTrue("black or paper", rgb == 0 || rgb == 0xc1c1c1);
                for (int i = 0; i < size * size; i++) {
                    assertEquals("sharp", rgb, image.getRGB(column * size + i % size, row * size + i / size)
                        & 0xffffff);
                }
                text.append(rgb == 0 ? '#' : '.');
            }
            text.append('\n');
        }
        return text.toString();
    }

    @Test
    public void aMarkerHasItsCodeABlackEdgeAndAWhiteMargin() throws IOException {
        assertEquals(String.join("\n", "........", ".######.", ".#.#..#.", ".##.#.#.", ".###..#.", ".###.##.",
            ".######.", "........", ""), cells(read("made/marker/DICT_4X4_50/0.png"), 8));
        String tag = cells(read("made/marker/APRILTAG_36h11/0.png"), 10);
        assertEquals(String.join("\n", "..........", ".########.", ".###.####.", ".##..#.##.", ".####.#.#.",
            ".####..##.", ".#.#...##.", ".#.#.#..#.", ".########.", "..........", ""), tag);
    }

    @Test
    public void aChessboardBeginsWithABlackSquareAtTheTopLeft() throws IOException {
        assertEquals(String.join("\n", "......", ".#.#..", "..#.#.", ".#.#..", "......", ""),
            cells(read("./made/chessboard/4x3.png"), 6));
        assertEquals("as large as pages show", 496, read("made/chessboard/60x10.png").getWidth());
    }

    @Test
    public void theTestCardHasEightColours() throws IOException {
        BufferedImage card = read("made/testcard.png");
        int[] colors = new int[8];
        for (int i = 0; i < colors.length; i++) {
            colors[i] = card.getRGB((2 * i + 1) * card.getWidth() / 16, card.getHeight() / 2) & 0xffffff;
        }
        assertArrayEquals(new int[] {0xffffff, 0xffff00, 0x00ffff, 0x00ff00, 0xff00ff, 0xff0000, 0x0000ff, 0}, colors);
    }

    @Test
    public void otherNamesHaveNoPicture() throws IOException {
        Assets assets = new Assets(folder.getRoot().toPath());
        for (String path : new String[] {"made/marker/DICT_4X4_50/50.png", "made/marker/DICT_4X5_50/0.png",
            "made/marker/DICT_8X8_50/0.png",
            "made/marker/APRILTAG_36h11/587.png", "made/chessboard/100x1.png", "made/chessboard/4x3.jpg", "made/",
                "made/testcard.png/x"}) {
            assertFalse(path, assets.has(path));
        }
        assertTrue(assets.has("made/marker/DICT_7X7_1000/999.png"));
        Path own = Files.createDirectories(folder.getRoot().toPath().resolve("made/chessboard")).resolve("4x3.png");
        Files.write(own, assets.readPicture("made/testcard.png"));
        assertEquals("a project's own file comes first", 512, read("made/chessboard/4x3.png").getWidth());
    }
}
