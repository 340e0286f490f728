// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.format;

import java.util.Map;
import java.util.TreeMap;

/** Converts a user-defined projection in a GeoTIFF's keys (OGC GeoTIFF 1.1, annex C) to PROJ parameters. */
final class OwnProjection {
    private static final int METHOD = 3075;
    private static final int UNITS = 3076;
    private static final int GEOGRAPHIC = 2048;
    private static final int DATUM = 2050;
    private static final int ELLIPSOID = 2056;
    private static final int USER_DEFINED = 32767;
    private static final Map<Integer, String> METHODS = Map.of(1, "tmerc", 8, "lcc", 10, "laea", 11, "aea");
    /**
     * Ellipsoids by EPSG number of the geographic system, datum or ellipsoid: those that equal WGS 84 within one or two
     * metres.
     */
    private static final Map<Integer, String> ELLIPSOIDS = Map.of(4326, "WGS84", 4269, "GRS80", 4258, "GRS80", 6318,
        "GRS80", 6326, "WGS84", 6269, "GRS80", 6258, "GRS80", 1116, "GRS80", 7030, "WGS84", 7019, "GRS80");
    private static final Map<Integer, String> METRES = Map.of(9001, "m", 9002, "ft", 9003, "us-ft");
    /** PROJ name of each parameter and the keys that may contain it. */
    private static final Object[][] PARAMETERS = {
        {"lat_1", 3078}, {"lat_2", 3079}, {"lon_0", 3080, 3084, 3088}, {"lat_0", 3081, 3085, 3089}, {"x_0", 3082, 3086},
            {"y_0", 3083, 3087},
        {"k_0", 3092},
    };

    private OwnProjection() {
    }

    /**
     * Returns the projection as PROJ parameters.
     * @param keys whole-number keys of the GeoTIFF
     * @param values floating-point keys
     * @return null for an unsupported projection
     */
    static String of(Map<Integer, Integer> keys, Map<Integer, Double> values) {
        String method = METHODS.get(keys.getOrDefault(METHOD, 0));
        String unit = METRES.get(keys.getOrDefault(UNITS, 9001));
        int number = known(keys, GEOGRAPHIC) ? GEOGRAPHIC : known(keys, DATUM) ? DATUM : ELLIPSOID;
        String ellipsoid = ELLIPSOIDS.get(keys.getOrDefault(number, 0));
        if (method == null || unit == null || ellipsoid == null) {
            return null;
        }
        Map<String, Double> parameters = new TreeMap<>();
        for (Object[] parameter : PARAMETERS) {
            for (int i = 1; i < parameter.length; i++) {
                Double value = values.get(parameter[i]);
                if (value != null) {
                    parameters.put((String) parameter[0], value);
                }
            }
        }
        for (String length : new String[] {"x_0", "y_0"}) {
            parameters.computeIfPresent(length, (name, value) -> value * metres(unit));
        }
        return text(method, parameters, ellipsoid, "units=" + unit);
    }

    /**
     * Formats PROJ parameters.
     * @param parameters by PROJ's names; lengths in metres
     * @param unit of map coordinates, as units=m or to_meter=0.9144
     */
    static String text(String method, Map<String, Double> parameters, String ellipsoid, String unit) {
        return projection("+proj=" + method, " +", parameters) + " +ellps=" + ellipsoid + " +towgs84=0,0,0 +" + unit
            + " +no_defs";
    }

    /**
     * Formats a projection without its datum and unit.
     * @param start text before the parameters
     * @param between text before each parameter
     * @param parameters by PROJ's names; lengths in metres
     */
    static String projection(String start, String between, Map<String, Double> parameters) {
        StringBuilder text = new StringBuilder(start);
        parameters.forEach((name, value) -> text.append(between).append(name).append('=').append(value));
        return text.toString();
    }

    private static boolean known(Map<Integer, Integer> keys, int key) {
        return keys.containsKey(key) && keys.get(key) != USER_DEFINED;
    }

    private static double metres(String unit) {
        return unit.equals("m") ? 1 : unit.equals("ft") ? 0.3048 : 1200 / 3937.0;
    }
}
