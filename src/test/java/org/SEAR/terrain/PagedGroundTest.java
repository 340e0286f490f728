// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.Random;
import java.util.concurrent.TimeUnit;
import java.util.function.IntBinaryOperator;
import java.util.stream.Stream;
import org.SEAR.files.Assets;
import org.SEAR.geometry.GeoOrigin;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.terrain.format.TiffMaker;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Ground cut into tiles equals the ground in memory; here some thousand samples already count as too many. */
public class PagedGroundTest {
    private static final double STEP = 0.001;
    private static final int FEW = 2000;
    private static final int MANY = 16_000_000;
    /** Tolerance of an elevation between samples, each shifted by up to 2^-24 m. */
    private static final double MOVED = 1e-4;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Assets assets;

    @Before
    public void assets() {
        assets = new Assets(folder.getRoot().toPath());
    }

    private void tile(String name, int column, int row, int columns, int rows, IntBinaryOperator height)
        throws IOException {
        int[] heights = new int[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = height.applyAsInt(column + i % columns, row + i / columns);
        }
        Files.write(folder.getRoot().toPath().resolve(name),
            TiffMaker.heights(columns, rows, 8 + column * STEP, 47 - row * STEP, STEP, heights)
                .with(42113, "-1").bytes());
    }

    private Ground load(int atOnce, TerrainArea area) throws IOException {
        try (Mosaic mosaic = Mosaic.open(assets, area.paths)) {
            return new GroundBuilder(mosaic, area, atOnce).build();
        }
    }

    private static int hills(int column, int row) {
        return (int) (500 + 200 * Math.sin(column * 0.11) * Math.cos(row * 0.07) + (column * 31 + row * 17) % 23);
    }

    private void same(TerrainArea area, double tolerance) throws IOException {
        Ground whole = load(MANY, area);
        Ground paged = load(FEW, area);
        assertSame(whole.heights, whole.field);
        HeightTiles tiles = (HeightTiles) paged.heights;
        assertTrue(tiles.size() + " tiles", tiles.size() >= 6);
        assertEquals(whole.heights.rows, tiles.rows);
        assertEquals(whole.heights.columns, tiles.columns);
        assertEquals(whole.altitude, paged.altitude, tolerance);
        assertEquals(0, paged.heights.height(0, 0), 1e-5);
        assertEquals(whole.spacing, paged.spacing, 0);
        Random random = new Random(9);
        for (int i = 0; i < 4000; i++) {
            int row = i % 5 == 0 ? 256 : random.nextInt(tiles.rows);
            int column = i % 7 == 0 ? 256 : random.nextInt(tiles.columns);
            assertEquals(whole.heights.x(row), tiles.x(row), 1e-3);
            assertEquals("post " + row + ", " + column, whole.heights.y(row, column), tiles.y(row, column), tolerance);
        }
        for (int row = 0; row < paged.field.rows; row += 7) {
            for (int column = 0; column < paged.field.columns; column += 5) {
                assertEquals("of the overview", tiles.height(paged.field.x(row), paged.field.z(column)),
                    paged.field.y(row, column), 1e-3);
            }
        }
        assertEquals(tiles.x(tiles.rows - 1), paged.field.x(paged.field.rows - 1), 0);
        GeoOrigin.GeoPoint place = whole.origin.at(300.3, 0, -211.1);
        assertEquals(whole.height(place.latitude, place.longitude),
            paged.height(place.latitude, place.longitude), tolerance);
        assertTrue(Double.isNaN(paged.height(place.latitude + 1, place.longitude)));
        assertEquals(whole.origin.getLatitude(), paged.origin.getLatitude(), 0);
    }

    @Test
    public void itIsTheGroundThatItWouldBeInMemory() throws IOException {
        tile("a.tif", 0, 0, 80, 90, PagedGroundTest::hills);
        same(TerrainArea.of("a.tif", Collections.emptyList()), MOVED);
        same(TerrainArea.of("a.tif", Collections.emptyList()).around(46.951, 8.0407, 7000, 5000), MOVED);
    }

    @Test
    public void severalMaps() throws IOException {
        tile("a.tif", 0, 0, 41, 90, PagedGroundTest::hills);
        tile("b.tif", 40, 0, 40, 90, PagedGroundTest::hills);
        same(TerrainArea.of("a.tif", Arrays.asList("b.tif")), MOVED);
    }

    @Test
    public void gapsAreFilledFromAround() throws IOException {
        tile("gap.tif", 0, 0, 80, 90, (c, r) -> c > 30 && c < 50 && r > 10 && r < 70 ? -1 : 500 + c + 2 * r);
        Ground ground = load(FEW, TerrainArea.of("gap.tif", Collections.emptyList()));
        assertEquals(1, ground.warnings.size());
        assertTrue(ground.warnings.get(0), ground.warnings.get(0)
            .startsWith("gap.tif: 15.6 % of the area has no data"));
        HeightTiles tiles = (HeightTiles) ground.heights;
        for (int row = 0; row < tiles.rows; row++) {
            for (int column = 0; column < tiles.columns; column++) {
                double x = tiles.x(row);
                double z = tiles.z(column);
                double plane = tiles.y(0, 0)
                    + (tiles.y(tiles.rows - 1, 0) - tiles.y(0, 0)) * (x - tiles.x(0)) / (
                    tiles.x(tiles.rows - 1) - tiles.x(0))
                    + (tiles.y(0, tiles.columns - 1) - tiles.y(0, 0)) * (z - tiles.z(0)) / (
                    tiles.z(tiles.columns - 1) - tiles.z(0));
                assertEquals("post " + row + ", " + column, plane, tiles.y(row, column), 8);
            }
        }
        tile("none.tif", 0, 0, 80, 90, (c, r) -> c < 50 ? -1 : 500 + c);
        IOException e = assertThrows(IOException.class,
            () -> load(FEW, TerrainArea.of("none.tif", Collections.emptyList())));
        assertEquals("none.tif: the part of the area without data is 62.5 %, legal: at most 50 %: choose another area, "
            + "or add the missing tile", e.getMessage());
    }

    @Test
    public void aMapOfGreysHasItsSize() throws IOException {
        int[] greys = new int[80 * 90];
        for (int i = 0; i < greys.length; i++) {
            greys[i] = hills(i % 80, i / 80);
        }
        byte[] pixels = new byte[2 * greys.length];
        for (int i = 0; i < greys.length; i++) {
            pixels[2 * i] = (byte) greys[i];
            pixels[2 * i + 1] = (byte) (greys[i] >> 8);
        }
        Files.write(folder.getRoot().toPath().resolve("grey.tif"), new TiffMaker(80, 90, 16, pixels).bytes());
        TerrainArea area = TerrainArea.of("grey.tif", Collections.emptyList()).sized(4000, 3000, 0, 30000);
        Ground whole = load(MANY, area);
        Ground paged = load(FEW, area);
        assertEquals(whole.altitude, paged.altitude, MOVED);
        for (int row = 0; row < whole.heights.rows; row += 3) {
            for (int column = 0; column < whole.heights.columns; column += 3) {
                assertEquals(whole.heights.y(row, column), paged.heights.y(row, column), MOVED);
            }
        }
    }

    @Test
    public void theTemporaryFolderHoldsNoFileOfIt() throws IOException {
        tile("a.tif", 0, 0, 80, 90, PagedGroundTest::hills);
        Ground ground = load(FEW, TerrainArea.of("a.tif", Collections.emptyList()));
        assertTrue(ground.heights instanceof HeightTiles);
        boolean windows = System.getProperty("os.name").startsWith("Windows");
        long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(1);
        while (isThereOne() && System.nanoTime() < end) {    // another JVM's file has its name for a moment
            Thread.onSpinWait();
        }
        assertTrue(windows || !isThereOne());
    }

    private static boolean isThereOne() throws IOException {
        try (Stream<Path> files = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
            return files.anyMatch(file -> file.getFileName().toString().startsWith("sear-terrain-"));
        }
    }
}
