// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import java.util.Set;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;
import org.SEAR.terrain.tiff.TiffFile;

/** Georeference and vertical unit in a GeoTIFF (OGC GeoTIFF 1.1). */
final class GeoKeys {
    private static final int PIXEL_SCALE = 33550;
    private static final int TIE_POINTS = 33922;
    private static final int TRANSFORMATION = 34264;
    private static final int DIRECTORY = 34735;
    private static final int PARAMETERS = 34736;
    private static final int MODEL_TYPE = 1024;
    private static final int RASTER_TYPE = 1025;
    private static final int GEOGRAPHIC = 2048;
    private static final int ANGULAR_UNITS = 2054;
    private static final int PROJECTED = 3072;
    private static final int VERTICAL = 4096;
    private static final int VERTICAL_UNITS = 4099;
    private static final int USER_DEFINED = 32767;
    private static final int DEGREE = 9102;
    private static final int GRAD = 9105;
    /** Geographic systems of the Paris meridian, whose coordinates are grads. */
    private static final Set<Integer> IN_GRADS = Set.of(4807, 4810, 4811, 4816, 4819, 4821, 4901, 4902);
    private static final String WARP = "gdalwarp -t_srs EPSG:4326 ";
    private static final int PIXEL_IS_POINT = 2;
    private static final int GEOCENTRIC = 3;
    private static final Map<Integer, Double> METRES = Map.of(9001, 1.0, 9002, 0.3048, 9003, 1200 / 3937.0);
    /** EPSG numbers of vertical systems in feet (NAVD 88, NGVD 29), with the foot's length in metres. */
    private static final Map<Integer, Double> VERTICAL_FEET = Map.of(6360, 1200 / 3937.0, 5702, 1200 / 3937.0,
        8228, 0.3048);

    private final TiffFile file;
    private final Map<Integer, Integer> keys = new HashMap<>();
    private final Map<Integer, Double> values = new HashMap<>();

    GeoKeys(TiffFile file) throws IOException {
        this.file = file;
        long[] all = file.longs(DIRECTORY, "the GeoKeyDirectory", 4096);
        double[] numbers = file.doubles(PARAMETERS, "the GeoDoubleParams", 4096);
        for (int i = 4; all != null && i + 3 < all.length; i += 4) {
            if (all[i + 1] == 0) {
                keys.put((int) all[i], (int) all[i + 3]);
            } else if (all[i + 1] == PARAMETERS && numbers != null && all[i + 3] < numbers.length) {
                values.put((int) all[i], numbers[(int) all[i + 3]]);
            }
        }
    }

    /** Returns the length of the elevations' unit in metres. */
    double metres() throws IOException {
        int unit = keys.getOrDefault(VERTICAL_UNITS, 0);
        if (unit != 0 && unit != USER_DEFINED) {
            Double metres = METRES.get(unit);
            if (metres == null) {
                throw FileLimits.wrong(file.name, "the unit of heights", "EPSG " + unit,
                    "9001 (metre), 9002 (foot) or 9003 (US survey foot)");
            }
            return metres;
        }
        return VERTICAL_FEET.getOrDefault(keys.getOrDefault(VERTICAL, 0), 1.0);
    }

    /** Returns the georeference of the pixels' centres, or null. */
    Georeference place() throws IOException {
        double[] matrix = file.doubles(TRANSFORMATION, "ModelTransformation", 16);
        double[] scale = file.doubles(PIXEL_SCALE, "ModelPixelScale", 3);
        double[] ties = file.doubles(TIE_POINTS, "ModelTiepoint", 6 * 4096);
        Georeference corner;
        if (scale != null && ties != null && scale.length >= 2 && ties.length >= 6) {
            corner = new Georeference(system(), ties[3] - ties[0] * scale[0], ties[4] + ties[1] * scale[1], scale[0], 0,
                0, -scale[1]);
        } else if (matrix != null && matrix.length == 16) {
            corner = new Georeference(system(), matrix[3], matrix[7], matrix[0], matrix[4], matrix[1], matrix[5]);
        } else if (ties != null && ties.length > 6) {
            throw FileLimits.wrong(file.name, "the place", ties.length / 6 + " control points",
                "ModelPixelScale and ModelTiepoint, or ModelTransformation: convert the map by " + warp());
        } else {
            return null;
        }
        if (!corner.isRegular()) {
            throw FileLimits.wrong(file.name, "the place of the pixels", corner.x0 + ", " + corner.y0 + " in steps of "
                + corner.xColumn + ", " + corner.yRow, "finite numbers, steps other than 0");
        }
        return keys.getOrDefault(RASTER_TYPE, 1) == PIXEL_IS_POINT ? corner : corner.from(0.5, 0.5);
    }

    /** Returns the command of GDAL that converts the map. */
    private String warp() {
        return WARP + PrintableText.line(file.name.substring(file.name.lastIndexOf('/') + 1)) + " wgs84.tif";
    }

    private String system() throws IOException {
        int geographic = keys.getOrDefault(GEOGRAPHIC, 0);
        int projected = keys.getOrDefault(PROJECTED, 0);
        String own = projected == USER_DEFINED ? OwnProjection.of(keys, values) : null;
        if (own != null) {
            return own;
        }
        boolean geocentric = keys.getOrDefault(MODEL_TYPE, 0) == GEOCENTRIC;
        if (geocentric || projected == USER_DEFINED || projected == 0 && geographic == USER_DEFINED) {
            throw FileLimits.wrong(file.name, "the coordinate system", geocentric ? "geocentric" : "defined by user",
                "one with an EPSG number: convert it, for example by " + warp());
        }
        int expected = IN_GRADS.contains(geographic) ? GRAD : DEGREE;
        if (projected == 0 && geographic != 0 && keys.getOrDefault(ANGULAR_UNITS, expected) != expected) {
            throw FileLimits.wrong(file.name, "the unit of angles", "EPSG " + keys.get(ANGULAR_UNITS),
                expected + (expected == GRAD ? " (grad)" : " (degree)") + " for EPSG:" + geographic);
        }
        int number = projected != 0 ? projected : geographic;
        return number == 0 ? null : "EPSG:" + number;
    }
}
