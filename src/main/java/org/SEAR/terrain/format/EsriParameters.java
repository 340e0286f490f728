// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.io.IOException;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
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
    private static final Pattern DATUM = Pattern.compile("DATUM\\[\"([^\"]+)\"", Pattern.CASE_INSENSITIVE);
    private static final Pattern MERIDIAN = Pattern.compile("PRIMEM\\[\"([^\"]*)\"" + NUMBER + "[\\],]",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern UNIT = Pattern.compile("UNIT\\[\"[^\"]*\"" + NUMBER + "[\\],]",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern ELLIPSOID = Pattern.compile("SPHEROID\\[\"[^\"]*\"" + NUMBER + NUMBER + "[\\],]",
        Pattern.CASE_INSENSITIVE);
    private static final Pattern EAST = Pattern.compile("AXIS\\[\"[^\"]*\",\\s*EAST\\]", Pattern.CASE_INSENSITIVE);
    /** Mercator's projection with the formulas of a sphere on an ellipsoid. */
    private static final Pattern WEB = Pattern.compile("Mercator_Auxiliary_Sphere|Pseudo.Mercator|nadgrids=@null",
        Pattern.CASE_INSENSITIVE);
    private static final String LONGITUDE = "lon_0";
    private static final String EASTING = "x_0";
    private static final String NORTHING = "y_0";
    private static final Map<String, String> PARAMETERS = Map.ofEntries(Map.entry("false_easting", EASTING),
        Map.entry("false_northing", NORTHING), Map.entry("central_meridian", LONGITUDE),
        Map.entry("longitude_of_center", LONGITUDE), Map.entry("longitude_of_origin", LONGITUDE),
        Map.entry("latitude_of_origin", "lat_0"), Map.entry("latitude_of_center", "lat_0"),
        Map.entry("standard_parallel_1", "lat_1"), Map.entry("standard_parallel_2", "lat_2"),
        Map.entry("scale_factor", "k_0"), Map.entry("azimuth", "alpha"), Map.entry("rectified_grid_angle", "gamma"),
        Map.entry("xy_plane_rotation", "gamma"), Map.entry("pseudo_standard_parallel_1", "pseudo"),
        Map.entry("x_scale", "x_scale"), Map.entry("y_scale", "y_scale"), Map.entry("auxiliary_sphere_type", "sphere"));
    private static final Set<String> NO_ANGLES = Set.of(EASTING, NORTHING, "k_0", "x_scale", "y_scale", "sphere");
    /** Names of datums that equal WGS 84 within one or two metres. */
    private static final Pattern NEAR_WGS84 =
        Pattern.compile("(D_)?(WGS_1984|ETRS_1989|European_Terrestrial_Reference_System_1989|RGF_?(19)?93\\w*|"
        + "Reseau_Geodesique_Francais_1993\\w*|North_American_(Datum_)?1983|NAD_?1983\\w*|GDA_?(1994|2020)|SIRGAS_2000|"
        + "NZGD_2000|JGD_20(00|11))", Pattern.CASE_INSENSITIVE);
    private static final double DEGREE = Math.PI / 180;
    /** Longitude of the meridian of Paris in the French systems, degrees. */
    private static final double PARIS = 2.33722917;
    private static final String WEB_MERCATOR = "EPSG:3857";

    private EsriParameters() {
    }

    /**
     * Returns the projection as PROJ parameters.
     * @param text well-known text
     * @return for another datum than WGS 84 its EPSG:NUMBER before them; null for an unsupported projection
     */
    static String of(String text) throws IOException {
        Matcher name = METHOD.matcher(text);
        Matcher datum = DATUM.matcher(text);
        Matcher ellipsoid = ELLIPSOID.matcher(text);
        double[] units = units(text);
        if (!name.find() || !datum.find() || !ellipsoid.find() || units == null) {
            return null;
        }
        Map<String, Double> parameters = parameters(text, units);
        if (parameters != null && WEB.matcher(text).find()) {
            return isPlain(parameters) && datum.group(1).toUpperCase(Locale.ROOT).contains("WGS") ? WEB_MERCATOR : null;
        }
        boolean near = NEAR_WGS84.matcher(datum.group(1)).matches();
        String geographic = near ? null : DatumNames.system(text);
        EsriMethod method = parameters == null || !EsriMethod.knows(name.group(1)) ? null
            : EsriMethod.of(name.group(1), parameters, EAST.matcher(text).find(), number(ellipsoid.group(1)),
            number(ellipsoid.group(2)));
        if (method == null || !near && geographic == null) {
            return null;
        }
        String unit = unit(units[1]);
        return near ? OwnProjection.text(method.proj.replace(" ", " +"), method.parameters,
            datum.group(1).toUpperCase(Locale.ROOT).contains("WGS") ? "WGS84" : "GRS80", unit)
            : geographic + OwnProjection.projection(" " + method.proj, " ", method.parameters) + " " + unit;
    }

    /** Returns whether a projection is centred at longitude 0 and on the equator, without offsets. */
    private static boolean isPlain(Map<String, Double> parameters) {
        return parameters.entrySet().stream().allMatch(entry -> entry.getValue() == (entry.getKey().equals("k_0")
            ? 1 : 0));
    }

    /** Returns whether longitudes are in degrees from Greenwich. */
    static boolean isInDegrees(String text) {
        Matcher meridian = MERIDIAN.matcher(text);
        Matcher unit = UNIT.matcher(text);
        return (!meridian.find() || number(meridian.group(2)) == 0) && unit.find() && isDegree(number(unit.group(1)));
    }

    private static boolean isDegree(double unit) {
        return Math.abs(unit / DEGREE - 1) <= 1e-9;
    }

    /**
     * Returns the parameters by PROJ's names, in degrees from Greenwich and metres; null if one is unknown.
     *
     * @param units degrees, metres
     */
    private static Map<String, Double> parameters(String text, double... units) {
        Map<String, Double> parameters = new TreeMap<>();
        Matcher parameter = PARAMETER.matcher(text);
        while (parameter.find()) {
            String name = PARAMETERS.get(parameter.group(1).toLowerCase(Locale.ROOT));
            double value = number(parameter.group(2));
            if (name == null || !Double.isFinite(value)) {
                return null;
            }
            boolean isLength = name.equals(EASTING) || name.equals(NORTHING);
            parameters.put(name, isLength ? value * units[1] : NO_ANGLES.contains(name) ? value
                : units[0] == 1 ? value : value * units[0]);
        }
        double greenwich = meridian(text);
        if (greenwich != 0) {
            parameters.merge(LONGITUDE, greenwich, Double::sum);
        }
        return Double.isNaN(greenwich) ? null : parameters;
    }

    /** Returns the longitude of the prime meridian, degrees; that of Paris may be given in grads. */
    private static double meridian(String text) {
        Matcher meridian = MERIDIAN.matcher(text);
        return !meridian.find() ? 0 : meridian.group(1).equalsIgnoreCase("Paris") ? PARIS : number(meridian.group(2));
    }

    /** Returns the first unit of the text, of angles in degrees, and the last one, of lengths in metres; or null. */
    private static double[] units(String text) {
        Matcher unit = UNIT.matcher(text);
        double first = unit.find() ? number(unit.group(1)) : 0;
        double last = unit.find() ? number(unit.group(1)) : 0;
        boolean isUsual = first > 0 && first < 1 && last > 1e-3 && last < 1e4;
        return isUsual ? new double[] {isDegree(first) ? 1 : first / DEGREE, last} : null;
    }

    /** Returns a unit of lengths as PROJ's parameter. */
    private static String unit(double metres) {
        return metres == 1 ? "units=m" : near(metres, 0.3048) ? "units=ft"
            : near(metres, 1200 / 3937.0) ? "units=us-ft" : "to_meter=" + metres;
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
