// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.util.Base64;
import java.util.List;
import java.util.Random;
import javax.imageio.ImageIO;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightField;
import org.junit.Test;

/** Ground in the format for panels: one message of bounded size, exact within its grid's resolution. */
public class TerrainJsonTest {
    private static final String JPEG = "data:image/jpeg;base64,";
    /** MyRobotLab's limit of a message, bytes. */
    private static final int MESSAGE = 1 << 20;

    private static HeightField field(int rows, int columns, double spacing, boolean noise) {
        Random random = new Random(3);
        float[] heights = new float[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = noise ? 100 * random.nextFloat()
                : (float) (0.2 * (i / columns) * spacing - 0.1 * (i % columns) * spacing);
        }
        return new HeightField(rows, columns, -(rows - 1) * spacing / 2, -(columns - 1) * spacing / 2, spacing,
            spacing, heights);
    }

    @Test
    public void theRoughestGroundFitsIntoAMessage() throws Exception {
        TerrainJson ground = new TerrainJson("stamp", field(2000, 1500, 1, true), new GeoOrigin(46, 1000, 7),
            1000, 0, null);
        byte[] picture = Base64.getDecoder().decode(ground.picture.substring(JPEG.length()));
        assertTrue(picture.length + " bytes", picture.length <= TerrainJson.PICTURE_BYTES);
        BufferedImage image = ImageIO.read(new ByteArrayInputStream(picture));
        assertTrue(image.getHeight() <= TerrainJson.PICTURE_PIXELS && image.getHeight() > 200);
        assertEquals("it has the area's shape", 0.75, (double) image.getWidth() / image.getHeight(), 0.01);
        int characters = new com.fasterxml.jackson.databind.ObjectMapper().writeValueAsString(ground.map()).length();
        assertTrue(characters + " characters", characters < 0.75 * MESSAGE);
    }

    @Test
    public void heightsAreTheFieldsFromTheSouthWestOn() {
        HeightField field = field(50, 40, 10, false);
        TerrainJson ground = new TerrainJson("stamp", field, null, 0, 0, null);
        byte[] heights = Base64.getDecoder().decode(ground.heights);
        assertEquals(50, ground.rows);
        assertEquals(40, ground.columns);
        double low = ground.lowest;
        double high = ground.highest;
        for (int i = 0; i < 50 * 40; i++) {
            int value = heights[2 * i] & 0xff | (heights[2 * i + 1] & 0xff) << 8;
            assertEquals(field.heights[i], low + value * (high - low) / 65535, (high - low) / 65535);
        }
        assertEquals(field.x(49), ground.north, 0);
        assertEquals(field.z(0), ground.west, 0);
        assertFalse("no place on Earth", ground.places.isPresent());
        assertFalse(ground.altitude.isPresent());
    }

    @Test
    public void interpolatedPlacesAreRightToAMetreOverAHundredKilometres() {
        HeightField field = field(101, 101, 1000, false);
        GeoOrigin origin = new GeoOrigin(60, 200, 179.9);
        List<double[]> places = new TerrainJson("stamp", field, origin, 200, 0, null).places.orElseThrow();
        assertEquals(TerrainJson.PLACES * TerrainJson.PLACES, places.size());
        double step = 100_000.0 / (TerrainJson.PLACES - 1);
        for (int row = 0; row < TerrainJson.PLACES - 1; row += 5) {
            for (int column = 0; column < TerrainJson.PLACES - 1; column += 5) {
                double[] middle = new double[2];
                for (int corner = 0; corner < 4; corner++) {
                    double[] place = places.get((row + corner / 2) * TerrainJson.PLACES + column + corner % 2);
                    middle[0] += place[0] / 4;
                    middle[1] += place[1] / 4;
                }
                double[] at = origin.to(middle[0], middle[1]);
                assertEquals(-50_000 + (row + 0.5) * step, at[0], 1);
                assertEquals(-50_000 + (column + 0.5) * step, at[1], 1);
            }
        }
    }

    @Test
    public void levelGroundHasHeightsToo() {
        TerrainJson ground = new TerrainJson("stamp", new HeightField(2, 2, 0, 0, 1, 1, new float[] {3, 3, 3, 3}), null,
            0, 0, null);
        assertEquals(ground.lowest, ground.highest, 0);
        assertEquals(2, ground.rows);
    }
}
