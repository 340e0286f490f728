// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import org.SEAR.files.Assets;
import org.SEAR.terrain.format.TiffMaker;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Maps as the ground of a world: areas, tiles, gaps, sizes, pictures, and messages for invalid input. */
public class MapLoadingTest {
    private static final double STEP = 0.001;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Assets assets;

    @Before
    public void assets() {
        assets = new Assets(folder.getRoot().toPath());
    }

    private void write(String name, byte[] bytes) throws IOException {
        Files.write(folder.getRoot().toPath().resolve(name), bytes);
    }

    private void write(String name, String text) throws IOException {
        write(name, text.getBytes(StandardCharsets.ISO_8859_1));
    }

    /** Writes a map whose elevations follow from column and row, counted from longitude 8, latitude 47. */
    private void tile(String name, int column, int row, int columns, int rows, IntBinaryOperator height)
        throws IOException {
        int[] heights = new int[rows * columns];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = height.applyAsInt(column + i % columns, row + i / columns);
        }
        write(name, TiffMaker.heights(columns, rows, 8 + column * STEP, 47 - row * STEP, STEP, heights)
            .with(42113, "-1").bytes());
    }

    private static TerrainArea all(String path, String... tiles) {
        return TerrainArea.of(path, Arrays.asList(tiles));
    }

    private Ground load(TerrainArea area) throws IOException {
        return TerrainLoader.load(area, assets);
    }

    private void refused(TerrainArea area, String message) {
        IOException e = assertThrows(message, IOException.class, () -> load(area));
        assertTrue(e.getMessage(), e.getMessage().contains(message));
    }

    /** Returns the latitude of the centre of a pixel's row. */
    private static double latitude(double row) {
        return 47 - (row + 0.5) * STEP;
    }

    private static double longitude(double column) {
        return 8 + (column + 0.5) * STEP;
    }

    @Test
    public void anAreasCentreIsTheOriginAtHeightZero() throws IOException {
        tile("a.tif", 0, 0, 60, 50, (c, r) -> 100 + 3 * c + 5 * r);
        Ground ground = load(all("a.tif").around(latitude(20), longitude(30), 1000, 800));
        assertEquals(100 + 90 + 100, ground.altitude, 0.001);
        assertEquals(0, ground.field.height(0, 0), 1e-6);
        assertEquals(latitude(20), ground.origin.getLatitude(), 0);
        assertEquals(ground.altitude, ground.origin.getAltitude(), 0);
        assertEquals(100 + 3 * 33.25 + 5 * 21.5, ground.height(latitude(21.5), longitude(33.25)), 0.001);
        assertTrue(ground.field.lowX <= -500 && ground.field.x(ground.field.rows - 1) >= 500
            && ground.field.lowX > -520);
        assertTrue(ground.field.lowZ <= -400 && ground.field.z(ground.field.columns - 1) >= 400
            && ground.field.lowZ > -420);
        assertTrue(Double.isNaN(ground.height(latitude(40), longitude(30))));
        // 111.17 m north is one row less
        assertEquals(-5, ground.field.height(111.17, 0), 0.01);
    }

    @Test
    public void theSameAreaOfTheSameFileIsLoadedOnce() throws IOException {
        tile("a.tif", 0, 0, 20, 20, (c, r) -> 100);
        Ground first = load(all("a.tif"));
        assertSame(first, load(all("a.tif")));
        assertEquals(100, first.altitude, 0);
        tile("a.tif", 0, 0, 21, 20, (c, r) -> 200);
        assertEquals(200, load(all("a.tif")).altitude, 0);
    }

    @Test
    public void tilesSideBySideHaveNoStepAtTheirSeam() throws IOException {
        IntBinaryOperator slope = (c, r) -> 100 + 7 * c + 4 * r;
        tile("west.tif", 0, 0, 30, 40, slope);
        tile("east.tif", 30, 0, 30, 40, slope);
        tile("shared.tif", 29, 5, 31, 20, slope);
        TerrainArea[] orders = {all("west.tif", "east.tif"), all("east.tif", "west.tif"),
            all("west.tif", "shared.tif", "east.tif")};
        for (TerrainArea area : orders) {
            Ground ground = load(area);
            for (double column = 2; column < 57; column += 0.25) {
                assertEquals(100 + 7 * column + 4 * 15, ground.height(latitude(15), longitude(column)), 0.001);
            }
            assertEquals(Collections.emptyList(), ground.warnings);
        }
    }

    @Test
    public void aTileOfAnotherGridIsResampled() throws IOException {
        tile("west.tif", 0, 0, 30, 42, (c, r) -> 100 + 10 * c);
        int[] heights = new int[60 * 60];
        for (int i = 0; i < heights.length; i++) {
            heights[i] = (int) Math.round(100 + 10 * ((i % 60 + 0.5) * 0.7 + 30 - 0.5));
        }
        write("east.tif", TiffMaker.heights(60, 60, 8 + 30 * STEP, 47, 0.7 * STEP, heights).bytes());
        Ground ground = load(all("west.tif", "east.tif"));
        for (double column = 2; column < 60; column += 0.25) {
            assertEquals(100 + 10 * column, ground.height(latitude(15), longitude(column)), 6);
        }
        assertEquals(Collections.emptyList(), ground.warnings);
    }

    @Test
    public void theFirstTilesHeightsCountAndTheSecondsFillItsGaps() throws IOException {
        tile("a.tif", 0, 0, 40, 40, (c, r) -> c > 10 && c < 20 ? -1 : 500);
        tile("b.tif", 0, 0, 40, 40, (c, r) -> 700);
        Ground ground = load(all("a.tif", "b.tif"));
        assertEquals(700, ground.height(latitude(20), longitude(15)), 0.001);
        assertEquals(500, ground.height(latitude(20), longitude(25)), 0.001);
    }

    @Test
    public void gapsAreFilledAndReported() throws IOException {
        tile("a.tif", 0, 0, 40, 40, (c, r) -> c >= 10 && c < 14 ? -1 : 500 + r);
        Ground ground = load(all("a.tif"));
        assertEquals(520, ground.height(latitude(20), longitude(12)), 1);
        assertEquals(1, ground.warnings.size());
        assertTrue(ground.warnings.get(0), ground.warnings.get(0)
            .matches("a.tif: (9|10|11)\\.\\d % of the area has no data.*"));
        assertEquals(Collections.emptyList(),
            load(all("a.tif").around(latitude(20), longitude(25), 500, 500)).warnings);
        tile("b.tif", 0, 0, 40, 40, (c, r) -> c < 30 ? -1 : 500 + r);
        refused(all("b.tif"), "b.tif: the part of the area without data is 7");
        refused(all("b.tif"), " %, legal: at most 50 %: choose another area");
    }

    @Test
    public void anAreaBeyondTheMapIsRejectedWithThePlaceOfTheMap() throws IOException {
        tile("a.tif", 0, 0, 60, 50, (c, r) -> 100);
        refused(all("a.tif").around(46.99, 8.01, 10000, 100), "a.tif: the area is 46.99, 8.01, 10000 m x 100 m, which "
            + "reaches beyond the map, legal: inside latitudes 46.95000 to 47.00000 and longitudes 8.00000 to 8.06000");
        refused(all("a.tif").around(-46.99, 8.01, 100, 100), "reaches beyond the map");
        refused(all("a.tif").sized(100, 100, 0, 10), "no setSize for a georeferenced map");
    }

    @Test
    public void tooManyPosts() throws IOException {
        int[] flat = new int[40 * 40];
        write("a.tif", TiffMaker.heights(40, 40, 8, 47, STEP / 10, flat).bytes());
        write("b.tif", TiffMaker.heights(40, 40, 11, 44, STEP / 10, flat).bytes());
        refused(all("a.tif", "b.tif"), "a.tif: the number of posts (");
        refused(all("a.tif", "b.tif"), "legal: 9 to 150000000");
    }

    @Test
    public void greysBecomeHeights() throws IOException {
        for (int type : new int[] {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY,
            BufferedImage.TYPE_INT_RGB}) {
            BufferedImage image = new BufferedImage(21, 11, type);
            int white = type == BufferedImage.TYPE_USHORT_GRAY ? 65535 : 255;
            for (int i = 0; i < 21 * 11; i++) {
                for (int band = 0; band < image.getRaster().getNumBands(); band++) {
                    image.getRaster().setSample(i % 21, i / 21, band, i % 21 == 20 ? white : 0);
                }
            }
            ByteArrayOutputStream png = new ByteArrayOutputStream();
            ImageIO.write(image, "png", png);
            write("hills" + type + ".png", png.toByteArray());
            Ground ground = load(all("hills" + type + ".png").sized(100, 200, 50, 150));
            assertNull(ground.origin);
            assertEquals(50, ground.altitude, 1e-6);
            assertEquals(0, ground.field.height(-50, 90), 1e-4);
            assertEquals(100, ground.field.height(50, 100), 1e-4);
            assertEquals(50, ground.field.height(0, 95), 1e-4);
            assertTrue(Double.isNaN(ground.field.height(50.01, 0)));
            assertThrows(IllegalStateException.class, () -> ground.height(47, 8));
        }
        refused(all("hills10.png"), "hills10.png: the size is not known, legal: setSize(northSouth, eastWest, lowest, "
            + "highest) in metres");
        refused(all("hills10.png").around(47, 8, 10, 10), "no setArea for a map without a georeference");
    }

    @Test
    public void aColouredPictureIsNotAMap() throws IOException {
        BufferedImage image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        image.setRGB(2, 3, 0x102030);
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        write("colours.png", png.toByteArray());
        refused(all("colours.png").sized(10, 10, 0, 1), "colours.png: the picture is coloured (row 3), legal: greys of "
            + "8 or 16 bits");
        write("cut.png", Arrays.copyOf(png.toByteArray(), 40));
        refused(all("cut.png").sized(10, 10, 0, 1), "cut.png: the picture");
    }

    @Test
    public void aGridInMetresHasItsOwnSize() throws IOException {
        write("local.asc", "ncols 3\nnrows 3\nxllcenter 500000\nyllcenter 0\ncellsize 30\n1 2 3\n4 5 6\n7 8 9\n");
        Ground own = load(all("local.asc"));
        assertEquals(5, own.altitude, 1e-6);
        assertEquals(-3, own.field.height(30, 0), 1e-5);
        assertEquals(1, own.field.height(0, 30), 1e-5);
        assertNull(own.origin);
        Ground sized = load(all("local.asc").sized(600, 600, 0, 80));
        assertEquals(40, sized.altitude, 1e-6);
        assertEquals(-30, sized.field.height(300, 0), 1e-4);
        write("local.prj", "PROJCS[\"WGS_1984_UTM_Zone_16N\",GEOGCS[\"GCS_WGS_1984\"]]");
        assertEquals(-87, load(all("./local.asc")).origin.getLongitude(), 0.001);
    }

    @Test
    public void tilesOfOtherSystemsAndNone() throws IOException {
        tile("a.tif", 0, 0, 40, 40, (c, r) -> 100);
        int[] keys = {1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 32632};
        write("utm.tif", TiffMaker.heights(3, 3, 500000, 5200000, 30, 1, 2, 3, 4, 5, 6, 7, 8, 9)
            .with(34735, keys).bytes());
        refused(all("a.tif", "utm.tif"), "utm.tif: the coordinate system is EPSG:32632, legal: EPSG:4326 as in a.tif");
        keys[11] = 9999;
        write("unknown.tif", TiffMaker.heights(3, 3, 500000, 5200000, 30, 1, 2, 3, 4, 5, 6, 7, 8, 9)
            .with(34735, keys).bytes());
        refused(all("unknown.tif"), "unknown.tif: the coordinate system is EPSG:9999, legal: a horizontal system of "
            + "the EPSG register: convert the map by gdalwarp -t_srs EPSG:4326 unknown.tif");
        write("wrong.tif", TiffMaker.heights(3, 3, 500000, 5200000, 30, 1, 2, 3, 4, 5, 6, 7, 8, 9).bytes());
        refused(all("wrong.tif"), "wrong.tif: the centre of the map is latitude ");
    }

    @Test
    public void foreignFilesAreRejectedWithTheirType() throws IOException {
        List<String[]> kinds = Arrays.asList(new String[] {"\u0089HDF\r\n", "a NetCDF or HDF5"},
            new String[] {"CDF\1", "a NetCDF"},
            new String[] {"\0\0\0\fjP  \r\n", "a JPEG 2000"}, new String[] {"GRIB", "a GRIB"},
            new String[] {"<kml>", "XML or HTML"},
            new String[] {"hello", "in no known format"}, new String[] {"PK\3\4", "a zip"},
                new String[] {"%PDF-1.4", "a PDF"});
        for (String[] kind : kinds) {
            write("map.tif", kind[0]);
            refused(all("map.tif"), "map.tif: the file is " + kind[1] + ", legal: SRTM (.hgt, .hgt.zip), "
                + "GeoTIFF (.tif)");
        }
        write("n36.dt2", "UHL1");
        refused(all("n36.dt2"), "n36.dt2: the file is a DTED, legal: SRTM (.hgt, .hgt.zip), GeoTIFF (.tif), ESRI ASCII "
            + "grid (.asc) or a grey picture "
            + "(.png, .jpg, .bmp): convert other elevation maps by gdal_translate n36.dt2 n36_converted.tif");
        write("utah.dem", "UTAH     ");
        refused(all("utah.dem"), "utah.dem: the file is a USGS DEM, legal: SRTM (.hgt, .hgt.zip), GeoTIFF (.tif)");
        write("map.tif", "");
        refused(all("map.tif"), "map.tif: the file's size is 0, legal: 1 to 4294967296");
        refused(all("none.tif"), "no asset \"none.tif\": save the file as ");
    }
}
