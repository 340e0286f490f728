// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import org.SEAR.terrain.tiff.MapBytes;
import org.junit.Test;

/** ESRI ASCII grids with their .prj files. */
public class AsciiGridTest {
    private static final String HEIGHTS = "1 2.5 -3\n-9999 5e1 +6\n";

    private static MapBytes bytes(String name, String text) throws IOException {
        return MapBytes.of(name, text.getBytes(StandardCharsets.UTF_8));
    }

    private static AsciiGrid open(String text) throws IOException {
        return AsciiGrid.open(bytes("a.asc", text), null);
    }

    private static void refused(String text, String message) {
        IOException e = assertThrows(message, IOException.class, () -> open(text));
        assertTrue(e.getMessage(), e.getMessage().startsWith("a.asc: ") && e.getMessage().contains(message));
    }

    @Test
    public void cornersAndCentres() throws IOException {
        AsciiGrid corner = open("ncols 3\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 0.1\n" + HEIGHTS);
        assertArrayEquals(new float[] {1, 2.5f, -3, Float.NaN, 50, 6}, corner.read(0, 0, 2, 3), 0);
        assertArrayEquals(new float[] {50, 6}, corner.read(1, 1, 1, 2), 0);
        assertEquals(8.05, corner.place.x(0, 1), 1e-12);
        assertEquals(47.05, corner.place.y(0, 1), 1e-12);
        assertEquals(47.15, corner.place.y(0, 0), 1e-12);
        assertEquals(Georeference.WGS84, corner.place.system);
        AsciiGrid centre = open("NCOLS 3\r\nNROWS 2\r\nXLLCENTER 8\r\nYLLCENTER 47\r\nDX 0.1\r\nDY "
            + "0.2\r\nNODATA_VALUE 6\r\n" + HEIGHTS);
        assertEquals(8, centre.place.x(0, 1), 1e-12);
        assertEquals(47.2, centre.place.y(0, 0), 1e-12);
        assertTrue(Float.isNaN(centre.read(0, 0, 2, 3)[5]));
        assertEquals(-9999, centre.read(0, 0, 2, 3)[3], 0);
    }

    @Test
    public void noDataMayBeNan() throws IOException {
        AsciiGrid grid = open("ncols 3\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 0.1\nNODATA_value nan\n1 2 "
            + "nan\nNaN 5 6\n");
        assertArrayEquals(new float[] {1, 2, Float.NaN, Float.NaN, 5, 6}, grid.read(0, 0, 2, 3), 0);
    }

    @Test
    public void metresAreNotDegrees() throws IOException {
        assertNull(open("ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 30\n" + HEIGHTS).place.system);
        assertNull(open("ncols 3\nnrows 2\nxllcorner 500000\nyllcorner 0\ncellsize 1\n" + HEIGHTS).place.system);
    }

    @Test
    public void invalidInputIsReported() {
        String head = "ncols 3\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 0.1\n";
        refused(head + "1 2 3 4 5        ", "the height in row 1, column 2, is missing, legal: a number (is the "
            + "file cut off?)");
        refused(head + "1 2 x4 4 5 6", "the height in row 0, column 2, is \"x4\", legal: a number");
        refused("ncols 3\nnrows 2\nxllcorner 8\ncellsize 0.1\n" + HEIGHTS, "yllcorner is missing");
        refused("ncols 3.5\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 0.1\n" + HEIGHTS,
            "ncols is 3.5, legal: 2 to 1000000");
        refused("ncols 1000000\nnrows 1000000\nxllcorner 8\nyllcorner 47\ncellsize 1\n1",
            "the number of posts is 1000000000000, legal: 4 to 16000000");
        refused("ncols 4000\nnrows 4000\nxllcorner 8\nyllcorner 47\ncellsize 1\n1", "the file's size is");
        refused("ncols 3\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize -1\n" + HEIGHTS,
            "cellsize is -1.0, legal: above 0");
        refused("ncols 3\nnrows 2\nxllcorner 8\nyllcorner 47\ncellsize 1\n1 2" + " ".repeat(66000) + HEIGHTS,
            "the file's size is 66");
        refused("ncols 200\nnrows 200\nxllcorner 8\nyllcorner 47\ncellsize 1\n1 2" + " ".repeat(80000) + HEIGHTS,
            "the white space before byte 65596 is more than 65536 characters, legal: less");
        refused("ncols", "ncols is missing");
        refused("ncols " + "9".repeat(100), "the text is \"9999");
    }

    /** Returns the coordinate system of a .prj. */
    public static String prj(String text) throws IOException {
        return EsriProjection.system(bytes("a.prj", text));
    }

    private static String spelled(String datum, String method, String parameter, String unit) {
        return "PROJCS[\"own\",GEOGCS[\"x\",DATUM[\"" + datum
            + "\",SPHEROID[\"GRS_1980\",6378137.0,298.257222101]],PRIMEM[\"Greenwich\",0.0],UNIT["
            + "\"Degree\",0.0174532925199433]],PROJECTION[\"" + method + "\"],PARAMETER[\"" + parameter + "],UNIT[\""
            + unit + "]]";
    }

    @Test
    public void systemsInThePrj() throws IOException {
        assertEquals("EPSG:32616", prj(
            "PROJCS[\"WGS_1984_UTM_Zone_16N\",GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\"]]]"));
        assertEquals("EPSG:26910", prj("PROJCS[\"NAD_1983_UTM_Zone_10N\",GEOGCS[\"GCS_North_American_1983\"]]"));
        assertEquals("EPSG:4326", prj(
            "GEOGCS[\"GCS_WGS_1984\",DATUM[\"D_WGS_1984\",SPHEROID[\"WGS_1984\",6378137.0,298.257223563]]]"));
        assertEquals("EPSG:4318", prj("GEOGCS[\"GCS_NGN\",DATUM[\"D_NGN\",SPHEROID[\"WGS_1984\",6378137.0,"
            + "298.257223563]],PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]]"));
        assertEquals("EPSG:4269", prj("GEOGCS[\"GCS_North_American_1983\",DATUM[\"D_North_American_1983\"]]"));
        assertEquals("EPSG:2056", prj(
            "PROJCS[\"CH1903+ / LV95\",GEOGCS[\"x\",AUTHORITY[\"EPSG\",\"4150\"]],AUTHORITY[\"EPSG\",\"2056\"]]\n"));
        assertEquals("EPSG:32719", prj("Projection    UTM\nZone          -19\nDatum         WGS84\n"));
        assertEquals("+proj=tmerc +k_0=0.9996 +lat_0=0.0 +lon_0=9.0 +x_0=500000.0 +y_0=0.0 +ellps=GRS80 +towgs84=0,0,0 "
            + "+units=m +no_defs", prj(spelled("D_ETRS_1989", "Transverse_Mercator",
                "Central_Meridian\",9],PARAMETER[\"Latitude_Of_Origin\",0],PARAMETER[\""
                + "Scale_Factor\",0.9996],PARAMETER[\"False_Easting\",500000],PARAMETER[\"False_Northing\",0",
                    "Meter\",1.0")));
        String feet = prj(spelled("D_North_American_1983", "Lambert_Conformal_Conic",
            "False_Easting\",1000],PARAMETER[\"Standard_Parallel_1\",40", "Foot_US\",0.3048006096012192"));
        assertTrue(feet, feet.startsWith("+proj=lcc +lat_1=40.0 +lat_2=40.0 +x_0=304.80")
            && feet.endsWith("+units=us-ft +no_defs"));
        for (String[] unknown : new String[][] {{"D_Mars", "Lambert_Conformal_Conic", "False_Easting\",0",
            "Meter\",1.0"},
            {"D_RGF_1993", "Polyconic", "False_Easting\",0", "Meter\",1.0"},
            {"D_RGF_1993", "Krovak", "Pseudo_Standard_Parallel_1\",70", "Meter\",1.0"},
            {"D_RGF_1993", "Stereographic", "Latitude_Of_Origin\",45", "Meter\",1.0"},
            {"D_RGF_1993", "Lambert_Conformal_Conic", "Azimuth\",0", "Meter\",1.0"},
            {"D_RGF_1993", "Lambert_Conformal_Conic", "False_Easting\",0", "Nothing\",0"}}) {
            assertThrows(unknown[0], IOException.class,
                () -> prj(spelled(unknown[0], unknown[1], unknown[2], unknown[3])));
        }
        assertEquals("EPSG:4314 tmerc k_0=1.0 lon_0=9.0 x_0=3500000.0 units=m",
            prj(spelled("D_Deutsches_Hauptdreiecksnetz", "Gauss_Kruger",
            "False_Easting\",3500000.0],PARAMETER[\"Central_Meridian\",9.0],PARAMETER[\"Scale_Factor\",1.0",
                "Meter\",1.0")));
        assertEquals("EPSG:4289 sterea x_0=0.0 units=m",
            prj(spelled("Amersfoort", "Double_Stereographic", "False_Easting\",0", "Meter\",1.0")));
        assertEquals("EPSG:4277", prj(
            "GEOGCS[\"GCS_OSGB_1936\",DATUM[\"D_OSGB_1936\",SPHEROID[\"Airy_1830\",6377563.396,299.3249646]],"
            + "PRIMEM[\"Greenwich\",0.0],UNIT[\"Degree\",0.0174532925199433]]"));
        assertEquals("EPSG:4312", prj("GEOGCS[\"MGI\",DATUM[\"Militar-Geographische_Institut\",SPHEROID[\"Bessel "
            + "1841\",6377397.155,299.1528128]],PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]"));
        assertThrows("grads from Paris", IOException.class,
            () -> prj("GEOGCS[\"GCS_NTF_Paris\",DATUM[\"D_NTF\",SPHEROID[\"Clarke_1880_IGN\","
            + "6378249.2,293.466021293627]],PRIMEM[\"Paris\",2.337229167],UNIT[\"Grad\",0.01570796326794897]]"));
        IOException e = assertThrows(IOException.class, () -> prj("PROJCS[\"Mars\"]"));
        assertTrue(e.getMessage(), e.getMessage()
            .startsWith("a.prj: the coordinate system is PROJCS[\"Mars\"], legal: one with AUTHORITY"));
    }
}
