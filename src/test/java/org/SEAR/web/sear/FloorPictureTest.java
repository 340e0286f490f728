// SPDX-License-Identifier: Apache-2.0
package org.SEAR.web.sear;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.SEAR.web.SearPage;
import org.junit.Test;

/** The map shows the picture of a floor in the same orientation as the view in space. */
public class FloorPictureTest extends SearPage {
    private static final int HALF = 64;
    private static final int RED = 0xd00000;
    private static final int GREEN = 0x00d000;
    private static final int BLUE = 0x0000d0;
    private static final int YELLOW = 0xd0d000;
    private static final int TOLERANCE = 40;

    /** Writes a picture: red and green above, blue and yellow below. */
    private static void paint(Path file) throws IOException {
        BufferedImage image = new BufferedImage(2 * HALF, 2 * HALF, BufferedImage.TYPE_INT_RGB);
        int[][] quarters = {{RED, GREEN}, {BLUE, YELLOW}};
        for (int y = 0; y < 2 * HALF; y++) {
            for (int x = 0; x < 2 * HALF; x++) {
                image.setRGB(x, y, quarters[y / HALF][x / HALF]);
            }
        }
        Files.createDirectories(file.getParent());
        ImageIO.write(image, "png", file.toFile());
    }

    private void floor(String... more) throws IOException {
        robotLab.run("from org.SEAR.POJOs import Floor\nsear.newProject()");
        browser.until("an empty project", () -> tab.isTrue("world.shown() && world.isEmpty()"));
        paint(robotLab.file("SEARproject/assets/textures/quarters.png"));
        robotLab.run("floor = Floor('floor', 4, 2, 'textures/quarters.png')\n" + String.join("\n", more));
        browser.until("the floor", () ->
            tab.isTrue("world.shown() && world.shown().objects.length == 1 && view.fitted"));
    }

    private void see(int colour, double x, double z) {
        browser.until(String.format("%06x at %s, %s", colour, x, z), () -> {
            long seen = tab.colour(x, z) >> 8;
            return IntStream.of(16, 8, 0).allMatch(shift -> Math.abs((seen >> shift & 0xff) - (colour >> shift & 0xff))
                < TOLERANCE);
        });
    }

    /** Its right edge is at -z, its upper one at -x, see BoxSolid. */
    @Test
    public void aPictureLiesOnItsFloor() throws IOException {
        floor();
        see(RED, -1.2, 0.6);
        see(GREEN, -1.2, -0.6);
        see(BLUE, 1.2, 0.6);
        see(YELLOW, 1.2, -0.6);
    }

    @Test
    public void aFinePictureIsRepeated() throws IOException {
        floor("floor.setImageSize(1)");
        for (int i = 0; i < 4; i++) {
            see(RED, -1.75 + i, 0.75);
            see(YELLOW, -1.25 + i, 0.25);
        }
    }
}
