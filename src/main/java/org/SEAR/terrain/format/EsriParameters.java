// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Converts a projection in a .prj by ESRI's or OGC's names of methods and parameters, such as Lambert 93, to PROJ
 * parameters.
 */
final class EsriParameters {
    private static final String NUMBER = "\\s*,\\s*([-+.\\dEe]+)\\s*";
    private static final Pattern METHOD = Pattern.compile("PROJECTION\\[\"(\\w+)\"", Pattern.CASE_INSENSITIVE);
    private static final Pattern PARAMETER = Pattern.compile("PARAMETER\\[\"(\\w+)\"" + NUMBER + "\\]",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern DATUM = Pattern.compile("DATUM\\[\"(\\w+)\"", Pattern.CASE_INSENSITIVE);
    private static final Pattern MERIDIAN = Pattern.compile("PRIMEM\\[\"[^\"]*\"" + NUMBER + "[\\],]",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern UNIT = Pattern.compile("UNIT\\[\"[^\"]*\"" + NUMBER + "[\\],]",
        Pattern.CASE_INSENSITIVE);
    private static final Map<String, String> METHODS =
        Map.of("lambert_conformal_conic", "lcc", "lambert_conformal_conic_2sp", "lcc",
        "lambert_conformal_conic_1sp", "lcc", "albers", "aea", "albers_conic_equal_area", "aea",
        "lambert_azimuthal_equal_area", "laea",
        "transverse_mercator", "tmerc", "gauss_kruger", "tmerc", "double_stereographic", "sterea");
    private static final Map<String, String> PARAMETERS = Map.ofEntries(Map.entry("false_easting", "x_0"),
        Map.entry("false_northing", "y_0"),
        Map.entry("central_meridian", "lon_0"), Map.entry("longitude_of_center", "lon_0"),
        Map.entry("longitude_of_origin", "lon_0"),
        Map.entry("latitude_of_origin", "lat_0"), Map.entry("latitude_of_center", "lat_0"),
        Map.entry("standard_parallel_1", "lat_1"),
        Map.entry("standard_parallel_2", "lat_2"), Map.entry("scale_factor", "k_0"));
    /** Names of datums that equal WGS 84 within one or two metres. */
    private static final Pattern NEAR_WGS84 =
        Pattern.compile("(D_)?(WGS_1984|ETRS_1989|European_Terrestrial_Reference_System_1989|RGF_?(19)?93\\w*|"
        + "Reseau_Geodesique_Francais_1993\\w*|North_American_(Datum_)?1983|NAD_?1983\\w*|GDA_?(1994|2020)|SIRGAS_2000|"
        + "NZGD_2000|JGD_20(00|11))",
        Pattern.CASE_INSENSITIVE);
    private static final double DEGREE = Math.PI / 180;

    private EsriParameters() {
    }

    /**
     * Returns the projection as PROJ parameters.
     * @param text well-known text
     * @return for another datum than WGS 84 its EPSG:NUMBER before them; null for an unsupported projection
     */
    static String of(String text) throws IOException {
        Matcher method = METHOD.matcher(text);
        Matcher datum = DATUM.matcher(text);
        String proj = method.find() ? METHODS.get(method.group(1).toLowerCase(Locale.ROOT)) : null;
        String unit = unit(text);
        if (proj == null || unit == null || !isInDegrees(text)) {
            return null;
        }
        boolean near = datum.find() && NEAR_WGS84.matcher(datum.group(1)).matches();
        String geographic = near ? null : DatumNames.system(text);
        if (!near && geographic == null) {
            return null;
        }
        Map<String, Double> parameters = parameters(text);
        if (parameters == null) {
            return null;
        }
        if (proj.equals("lcc")) {
            // ESRI stores a single standard parallel as the first one, OGC as the latitude of origin
            parameters.putIfAbsent("lat_1", parameters.getOrDefault("lat_0", 0.0));
            parameters.putIfAbsent("lat_2", parameters.get("lat_1"));
        }
        if (!near) {
            return geographic + OwnProjection.projection(" " + proj, " ", parameters, unit);
        }
        return OwnProjection.text(proj, parameters, datum.group(1).toUpperCase(Locale.ROOT).contains("WGS") ? "WGS84"
            : "GRS80", unit);
    }

    /** Returns whether longitudes are in degrees from Greenwich. */
    static boolean isInDegrees(String text) {
        Matcher meridian = MERIDIAN.matcher(text);
        Matcher unit = UNIT.matcher(text);
        return (!meridian.find() || number(meridian.group(1)) == 0) && unit.find() && isDegree(number(unit.group(1)));
    }

    private static boolean isDegree(double unit) {
        return Math.abs(unit / DEGREE - 1) <= 1e-9;
    }

    private static Map<String, Double> parameters(String text) {
        Map<String, Double> parameters = new TreeMap<>();
        Matcher parameter = PARAMETER.matcher(text);
        while (parameter.find()) {
            String name = PARAMETERS.get(parameter.group(1).toLowerCase(Locale.ROOT));
            double value = number(parameter.group(2));
            if (name == null || !Double.isFinite(value)) {
                return null;
            }
            parameters.put(name, value);
        }
        return parameters;
    }

    /**
     * Returns the projection's unit, the last one in the text. Returns null if PROJ lacks it or angles are not in
     * degrees.
     */
    private static String unit(String text) {
        Matcher unit = UNIT.matcher(text);
        double first = unit.find() ? number(unit.group(1)) : 0;
        double last = unit.find() ? number(unit.group(1)) : 0;
        if (!isDegree(first)) {
            return null;
        }
        return last == 1 ? "m" : near(last, 0.3048) ? "ft" : near(last, 1200 / 3937.0) ? "us-ft" : null;
    }

    /** Tolerance below the difference between international and US survey feet, 6e-7 m. */
    private static boolean near(double a, double b) {
        return Math.abs(a - b) < 1e-9;
    }

    private static double number(String text) {
        try {
            return Double.parseDouble(text);
        } catch (NumberFormatException e) {
            return Double.NaN;
        }
    }
}
