// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.Arrays;
import org.SEAR.terrain.tiff.MapBytes;
import org.junit.Test;

/**
 * TIFFs that are broken, contradictory or meant for something else: each is rejected with the error and the legal
 * value.
 */
public class HostileTiffTest {
    private static final int[] HEIGHTS = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};

    private static TiffMaker good() {
        return TiffMaker.heights(4, 3, 8, 47, 0.001, HEIGHTS);
    }

    private static float[] read(byte[] bytes) throws IOException {
        GeoTiff map = GeoTiff.open(MapBytes.of("a.tif", bytes));
        return map.read(0, 0, map.rows, map.columns);
    }

    private static void refused(TiffMaker tiff, String message) {
        IOException e = assertThrows(message, IOException.class, () -> read(tiff.bytes()));
        assertTrue(e.getMessage(), e.getMessage().startsWith("a.tif: "));
        assertTrue(e.getMessage(), e.getMessage().contains(message));
    }

    @Test
    public void aRingOfDirectoriesIsNotFollowed() throws IOException {
        assertArrayEquals(new float[] {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}, read(good().bytes()), 0);
    }

    @Test
    public void truncatedFilesAreRejectedUnlessStillComplete() {
        byte[] whole = good().bytes();
        for (int length = 1; length < whole.length; length++) {
            byte[] cut = Arrays.copyOf(whole, length);
            IOException e = assertThrows("" + length, IOException.class, () -> read(cut));
            assertTrue(e.getMessage(), e.getMessage().startsWith("a.tif: ") && e.getMessage().contains(", legal: "));
        }
    }

    @Test
    public void sizesThatLie() {
        refused(good().with(256, 1 << 30).with(257, 2), "ImageWidth is 1073741824, legal: 1 to 1000000");
        refused(good().with(256, 65536).with(257, 32768), "the number of");
        refused(good().with(257, 0), "ImageLength is 0");
        refused(good().with(256, 1000000).with(257, 1000000).with(278, 1), "the number of values of StripOffsets is 1, "
            + "legal: 1000000");
        refused(good().with(322, 1000000).with(323, 1000000).with(324, 8).with(325, 24),
            "tile 0 is 6000000 bytes at 8, legal: inside the file");
        refused(good().with(279, -1).with(259, 8), "the number of bytes of strip 0 is 4294967295, legal: 1 "
            + "to 134217728");
        refused(good().with(273, 100000), "strip 0 is 24 bytes at 100000, legal: inside the file");
        refused(good().with(278, 1), "the number of values of StripOffsets is 1, legal: 3");
    }

    @Test
    public void unreadableFilesAreRejected() {
        refused(good().with(277, 3), "SamplesPerPixel is 3, legal: 1");
        refused(good().with(258, 12), "BitsPerSample is 12, legal: 8, 16, 32 or 64");
        refused(good().with(259, 7), "Compression is 7 (JPEG), legal: 1 (none)");
        refused(good().with(259, 34887), "Compression is 34887 (LERC)");
        refused(good().with(339, 6), "SampleFormat is 6 with 16 bits");
        refused(good().with(317, 3).with(259, 8), "Predictor is 3, legal: 1 or 2 for whole numbers");
        refused(good().with(34735, new int[] {1, 1, 0, 1, 3072, 0, 1, 32767}),
            "the coordinate system is defined by user");
        refused(good().with(34735, new int[] {1, 1, 0, 1, 1024, 0, 1, 3}), "the coordinate system is geocentric");
        refused(good().with(34735, new int[] {1, 1, 0, 1, 4099, 0, 1, 9999}), "the unit of heights is EPSG 9999");
        refused(good().with(33550, new double[] {0, 0.001, 0}), "the place of the pixels");
        refused(good().with(33922, new double[] {0, 0, 0, Double.NaN, 47, 0}), "the place of the pixels");
        refused(good().with(33550, null).with(33922, new double[12]), "the place is 2 control points");
        refused(good().with(42113, "none"), "GDAL_NODATA is \"none\"");
    }

    @Test
    public void brokenPackings() {
        refused(good().with(259, 8), "strip 0 is broken (");
        refused(good().with(259, 32773), "strip 0 is cut off after");
        refused(good().with(259, 5), "strip 0 is ");
    }

    @Test
    public void noDataAndFeet() throws IOException {
        int[] feet = {1, 1, 0, 3, 1024, 0, 1, 2, 2048, 0, 1, 4326, 4099, 0, 1, 9002};
        float[] heights = read(good().with(42113, "5").with(34735, feet).bytes());
        assertEquals(0.3048, heights[0], 1e-6);
        assertTrue(Float.isNaN(heights[4]));
        assertEquals(6 * 0.3048, heights[5], 1e-6);
    }

    @Test
    public void scaleAndOffsetOfGdal() throws IOException {
        String metadata = "<GDALMetadata>\n  <Item name=\"OFFSET\" sample=\"0\" role=\"offset\">100</Item>\n"
            + "  <Item name=\"SCALE\" sample=\"0\" role=\"scale\">0.5</Item>\n</GDALMetadata>";
        assertEquals(103, read(good().with(42112, metadata).bytes())[5], 1e-6);
        refused(good().with(42112, metadata.replace("0.5", "half")), "GDAL's scale is \"half\", legal: a number");
        String feet = metadata.replace(
            "</GDALM", "  <Item name=\"UNITTYPE\" sample=\"0\" role=\"unittype\">ft</Item>\n</GDALM");
        assertEquals(103 * 0.3048, read(good().with(42112, feet).bytes())[5], 1e-5);
        refused(good().with(42112, feet.replace(">ft<", ">fathom<")), "GDAL's unit of heights is \"fathom\", legal: "
            + "one of feet, foot, ft, m,");
    }

    @Test
    public void pixelsArePointsOrAreas() throws IOException {
        GeoTiff area = GeoTiff.open(MapBytes.of("a.tif", good().bytes()));
        assertEquals(8.0005, area.place.x0, 1e-12);
        assertEquals(46.9995, area.place.y0, 1e-12);
        GeoTiff point = GeoTiff.open(MapBytes.of(
            "a.tif", good().with(34735, new int[] {1, 1, 0, 2, 1025, 0, 1, 2, 2048, 0, 1, 4326}).bytes()));
        assertEquals(8, point.place.x0, 1e-12);
        assertEquals(47, point.place.y0, 1e-12);
    }

    @Test
    public void aTransformationPlacesPixelsToo() throws IOException {
        double[] matrix = {0, 2, 0, 100, 3, 0, 0, 200, 0, 0, 0, 0, 0, 0, 0, 1};
        GeoTiff map = GeoTiff.open(MapBytes.of("a.tif", good().with(33550, null).with(33922, null)
            .with(34264, matrix).bytes()));
        assertEquals(100 + 2 * 2.5, map.place.x(1, 2), 1e-12);
        assertEquals(200 + 3 * 1.5, map.place.y(1, 2), 1e-12);
        assertEquals(1, map.place.column(map.place.x(1, 2), map.place.y(1, 2)), 1e-12);
        assertEquals(2, map.place.row(map.place.x(1, 2), map.place.y(1, 2)), 1e-12);
    }

    @Test
    public void withoutAPlaceItsValuesAreGreys() throws IOException {
        TiffMaker grey = new TiffMaker(2, 2, 8, (byte) 0, (byte) 255, (byte) 7, (byte) 9).bigEndian();
        GeoTiff map = GeoTiff.open(MapBytes.of("grey.tif", grey.bytes()));
        assertEquals(255, map.white, 0);
        assertArrayEquals(new float[] {0, 255, 7, 9}, map.read(0, 0, 2, 2), 0);
    }
}
