// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertTrue;

import org.SEAR.geometry.HeightField;
import org.junit.Test;

/** Slopes, hill shading and colours of the ground. */
public class ReliefTest {
    private static final GroundPicture.Light NOON = new GroundPicture.Light(new float[] {0, 0, 0},
        new float[] {1, 1, 1}, new HillShade(0, 90));

    private interface Heights {
        double at(double x, double z);
    }

    private static HeightField field(int rows, int columns, double spacing, Heights heights) {
        float[] posts = new float[rows * columns];
        for (int i = 0; i < posts.length; i++) {
            posts[i] = (float) heights.at(i / columns * spacing, i % columns * spacing);
        }
        return new HeightField(rows, columns, 0, 0, spacing, spacing, posts);
    }

    private static int red(int rgb) {
        return rgb >> 16 & 0xff;
    }

    private static int green(int rgb) {
        return rgb >> 8 & 0xff;
    }

    private static int blue(int rgb) {
        return rgb & 0xff;
    }

    private static int at(GroundPicture picture, int row, int column) {
        return picture.pixels[row * picture.width + column];
    }

    @Test
    public void aPlaneHasItsSlopeEverywhereAlsoAtItsEdges() {
        Relief relief = new Relief(field(90, 120, 10, (x, z) -> 0.3 * x - 0.2 * z), 256, 3, 0);
        assertEquals(256, relief.width);
        for (int row = 0; row < relief.height; row += 7) {
            for (int column = 0; column < relief.width; column += 5) {
                assertEquals(0.3, relief.slopeNorth(row, column), 1e-3);
                assertEquals(-0.2, relief.slopeEast(row, column), 1e-3);
            }
        }
        assertEquals(Math.hypot(0.3, 0.2), relief.meanSlope(), 1e-3);
    }

    @Test
    public void hillShadeOfAPlaneIsTheCosineBetweenSunAndNormal() {
        HillShade light = new HillShade(315, 45);
        assertEquals("level", Math.sqrt(0.5), light.at(0, 0), 1e-12);
        assertEquals("45 degrees up to the south-east looks straight into the sun", 1,
            light.at(-Math.sqrt(0.5), Math.sqrt(0.5)), 1e-12);
        assertEquals("45 degrees the other way looks along its light", 0,
            light.at(Math.sqrt(0.5), -Math.sqrt(0.5)), 1e-12);
        assertEquals("steeper ones are in the dark", 0, light.at(2, -2), 0);
        double[] normal = {-0.3, 1, 0.2};
        double[] sun = {0.5, Math.sqrt(0.5), -0.5};
        double length = Math.sqrt(0.09 + 1 + 0.04);
        assertEquals((normal[0] * sun[0] + normal[1] * sun[1] + normal[2] * sun[2]) / length,
            light.at(0.3, -0.2), 1e-12);
    }

    @Test
    public void aPictureIsNeverLargerThanAskedForAndNeverFinerThanThePostsNeed() {
        HeightField large = field(600, 900, 30, (x, z) -> 0);
        assertEquals(512, new Relief(large, 512, 3, 0).width);
        assertEquals(341, new Relief(large, 512, 3, 0).height, 1);
        assertEquals(2 * 899, new Relief(large, 4096, 2, 0).width);
        HeightField strip = field(2, 5000, 1, (x, z) -> 0);
        assertTrue(new Relief(strip, 512, 3, 0).height <= 64);
    }

    @Test
    public void highMountainsHaveSnowOnTopAndMeadowsBelowHillsHaveNone() {
        GroundPicture alps = GroundPicture.landscape(new Relief(field(200, 200, 100, (x, z) -> 0.16 * x), 200, 1, 0),
            NOON, null);
        int top = at(alps, 198, 100);
        int foot = at(alps, 3, 100);
        assertTrue("snow: " + Integer.toHexString(top), red(top) > 200 && blue(top) > 200);
        assertTrue("meadow: " + Integer.toHexString(foot), green(foot) > red(foot) && green(foot) > blue(foot) + 20);
        GroundPicture hills = GroundPicture.landscape(new Relief(field(200, 200, 10, (x, z) -> 0.05 * x), 200, 1, 0),
            NOON, null);
        for (int pixel : hills.pixels) {
            assertTrue("green: " + Integer.toHexString(pixel), green(pixel) >= red(pixel) - 6
                && green(pixel) > blue(pixel) + 10);
        }
    }

    @Test
    public void steepGroundIsRock() {
        Heights cliff = (x, z) -> Math.max(0, Math.min(100, (x - 500) * 3)) + x * 1e-3;
        GroundPicture picture = GroundPicture.landscape(new Relief(field(100, 100, 10, cliff), 100, 1, 0), NOON, null);
        int rock = at(picture, 51, 50);
        assertTrue("rock: " + Integer.toHexString(rock), red(rock) > green(rock) && green(rock) > blue(rock));
    }

    @Test
    public void givenColoursCountAndWhereThereAreNoneTheGroundHasItsOwn() {
        GroundPicture.Colors western = (x, z) -> z < 500 ? 0xff0000ff : 0;
        Relief relief = new Relief(field(100, 100, 10, (x, z) -> 0), 100, 1, 0);
        for (GroundPicture picture : new GroundPicture[] {GroundPicture.landscape(relief, NOON, western),
            GroundPicture.map(relief, western)}) {
            int given = at(picture, 50, 10);
            assertTrue(Integer.toHexString(given), blue(given) > 200 && red(given) < 10);
            int own = at(picture, 50, 90);
            assertTrue(Integer.toHexString(own), green(own) > blue(own));
        }
    }

    @Test
    public void aMapIsLighterWhereTheGroundLooksToTheNorthWest() {
        Heights ridge = (x, z) -> -Math.abs(x - z) * 0.3;
        GroundPicture map = GroundPicture.map(new Relief(field(100, 100, 10, ridge), 100, 1, 0), (x, z) -> 0xff808080);
        int northWest = at(map, 70, 30);
        int southEast = at(map, 30, 70);
        assertTrue(red(northWest) + " and " + red(southEast), red(northWest) > red(southEast) + 60);
    }

    @Test
    public void aFlatGroundHasAPicture() {
        GroundPicture flat = GroundPicture.landscape(new Relief(field(2, 2, 5, (x, z) -> 7), 256, 4, 0), NOON, null);
        assertNotEquals(0, flat.pixels[flat.pixels.length / 2]);
        assertEquals(flat.width * flat.height, flat.pixels.length);
    }

    @Test
    public void aRampIsStraightBetweenItsStops() {
        ColorRamp ramp = new ColorRamp(new float[] {0, 0, 0, 0}, new float[] {1, 1, 0.5f, 0}, new float[] {3, 1, 1, 1});
        float[] color = new float[3];
        ramp.at(-1, color);
        assertEquals(0, color[0], 0);
        ramp.at(0.5, color);
        assertEquals(0.25, color[1], 1e-6);
        ramp.at(2, color);
        assertEquals(0.5, color[2], 1e-6);
        ramp.at(9, color);
        assertEquals(1, color[2], 0);
    }
}
