// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.Random;
import org.junit.Test;

/** Samples, triangles, blocks and elevations of the ground agree with each other. */
public class HeightFieldTest {
    private final HeightField field = new HeightField(3, 2, -10, 4, 10, 2, new float[] {0, 1, 4, 8, 2, 2});

    @Test
    public void samplesAreOrderedByRowsFromTheSouthWest() {
        assertEquals(8, field.y(1, 1), 0);
        assertEquals(0, field.x(1), 0);
        assertEquals(6, field.z(1), 0);
        for (int row = 0; row < 3; row++) {
            for (int column = 0; column < 2; column++) {
                assertEquals(field.y(row, column), field.height(field.x(row), field.z(column)), 0);
            }
        }
    }

    @Test
    public void aCellHasTwoTrianglesAlongItsSouthWestDiagonal() {
        assertEquals("on the diagonal", 4, field.height(-5, 5), 1e-12);
        assertEquals("east of it", 0.5 + (8 - 1) * 0.25, field.height(-7.5, 5), 1e-12);
        assertEquals("west of it", 4 * 0.75 + (8 - 4) * 0.5, field.height(-2.5, 5), 1e-12);
    }

    @Test
    public void outsideTheFieldThereIsNoGround() {
        assertTrue(Double.isNaN(field.height(10.001, 5)));
        assertTrue(Double.isNaN(field.height(0, 3.999)));
        assertTrue(Double.isNaN(field.height(Double.NaN, 5)));
        assertEquals(2, field.height(10, 6), 0);
    }

    @Test
    public void invalidFieldsAreRejected() {
        assertThrows(IllegalArgumentException.class, () -> new HeightField(2, 2, 0, 0, 1, 1, new float[5]));
        assertThrows(IllegalArgumentException.class, () -> new HeightField(1, 4, 0, 0, 1, 1, new float[4]));
        assertThrows(IllegalArgumentException.class, () -> new HeightField(2, 2, 0, 0, Double.NaN, 1, new float[4]));
    }

    @Test
    public void trianglesHaveTheSamplesAsCornersAndAreCounterClockwiseFromAbove() {
        float[] corners = new float[9];
        field.triangle(0, 0, 0, corners);
        assertArrayEquals(new float[] {-10, 0, 4, -10, 1, 6, 0, 8, 6}, corners, 0);
        field.triangle(0, 0, 1, corners);
        assertArrayEquals(new float[] {-10, 0, 4, 0, 8, 6, 0, 4, 4}, corners, 0);
    }

    @Test
    public void heightsAreThoseOfTheTrianglesWhereverPostsAreRounded() {
        HeightField far = new HeightField(400, 3, 54_321.0123, -20_000.7, 0.0371, 0.1, heights(1200, 5));
        float[] corners = new float[9];
        for (int row = 0; row < 399; row++) {
            for (int half = 0; half < 2; half++) {
                far.triangle(row, 1, half, corners);
                double x = ((double) corners[0] + corners[3] + corners[6]) / 3;
                double z = ((double) corners[2] + corners[5] + corners[8]) / 3;
                assertEquals(((double) corners[1] + corners[4] + corners[7]) / 3, far.height(x, z), 1e-9);
            }
        }
    }

    @Test
    public void indistinguishableSamplesAreRejected() {
        IllegalArgumentException refused = assertThrows(IllegalArgumentException.class,
            () -> new HeightField(2, 2, 60_000, 0, 0.001, 1, new float[4]));
        assertEquals("height field: posts 0.001 and 1.0 m apart, legal at this distance: 0.00390625 m or more",
            refused.getMessage());
    }

    private static float[] heights(int count, long seed) {
        Random random = new Random(seed);
        float[] heights = new float[count];
        for (int i = 0; i < count; i++) {
            heights[i] = 10 * random.nextFloat();
        }
        return heights;
    }

    @Test
    public void blocksStoreTheirLeastAndGreatestElevation() {
        for (int[] size : new int[][] {{2, 2}, {3, 3}, {4, 9}, {33, 2}, {50, 70}, {65, 65}}) {
            HeightField any = new HeightField(size[0], size[1], 0, 0, 1, 1, heights(size[0] * size[1], 8));
            HeightPyramid pyramid = any.getPyramid();
            for (int level = 0; level <= pyramid.top; level++) {
                int side = 2 << level;
                for (int row = 0; row * side < size[0] - 1; row++) {
                    for (int column = 0; column * side < size[1] - 1; column++) {
                        float least = Float.POSITIVE_INFINITY;
                        float greatest = Float.NEGATIVE_INFINITY;
                        for (int r = row * side; r <= Math.min((row + 1) * side, size[0] - 1); r++) {
                            for (int c = column * side; c <= Math.min((column + 1) * side, size[1] - 1); c++) {
                                least = Math.min(least, any.y(r, c));
                                greatest = Math.max(greatest, any.y(r, c));
                            }
                        }
                        int at = pyramid.block(level, row, column);
                        assertEquals(least, pyramid.data[at], 0);
                        assertEquals(greatest, pyramid.data[at + 1], 0);
                    }
                }
            }
        }
    }

    @Test
    public void aSearchFindsAllTrianglesInTheBoxAndNoOthers() {
        HeightField any = new HeightField(41, 30, -3, 7, 0.3, 0.4, heights(41 * 30, 9));
        HeightSearch search = new HeightSearch(any);
        Random random = new Random(10);
        for (int i = 0; i < 300; i++) {
            double[] low = {random.nextDouble() * 14 - 4, random.nextDouble() * 12 - 1, random.nextDouble() * 14 + 6};
            double[] high = {low[0] + random.nextDouble() * 3, low[1] + random.nextDouble(),
                low[2] + random.nextDouble() * 3};
            int[] found = new int[1];
            assertFalse(search.any(low[0], low[1], low[2], high[0], high[1], high[2], corners -> {
                found[0]++;
                return !reaches(corners, low, high);
            }));
            int expected = 0;
            float[] corners = new float[9];
            for (int cell = 0; cell < 40 * 29 * 2; cell++) {
                any.triangle(cell / 2 / 29, cell / 2 % 29, cell % 2, corners);
                expected += reaches(corners, low, high) ? 1 : 0;
            }
            assertEquals(expected, found[0]);
        }
    }

    private static boolean reaches(float[] corners, double[] low, double[] high) {
        for (int axis = 0; axis < 3; axis++) {
            if (Math.min(corners[axis], Math.min(corners[axis + 3], corners[axis + 6])) > high[axis]
                || Math.max(corners[axis], Math.max(corners[axis + 3], corners[axis + 6])) < low[axis]) {
                return false;
            }
        }
        return true;
    }

    @Test
    public void aWholeTileTakesLessThan8BytesAPost() {
        HeightField tile = new HeightField(3601, 3601, -54_000, -43_000, 30, 24, new float[3601 * 3601]);
        long bytes = 4L * tile.heights.length + 4L * tile.getPyramid().data.length;
        assertTrue(bytes + " bytes", bytes < 8L * 3601 * 3601);
    }
}
