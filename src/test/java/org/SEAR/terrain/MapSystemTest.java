// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import org.SEAR.terrain.format.AsciiGridTest;
import org.junit.Test;

/** Coordinate systems by EPSG number. */
public class MapSystemTest {
    private static final double METRES_PER_DEGREE = 111_195;
    /**
     * EPSG number, x, y, latitude and longitude of WGS 84 by PROJ 9.5.1: old datums, feet, grads, polar, meridians,
     * axes.
     */
    private static final String[] PLACES = {
        "31467 3498667.9294936 5675312.7083448 51.21273317 8.97988671",
        "27700 586863.1289041 329499.0586072 52.83060499 0.77233913",
        "27572 744544.2821164 2282161.6444860 47.52318422 4.25609791",
        "4807 1.9114635 52.5592179 47.30324936 4.05691214",
        "31287 227333.0884966 532742.1127409 48.67010005 10.98754791",
        "21781 575198.9980154 237677.0951514 47.28951353 7.11076968",
        "2056 2790873.7505006 1166942.9046517 46.62644722 9.93133085",
        "28992 114411.8853820 446706.0347204 52.00723773 4.79605989",
        "5514 -707512.3963947 -1164862.1201293 49.04312427 15.12677662",
        "2065 1176541.6967190 249337.2806628 49.29223315 21.40230057",
        "3413 320581.3521989 278006.8839422 86.08430685 85.93170010",
        "3031 -1809365.3480224 70215.4834480 -73.44615085 -87.77765548",
        "5041 3904612.9911263 1133519.4133605 71.31387315 65.53741395",
        "5482 4964144.6101744 1420720.6264227 -86.19813960 175.12880930",
        "2193 1263913.5474723 5998688.4225269 -36.09834074 169.26716687",
        "27200 2194240.0752884 5502859.5393956 -45.61240265 168.95173410",
        "2263 1422908.2918033 196993.1064595 40.69650477 -72.41799686",
        "2222 672664.3917061 1074936.3141237 33.95476619 -110.25681477",
        "2048 15661.0203524 3436006.7833614 -31.04528640 18.83594010",
        "3857 5313795.0131099 7851290.4843706 57.44339742 47.73463277",
        "3994 6885670.7588822 -3726713.0911317 -40.63503052 -178.15943889",
        "31370 113510.2214976 174177.3653889 50.87682145 3.85028566",
        "3021 1490949.6058625 6719154.1476889 60.58967363 15.63997086",
        "28404 4461215.6079324 5467087.8969102 49.33438808 20.46462674",
        "2180 555823.0685852 727753.5477389 54.41073844 19.86037420",
        "3408 -2176003.7768289 -2066894.9131929 62.75478875 -46.47307310",
        "27561 768729.2288755 303748.2264903 50.40886218 4.71044710",
        "29702 736108.7252303 934689.6843334 -17.65838131 49.60552359",
        "3078 437222.9101077 576673.3955344 45.73904684 -86.80490425",
        "2039 172751.1959020 703998.4310174 32.42898975 34.70785367",
        "2154 881902.3557033 7000419.3045281 50.07580107 5.53899539",
        "4490 124.9260106 24.1684966 24.16849662 124.92601058",
        "23030 416354.8903908 5604148.8982693 50.58128601 -4.18287588",
        "2326 861341.3313169 805015.5270780 22.18350144 114.42000007",
        "26986 148815.1157703 917843.2148338 42.50945047 -72.12280702",
        "2314 236202.7598349 471041.1293538 11.15226636 -61.46539518",
        "4314 11.9330582 49.5850508 49.58396702 11.93159625"
    };

    /**
     * Returns the distance from the place in a line of number, x, y, latitude, longitude, metres; to Earth or there and
     * back.
     */
    static double error(String line) throws IOException {
        return error("EPSG:" + line.split(" ")[0], line);
    }

    /** Returns the same in another system than that of the line's number. */
    static double error(String system, String line) throws IOException {
        String[] words = line.split(" ");
        double x = Double.parseDouble(words[1]);
        double y = Double.parseDouble(words[2]);
        double latitude = Double.parseDouble(words[3]);
        double longitude = Double.parseDouble(words[4]);
        MapSystem conversion = MapSystem.over("map.tif", system, x, y);
        double[] map = new double[2];
        conversion.toMap(latitude, longitude, map);
        return Math.max(distance(conversion.toEarth(x, y), latitude, longitude),
            distance(conversion.toEarth(map[0], map[1]), latitude, longitude));
    }

    private static double distance(double[] place, double latitude, double longitude) {
        double east = Math.IEEEremainder(place[1] - longitude, 360) * Math.cos(Math.toRadians(latitude));
        return METRES_PER_DEGREE * Math.hypot(place[0] - latitude, east);
    }

    private static void assertRefused(String system, String reason) {
        String message = assertThrows(IOException.class, () -> MapSystem.over("maps/old.tif", system, 100, 100))
            .getMessage();
        assertTrue(message, message.startsWith("maps/old.tif: ") && message.contains(system)
            && message.contains(reason));
        assertTrue(message, message.contains("gdalwarp -t_srs EPSG:4326 old.tif wgs84.tif"));
    }

    @Test
    public void placesAreThoseOfProj() throws IOException {
        for (String line : PLACES) {
            assertEquals(line, 0, error(line), 0.1);
        }
    }

    /** Lines of prj-files.txt: EPSG number, x, y, PROJ's latitude and longitude, and a .prj without numbers. */
    @Test
    public void projectionsByTheirNamesAreThoseOfProj() throws IOException {
        try (InputStream in = MapSystemTest.class.getResourceAsStream("prj-files.txt")) {
            for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
                String[] parts = line.split("\t");
                assertEquals(line, 0, error(AsciiGridTest.prj(parts[1]), parts[0]), 0.5);
            }
        }
    }

    @Test
    public void systemsThatSearCannotConvertAreRefusedByName() {
        assertRefused("EPSG:5233", "(SLD99), legal: one with a datum shift within 5 m; this one has none "
            + "without grid files that is more certain than 14 m");
        assertRefused("EPSG:3821", "(TWD67), legal: one with a datum shift within 5 m; this one has none without "
            + "grid files: ");
        assertRefused("EPSG:5880", "American Polyconic");
        assertRefused("EPSG:29873", "Hotine Oblique Mercator (variant B)");
        assertRefused("EPSG:2218", "Lambert Conic Conformal (West Orientated)");
        assertRefused("EPSG:4979", "legal: a horizontal system of the EPSG register");
        assertRefused("EPSG:0", "legal: a horizontal system of the EPSG register");
    }

    /** The projection of a .prj on a datum by its name has the same shift as the EPSG number of the whole. */
    @Test
    public void aProjectionOnAKnownDatumEqualsItsNumber() throws IOException {
        String[][] pairs = {{"EPSG:4314 tmerc k_0=1.0 lat_0=0.0 lon_0=9.0 x_0=3500000.0 y_0=0.0 units=m", "EPSG:31467",
            "3498667.9", "5675312.7"},
            {"EPSG:4277 tmerc k_0=0.9996012717 lat_0=49.0 lon_0=-2.0 x_0=400000.0 y_0=-100000.0 units=m", "EPSG:27700",
                "586863.1", "329499.1"},
            {"EPSG:4289 sterea k_0=0.9999079 lat_0=52.1561605555556 lon_0=5.38763888888889 x_0=155000.0 "
                + "y_0=463000.0 units=m", "EPSG:28992", "114411.9", "446706.0"}};
        for (String[] pair : pairs) {
            double x = Double.parseDouble(pair[2]);
            double y = Double.parseDouble(pair[3]);
            double[] place = MapSystem.over("a.asc", pair[0], x, y).toEarth(x, y);
            double[] expected = MapSystem.over("a.asc", pair[1], x, y).toEarth(x, y);
            assertEquals(pair[1], 0, distance(place, expected[0], expected[1]), 1e-4);
        }
    }

    @Test
    public void aPlaceOutsideTheAreasOfAllDatumShiftsIsRefused() {
        String message = assertThrows(IOException.class, () -> MapSystem.at("old.tif", "EPSG:4230", 10, 100))
            .getMessage();
        assertTrue(message, message.contains("EPSG:4230 (ED50), legal: at latitude 10.0000, longitude 100.0000 one "
            + "with a datum shift within 5 m"));
    }

    @Test
    public void shiftsOfModernDatumsCountEverywhere() throws IOException {
        assertEquals(61.5, MapSystem.at("map.tif", "EPSG:4258", 61.5, -27).toEarth(-27, 61.5)[0], 1e-9);
    }
}
