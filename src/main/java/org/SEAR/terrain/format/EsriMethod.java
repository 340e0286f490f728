// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;

/**
 * A projection method of ESRI's or OGC's well-known text, with its parameters in degrees and metres, converted to
 * PROJ's. Source of the formulas: EPSG Guidance Note 7-2.
 */
final class EsriMethod {
    private static final double POLE = 90;
    private static final double SAME = 1e-9;
    /** Pseudo standard parallel of Krovak's projection, degrees. */
    private static final double KROVAK = 78.5;
    private static final String CENTRE = "omerc";
    private static final String NATURAL_ORIGIN = "omerc no_uoff";
    /** Only supported at a pole. */
    private static final String AT_POLE = "stere pole";
    private static final String SWISS = "somerc";
    private static final Map<String, String> METHODS = Map.ofEntries(Map.entry("lambert_conformal_conic", "lcc"),
        Map.entry("lambert_conformal_conic_2sp", "lcc"), Map.entry("lambert_conformal_conic_1sp", "lcc"),
        Map.entry("albers", "aea"), Map.entry("albers_conic_equal_area", "aea"),
        Map.entry("lambert_azimuthal_equal_area", "laea"), Map.entry("transverse_mercator", "tmerc"),
        Map.entry("gauss_kruger", "tmerc"), Map.entry("transverse_mercator_south_orientated", "tmerc axis=wsu"),
        Map.entry("double_stereographic", "sterea"), Map.entry("oblique_stereographic", "sterea"),
        Map.entry("krovak", "krovak"), Map.entry("cassini", "cass"), Map.entry("cassini_soldner", "cass"),
        Map.entry("new_zealand_map_grid", "nzmg"), Map.entry("mercator", "merc"), Map.entry("mercator_1sp", "merc"),
        Map.entry("mercator_2sp", "merc"), Map.entry("stereographic", AT_POLE),
        Map.entry("polar_stereographic", "stere"), Map.entry("polar_stereographic_variant_a", "stere"),
        Map.entry("stereographic_north_pole", "stere lat_0=90"),
        Map.entry("stereographic_south_pole", "stere lat_0=-90"),
        Map.entry("hotine_oblique_mercator", NATURAL_ORIGIN),
        Map.entry("hotine_oblique_mercator_azimuth_natural_origin", NATURAL_ORIGIN),
        Map.entry("rectified_skew_orthomorphic_natural_origin", NATURAL_ORIGIN),
        Map.entry("hotine_oblique_mercator_azimuth_center", CENTRE),
        Map.entry("rectified_skew_orthomorphic_center", CENTRE), Map.entry("swiss_oblique_cylindrical", SWISS),
        Map.entry("swiss_oblique_mercator", SWISS), Map.entry("cylindrical_equal_area", "cea"),
        Map.entry("behrmann", "cea"), Map.entry("equidistant_cylindrical", "eqc"),
        Map.entry("equirectangular", "eqc"), Map.entry("plate_carree", "eqc"));

    /** PROJ method, perhaps with parameters that are no numbers. */
    final String proj;
    final Map<String, Double> parameters = new TreeMap<>();

    private EsriMethod(String proj, Map<String, Double> given) {
        this.proj = proj;
        parameters.putAll(given);
    }

    /** Returns whether a name is that of a supported method. */
    static boolean knows(String name) {
        return METHODS.containsKey(name.toLowerCase(Locale.ROOT));
    }

    /**
     * Converts a method.
     *
     * @param name as in the text, {@link #knows known}
     * @param given parameters by PROJ's names, degrees and metres; {@code gamma} is the rotation of the axes
     * @param isEast whether the text says that x grows to the east
     * @param axis semi-major axis of the ellipsoid, metres
     * @param flattening inverse flattening, 0 for a sphere
     * @return null if the values need a projection that Proj4J lacks
     */
    static EsriMethod of(String name, Map<String, Double> given, boolean isEast, double axis, double flattening) {
        EsriMethod method = new EsriMethod(METHODS.get(name.toLowerCase(Locale.ROOT)), given);
        double f = flattening == 0 ? 0 : 1 / flattening;
        return method.converted(isEast, axis, f * (2 - f));
    }

    /** @param e2 square of the ellipsoid's eccentricity */
    private EsriMethod converted(boolean isEast, double axis, double e2) {
        String kind = proj.split(" ")[0];
        if (!kind.equals("krovak") && !kind.equals("omerc")
            && (parameters.containsKey("alpha") || parameters.containsKey("gamma"))) {
            return null;
        }
        switch (kind) {
            case "lcc":
                // ESRI stores a single standard parallel as the first one, OGC as the latitude of origin
                parameters.putIfAbsent("lat_1", parameters.getOrDefault("lat_0", 0.0));
                parameters.putIfAbsent("lat_2", parameters.get("lat_1"));
                return this;
            case "krovak":
                return krovak(isEast);
            case "omerc":
                return oblique(axis, e2);
            case "merc":
                return mercator(e2);
            case "stere":
                return polar();
            case "cass":
                return take("k_0", 1) == 1 ? this : null;
            case "cea":
            case "eqc":
                parameters.put("lat_ts", take("lat_1", 0));
                return this;
            default:
                return this;
        }
    }

    private double take(String name, double otherwise) {
        Double value = parameters.remove(name);
        return value == null ? otherwise : value;
    }

    private EsriMethod krovak(boolean isEast) {
        boolean east = take("x_scale", isEast ? -1 : 1) < 0;
        parameters.remove("y_scale");
        parameters.remove("gamma");
        return Math.abs(take("pseudo", KROVAK) - KROVAK) > SAME ? null
            : east ? this : new EsriMethod("krovak axis=swu", parameters);
    }

    /** Turns a standard parallel into the scale on the equator. */
    private EsriMethod mercator(double e2) {
        double sine = Math.sin(Math.toRadians(take("lat_1", 0)));
        double scale = take("k_0", 1) * Math.sqrt((1 - sine * sine) / (1 - e2 * sine * sine));
        parameters.put("k_0", scale);
        return take("lat_0", 0) == 0 ? this : null;
    }

    private EsriMethod polar() {
        double pole = proj.endsWith("=90") ? POLE : proj.endsWith("-90") ? -POLE : Double.NaN;
        double parallel = Double.isNaN(pole) ? take("lat_0", 0) : take("lat_1", pole);
        boolean isOblique = Double.isNaN(pole) && Math.abs(parallel) != POLE
            && (proj.equals(AT_POLE) || parallel == 0 || parameters.getOrDefault("k_0", 1.0) != 1);
        EsriMethod polar = new EsriMethod("stere", parameters);
        polar.parameters.put("lat_0", Double.isNaN(pole) ? Math.copySign(POLE, parallel) : pole);
        polar.parameters.put("lat_ts", parallel);
        return isOblique ? null : polar;
    }

    /** Converts a centre of the projection to its natural origin, as Proj4J lacks the former for rotated axes. */
    private EsriMethod oblique(double axis, double e2) {
        double alpha = take("alpha", POLE);
        double gamma = take("gamma", alpha);
        if (alpha == POLE && gamma == POLE && proj.equals(CENTRE)) {
            return new EsriMethod(SWISS, parameters);
        }
        if (Math.cos(Math.toRadians(alpha)) <= 0) {
            return null;
        }
        if (proj.equals(CENTRE)) {
            double along = centre(axis, e2, Math.toRadians(alpha));
            parameters.merge("x_0", -along * Math.sin(Math.toRadians(gamma)), Double::sum);
            parameters.merge("y_0", -along * Math.cos(Math.toRadians(gamma)), Double::sum);
        }
        EsriMethod natural = new EsriMethod(NATURAL_ORIGIN, parameters);
        natural.parameters.put("lonc", natural.take("lon_0", 0));
        natural.parameters.put("alpha", (alpha + 360) % 360);
        natural.parameters.put("gamma", (gamma + 360) % 360);
        return natural;
    }

    /** Distance of the centre from the natural origin along the initial line, metres (u of method 9815). */
    private double centre(double axis, double e2, double alpha) {
        double latitude = Math.toRadians(parameters.getOrDefault("lat_0", 0.0));
        double cosine = Math.cos(latitude);
        double sine = Math.sin(latitude);
        double b = Math.sqrt(1 + e2 * Math.pow(cosine, 4) / (1 - e2));
        double a = axis * b * parameters.getOrDefault("k_0", 1.0) * Math.sqrt(1 - e2) / (1 - e2 * sine * sine);
        double d = b * Math.sqrt(1 - e2) / (cosine * Math.sqrt(1 - e2 * sine * sine));
        return Math.copySign(a / b * Math.atan2(Math.sqrt(Math.max(0, d * d - 1)), Math.cos(alpha)), latitude);
    }
}
