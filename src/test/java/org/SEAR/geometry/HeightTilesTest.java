// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.util.Arrays;
import java.util.Random;
import java.util.TreeSet;
import org.junit.Test;

/** Tiles equal the field that they are cut from, however few are in memory. */
public class HeightTilesTest {
    private static final int HELD = 2;
    private static final HeightField WHOLE = whole();
    private final HeightTiles tiles = of(WHOLE, HELD);
    private final Random random = new Random(35);

    private static HeightField whole() {
        Random random = new Random(7);
        float[] heights = new float[601 * 517];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (float) (20 * Math.sin(i / 517 * 0.03) * Math.cos(i % 517 * 0.04) + 2 * random.nextDouble());
        }
        return new HeightField(601, 517, HeightTiles.exact(-7512.3), HeightTiles.exact(-7001.7),
            HeightTiles.exact(25.03), HeightTiles.exact(27.1), heights);
    }

    /** Returns the same ground in tiles. */
    public static HeightTiles of(HeightField field, int most) {
        return new HeightTiles(field.rows, field.columns, field.lowX, field.lowZ, field.spacingX, field.spacingZ,
            (row, column, height, width) -> {
            float[] part = new float[height * width];
            for (int i = 0; i < part.length; i++) {
                part[i] = field.y(row + i / width, column + i % width);
            }
            return part;
        }, most, (tile, row, column) -> { });
    }

    @Test
    public void itIsTheSameGround() {
        assertEquals(5, tiles.tileRows);
        assertEquals(5, tiles.tileColumns);
        assertEquals(WHOLE.lowest(), tiles.lowest(), 0);
        assertEquals(WHOLE.highest(), tiles.highest(), 0);
        for (int i = 0; i < 700; i++) {
            int row = random.nextInt(WHOLE.rows);
            int column = i % 3 == 0 ? i % 2 * 256 : random.nextInt(WHOLE.columns);
            assertEquals(WHOLE.y(row, column), tiles.y(row, column), 0);
            double x = i % 4 == 0 ? WHOLE.x(row) : WHOLE.x(0) + random.nextDouble() * 601 * 25.03;
            double z = i % 6 == 0 ? WHOLE.z(column) : WHOLE.z(0) + random.nextDouble() * 517 * 27.1;
            assertEquals("at " + x + ", " + z, WHOLE.height(x, z), tiles.height(x, z), 0);
        }
        assertTrue(Double.isNaN(tiles.height(WHOLE.x(0) - 0.01, 0)));
    }

    @Test
    public void theNumberOfTilesInMemoryIsLimited() {
        assertEquals(0, tiles.held());
        for (int i = 0; i < 200; i++) {
            tiles.tile(random.nextInt(tiles.size()));
            assertTrue(tiles.held() <= HELD);
        }
        assertEquals(HELD, tiles.held());
        long made = tiles.made();
        HeightField first = tiles.tile(0);
        tiles.tile(1);
        tiles.tile(0);
        tiles.tile(2);
        assertEquals("the one that was used last stays", first, tiles.tile(0));
        assertTrue(tiles.made() <= made + 3);
        tiles.tile(5);
        tiles.tile(6);
        assertArrayEquals("made anew it is the same", first.heights, tiles.tile(0).heights, 0);
    }

    @Test
    public void neighboursHaveTheirPostsAtTheSamePlace() {
        HeightField south = tiles.tile(0);
        HeightField north = tiles.tile(tiles.tileColumns);
        HeightField east = tiles.tile(1);
        assertEquals(south.x(HeightTiles.CELLS), north.x(0), 0);
        assertEquals(south.z(HeightTiles.CELLS), east.z(0), 0);
        for (int number = 0; number < tiles.size(); number++) {
            HeightField tile = tiles.tile(number);
            for (int i = 0; i < tile.rows; i++) {
                assertEquals(WHOLE.x(tiles.firstRow(number) + i), tile.x(i), 0);
            }
            for (int i = 0; i < tile.columns; i++) {
                assertEquals(WHOLE.z(tiles.firstColumn(number) + i), tile.z(i), 0);
            }
        }
    }

    @Test
    public void aSearchFindsTheSameTriangles() {
        HeightSearch search = new HeightSearch(tiles);
        HeightSearch oracle = new HeightSearch(WHOLE);
        int found = 0;
        for (int i = 0; i < 150; i++) {
            double x = WHOLE.x(random.nextInt(601));
            double z = i % 2 == 0 ? WHOLE.z(256) : WHOLE.z(random.nextInt(517));
            double y = WHOLE.height(x, z);
            double side = i % 3 == 0 ? 0 : random.nextDouble() * 400;
            TreeSet<String> expected = new TreeSet<>();
            TreeSet<String> actual = new TreeSet<>();
            oracle.any(x - side, y - 5, z - side, x + side, y + 5, z + side, at -> !expected.add(Arrays.toString(at)));
            search.any(x - side, y - 5, z - side, x + side, y + 5, z + side, at -> !actual.add(Arrays.toString(at)));
            assertEquals(expected, actual);
            found += expected.size();
        }
        assertTrue("found " + found, found > 1500);
        double x = WHOLE.x(300);
        assertTrue(search.any(x, -100, 0, x, 100, 0, at -> true));
    }

    @Test
    public void placesThatRoundDifferentlyAreRefused() {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class,
            () -> new HeightTiles(3, 3, 0.1, 0, 1, 1, (row, column, height, width) -> new float[height * width], 1,
                (tile, row, column) -> { }));
        assertTrue(e.getMessage(), e.getMessage()
            .contains("legal: numbers of metres with at most 24 binary places, at least 1 held"));
    }
}
