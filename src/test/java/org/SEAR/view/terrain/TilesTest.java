// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.jme3.math.FastMath;
import com.jme3.math.Vector2f;
import com.jme3.math.Vector3f;
import com.jme3.renderer.Camera;
import java.nio.FloatBuffer;
import java.util.HashMap;
import java.util.Map;
import java.util.Random;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.geometry.HeightTilesTest;
import org.junit.Test;

/** Tiles of a terrain: one surface without holes, as exact as required. */
public class TilesTest {
    private static final int SIDE = TilePyramid.CELLS + 1;

    /** Returns ground with a rough middle and level edges, so that levels of neighbours differ greatly. */
    private static HeightField rough(int rows, int columns) {
        Random random = new Random(7);
        float[] heights = new float[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            double x = (double) (i / columns) / rows - 0.5;
            double z = (double) (i % columns) / columns - 0.5;
            heights[i] = (float) (Math.hypot(x, z) < 0.15 ? 20 * random.nextDouble() : 0);
        }
        return new HeightField(rows, columns, -rows / 2.0, -columns / 2.0, 1, 1, heights);
    }

    private static HeightField hills(int rows, int columns, double spacing) {
        float[] heights = new float[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            double x = i / columns * spacing / 900;
            double z = i % columns * spacing / 900;
            heights[i] = (float) (spacing * (8 * Math.sin(x) * Math.cos(z) + 2 * Math.sin(5.3 * x + 3.1 * z)
                + 0.4 * Math.sin(17 * x) * Math.sin(19 * z)));
        }
        return new HeightField(rows, columns, -rows * spacing / 2, -columns * spacing / 2, spacing, spacing, heights);
    }

    private static Camera camera(float x, float y, float z, Vector3f to) {
        Camera camera = new Camera(1024, 640);
        camera.setFrustumPerspective(50, 1.6f, 0.05f, 400);
        camera.setLocation(new Vector3f(x, y, z));
        camera.lookAt(to, Vector3f.UNIT_Y);
        camera.update();
        return camera;
    }

    /** Counts the edges of all triangles of a choice, tiles out of sight included. */
    private static Map<Long, Integer> edges(TilePyramid pyramid, TileChoice choice) {
        Map<Long, Integer> edges = new HashMap<>();
        double[] area = {0};
        for (int tile = 0; tile < choice.count(); tile++) {
            int level = choice.level(tile);
            int kind = TileIndices.kind(choice.coarser(tile, 0), choice.coarser(tile, 1), choice.coarser(tile, 2),
                choice.coarser(tile, 3));
            short[] corners = TileIndices.triangles(kind);
            for (int i = 0; i < corners.length; i += 3) {
                int[] posts = new int[3];
                for (int k = 0; k < 3; k++) {
                    posts[k] = pyramid.postRow(level, choice.row(tile), corners[i + k] / SIDE) * pyramid.field.columns
                        + pyramid.postColumn(level, choice.column(tile), corners[i + k] % SIDE);
                }
                if (posts[0] != posts[1] && posts[1] != posts[2] && posts[0] != posts[2]) {
                    area[0] += add(edges, posts, pyramid.field.columns);
                }
            }
        }
        assertEquals("the triangles together are as large as the field",
            (pyramid.field.rows - 1.0) * (pyramid.field.columns - 1), area[0], 1e-6);
        return edges;
    }

    /**
     * Counts a triangle's edges, those in the other direction as -1.
     * @return its area in cells
     */
    private static double add(Map<Long, Integer> edges, int[] posts, int columns) {
        for (int k = 0; k < 3; k++) {
            long from = posts[k];
            long to = posts[(k + 1) % 3];
            edges.merge(Math.min(from, to) << 32 | Math.max(from, to), from < to ? 1 : -1, Integer::sum);
        }
        double r1 = posts[1] / columns - posts[0] / columns;
        double c1 = posts[1] % columns - posts[0] % columns;
        double r2 = posts[2] / columns - posts[0] / columns;
        double c2 = posts[2] % columns - posts[0] % columns;
        double twice = c1 * r2 - r1 * c2;
        assertTrue("no triangle is turned over", twice >= 0);
        return twice / 2;
    }

    /** Returns the number of edges inside with a triangle on one side only; a surface without holes has none. */
    private static int holes(TilePyramid pyramid, TileChoice choice) {
        int holes = 0;
        int columns = pyramid.field.columns;
        for (Map.Entry<Long, Integer> edge : edges(pyramid, choice).entrySet()) {
            long from = edge.getKey() >> 32;
            long to = edge.getKey() & 0xffffffffL;
            boolean level = from / columns == to / columns
                && (from / columns == 0 || from / columns == pyramid.field.rows - 1);
            boolean upright = from % columns == to % columns && (from % columns == 0 || from % columns == columns - 1);
            holes += edge.getValue() != 0 && !level && !upright ? 1 : 0;
        }
        return holes;
    }

    @Test
    public void noTileLeavesAHoleWhateverItsNeighbours() {
        int[][] sizes = {{700, 900}, {1025, 1025}, {33, 34}, {2, 2}, {2, 3000}};
        for (int[] size : sizes) {
            TilePyramid pyramid = new TilePyramid(rough(size[0], size[1]));
            TileChoice choice = new TileChoice(pyramid, 10_000);
            for (float height : new float[] {1, 30, 600}) {
                choice.choose(camera(-40, height, 13, new Vector3f(100, 0, 90)));
                assertEquals(size[0] + " x " + size[1] + " from " + height, 0, holes(pyramid, choice));
            }
        }
    }

    @Test
    public void neighboursOfManyLevelsApartOccur() {
        TilePyramid pyramid = new TilePyramid(rough(2049, 2049));
        TileChoice choice = new TileChoice(pyramid, 10_000);
        choice.choose(camera(-320, 15, 0, new Vector3f(0, 0, 0)));
        int most = 0;
        for (int tile = 0; tile < choice.count(); tile++) {
            for (int side = 0; side < 4; side++) {
                most = Math.max(most, choice.coarser(tile, side));
            }
        }
        assertTrue("only " + most, most >= 2);
        assertTrue(most <= TileChoice.MAX_STEPS);
        assertEquals(0, holes(pyramid, choice));
    }

    @Test
    public void aTilesErrorIsWithinItsBound() {
        TilePyramid pyramid = new TilePyramid(hills(400, 300, 30));
        HeightGrid field = pyramid.field;
        for (int level = 0; level < pyramid.levels; level++) {
            double worst = 0;
            for (int row = 0; row < field.rows; row += 3) {
                for (int column = 0; column < field.columns; column += 3) {
                    double off = Math.abs(coarse(field, 1 << level, row, column) - field.y(row, column));
                    int size = TilePyramid.CELLS << level;
                    float said = pyramid.error(level, Math.min(row / size, pyramid.rows(level) - 1),
                        Math.min(column / size, pyramid.columns(level) - 1));
                    assertTrue("level " + level + ": " + off + " > " + said, off <= said + 1e-3);
                    worst = Math.max(worst, off);
                }
            }
            assertEquals("level 0 is the field", level == 0, worst == 0);
        }
    }

    private static double coarse(HeightGrid field, int step, int row, int column) {
        int south = Math.min(row / step * step, field.rows - 1);
        int north = Math.min(south + step, field.rows - 1);
        int west = Math.min(column / step * step, field.columns - 1);
        int east = Math.min(west + step, field.columns - 1);
        double u = north > south ? (double) (row - south) / (north - south) : 0;
        double v = east > west ? (double) (column - west) / (east - west) : 0;
        double low = field.y(south, west);
        double high = field.y(north, east);
        return v >= u ? low + v * (field.y(south, east) - low) + u * (high - field.y(south, east))
            : low + u * (field.y(north, west) - low) + v * (high - field.y(north, west));
    }

    @Test
    public void nearTheCameraTheGroundIsTheFieldsOwnAndAsManyTilesAsAllowedAreSeen() {
        TilePyramid pyramid = new TilePyramid(hills(1800, 1800, 30));
        TileChoice choice = new TileChoice(pyramid, TerrainView.MAX_PLAIN);
        float ground = (float) pyramid.field.height(100, 200);
        choice.choose(camera(100, ground + 1, 200, new Vector3f(400, ground, 400)));
        assertTrue(choice.seen() + " tiles", choice.seen() <= TerrainView.MAX_PLAIN && choice.seen() > 3);
        int under = 0;
        for (int tile = 0; tile < choice.count(); tile++) {
            under += choice.distance(tile) < 2 && choice.isSeen(tile) ? 1 : 0;
            assertFalse("a coarse tile underfoot", choice.distance(tile) < 2 && choice.isSeen(tile)
                && choice.level(tile) > 0);
        }
        assertTrue(under > 0);
    }

    @Test
    public void groundBehindNearerGroundIsLeftOutAndNoneThatIsSeen() {
        TilePyramid pyramid = new TilePyramid(hills(1800, 1800, 30));
        HeightGrid field = pyramid.field;
        Random random = new Random(3);
        int least = Integer.MAX_VALUE;
        for (int place = 0; place < 12; place++) {
            float x = random.nextInt(20_000) - 10_000;
            float z = random.nextInt(20_000) - 10_000;
            float y = (float) field.height(x, z) + (place % 3 == 0 ? 60 : 1.5f);
            float yaw = random.nextFloat() * FastMath.TWO_PI;
            Camera camera = camera(x, y, z,
                new Vector3f(x + 100 * FastMath.cos(yaw), y - 4, z + 100 * FastMath.sin(yaw)));
            TileChoice choice = new TileChoice(pyramid, 10_000);
            choice.choose(camera);
            least = Math.min(least, choice.seen());
            int met = 0;
            for (int beam = 0; beam < 3000; beam++) {
                Vector3f end = camera.getWorldCoordinates(
                    new Vector2f(random.nextInt(1024), random.nextInt(640)), 0.99f);
                Vector3f at = meet(field, camera.getLocation(), end.subtract(camera.getLocation()).normalizeLocal());
                if (at != null) {
                    met++;
                    assertTrue("from " + camera.getLocation() + " ground at " + at + " is not drawn",
                        isDrawn(pyramid, choice, at));
                }
            }
            assertTrue(met + " of 3000 beams from " + camera.getLocation() + " met the ground", met > 300);
        }
        assertTrue("at least " + least + " tiles", least < 60);
    }

    /** Returns the point where a ray goes below the ground, in steps that grow with the distance. */
    private static Vector3f meet(HeightGrid field, Vector3f from, Vector3f direction) {
        for (float t = 1; t < 60_000; t *= 1.002f) {
            Vector3f at = direction.mult(t).addLocal(from);
            double ground = field.height(at.x, at.z);
            if (at.y < ground) {
                return at;
            }
        }
        return null;
    }

    private static boolean isDrawn(TilePyramid pyramid, TileChoice choice, Vector3f at) {
        HeightGrid field = pyramid.field;
        int row = (int) ((at.x - field.lowX) / field.spacingX) / TilePyramid.CELLS;
        int column = (int) ((at.z - field.lowZ) / field.spacingZ) / TilePyramid.CELLS;
        for (int tile = 0; tile < choice.count(); tile++) {
            int level = choice.level(tile);
            if (choice.isSeen(tile) && choice.row(tile) == row >> level && choice.column(tile) == column >> level) {
                return true;
            }
        }
        return false;
    }

    @Test
    public void commonCornersOfNeighboursAreTheSameNumbers() {
        TilePyramid pyramid = new TilePyramid(hills(200, 200, 13.7));
        Tile fine = new Tile();
        fine.fill(pyramid, 0, 1, 1);
        Tile coarse = new Tile();
        coarse.fill(pyramid, 1, 0, 1);
        FloatBuffer a = fine.places();
        FloatBuffer b = coarse.places();
        for (int i = 0; i < 3; i++) {
            assertEquals("a common post", a.get(3 * (SIDE * 0 + TilePyramid.CELLS) + i),
                b.get(3 * (SIDE * TilePyramid.CELLS / 2) + i), 0);
        }
    }

    @Test
    public void aTileOfThirteenMillionPostsIsReadyFastAndNeedsLittle() {
        HeightField field = hills(3601, 3601, 30);
        long start = System.nanoTime();
        TilePyramid pyramid = new TilePyramid(field);
        System.out.println("levels of detail of 3601 x 3601 posts: " + (System.nanoTime() - start) / 1_000_000 + " ms");
        assertEquals(9, pyramid.levels);
        int tiles = 0;
        for (int level = 0; level < pyramid.levels; level++) {
            tiles += pyramid.rows(level) * pyramid.columns(level);
        }
        assertTrue(tiles + " tiles", tiles < 2 * field.heights.length / (TilePyramid.CELLS * TilePyramid.CELLS));
    }

    @Test
    public void groundInTilesIsDrawnAsTheSameInMemory() {
        HeightField field = hills(700, 560, HeightTiles.exact(30));
        HeightTiles tiles = HeightTilesTest.of(field, 4);
        TilePyramid expected = new TilePyramid(field);
        TilePyramid pyramid = new TilePyramid(tiles);
        assertEquals(expected.levels, pyramid.levels);
        for (int level = 0; level < pyramid.levels; level++) {
            for (int row = 0; row < pyramid.rows(level); row++) {
                for (int column = 0; column < pyramid.columns(level); column++) {
                    assertEquals(expected.low(level, row, column), pyramid.low(level, row, column), 0);
                    assertEquals(expected.high(level, row, column), pyramid.high(level, row, column), 0);
                    assertEquals(expected.error(level, row, column), pyramid.error(level, row, column), 0);
                    for (int cell = 0; cell <= TilePyramid.CELLS; cell++) {
                        int r = pyramid.postRow(level, row, cell);
                        int c = pyramid.postColumn(level, column, (cell * 7) % (TilePyramid.CELLS + 1));
                        assertEquals(field.y(r, c), pyramid.y(level, r, c), 0);
                    }
                }
            }
        }
        long made = tiles.made();
        for (int row = 0; row < pyramid.rows(5); row++) {
            pyramid.y(5, pyramid.postRow(5, row, 3), pyramid.postColumn(5, 0, 5));
        }
        assertEquals("far tiles need none of the ground's", made, tiles.made());
        for (float distance = 1000; distance < 6000; distance += 500) {
            for (float x = -10450; x < 10400; x += 333) {
                double exact = field.height(x, x / 2);
                double surely = pyramid.surely(x, x / 2, distance);
                assertTrue(exact + " and " + surely, surely <= exact && surely > exact - 600);
            }
        }
        assertTrue(Double.isNaN(pyramid.surely(20000, 0, 5000)));
    }
}
