// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Floor;
import org.junit.Rule;
import org.junit.Test;

/** SEAR warns of a picture that its floor stretches, with the ratio and the size that fits. */
public class FloorPictureTest {
    private static final String TRACK = "track.png";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private void picture(int width, int height) throws IOException {
        Path file = project.folder().resolve("assets/" + TRACK);
        Files.createDirectories(file.getParent());
        ImageIO.write(new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB), "png", file.toFile());
    }

    private String warnings() throws Exception {
        return Project.read(project.folder()).getWarnings().toString();
    }

    @Test
    public void aPictureOfTheFloorsShapeIsFine() throws Exception {
        picture(70, 50);
        new Floor("board", 0.5, 0.7, TRACK);
        Floor scaled = new Floor("scaled", 0.25, 0.7, TRACK);
        scaled.scale(2, 1, 1);
        new Floor("nearly", 0.501, 0.7, TRACK);
        new Floor("tiles", 3, 7);
        new Floor("lawn", 3, 7, "textures/grass.png");
        assertEquals("[]", warnings());
    }

    @Test
    public void aStretchedPictureIsReportedWithTheSizeThatFits() throws Exception {
        picture(70, 50);
        new Floor("board", 0.7, 0.5, TRACK);
        new Floor("long", 2, 14, TRACK);
        assertEquals("[environment/board.xml: the picture track.png of Floor \"board\" is stretched 1.96 times in "
            + "height: it has 70 x 50 pixels, and the floor is 0.7 m long and 0.5 m wide; a width of 0.98 m fits,"
            + " environment/long.xml: the picture track.png of Floor \"long\" is stretched 5.00 times in width: it has "
            + "70 x 50 pixels, and the floor is 2 m long and 14 m wide; a width of 2.8 m fits]", warnings());
    }

    @Test
    public void aRepeatedPictureIsASquare() throws Exception {
        picture(70, 50);
        new Floor("board", 0.7, 0.5, TRACK).setImageSize(0.1);
        assertEquals("[environment/board.xml: the picture track.png of Floor \"board\" is stretched 1.40 times in "
            + "height: it has 70 x 50 pixels, and each repetition is a square]", warnings());
    }
}
