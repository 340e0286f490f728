// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.files.FileLimits;
import org.SEAR.files.PrintableText;

/**
 * Definition of a coordinate system of the EPSG register, with the datum shifts to WGS 84 for parts of the Earth.
 * Source: systems.txt, whose header explains its lines. Immutable, any thread.
 */
final class EpsgSystem {
    private static final String FILE = "systems.txt";
    private static final String EPSG = "EPSG:";
    private static final double SAME = 1e-9;
    private static final String WGS84 = "6378137 298.257223563";
    private static final String GRS80 = "6378137 298.257222101";
    private static final int NAME = 6;
    /** Index of the first of a shift's seven parameters, after west, south, east, north and uncertainty. */
    private static final int X = 5;
    private static final int AREAS = 4;

    /** Unit of a geographic system's coordinates, degrees; 0 for a projected system. */
    final double unit;
    private final String file;
    /** EPSG number and name of the geographic system, for messages. */
    private final String title;
    private final String ellipsoid;
    private final String meridian;
    /** PROJ parameters of the projection, without the datum. */
    private final String projection;
    private final List<double[]> shifts;

    private EpsgSystem(String file, String code, String[] datum, List<double[]> shifts, String projection) {
        this.file = file;
        this.title = EPSG + code + " (" + datum[NAME] + ")";
        this.unit = projection == null ? Double.parseDouble(datum[5]) : 0;
        this.ellipsoid = ellipsoid(datum[2], datum[3]);
        this.meridian = Double.parseDouble(datum[4]) == 0 ? "" : " +pm=" + datum[4];
        this.shifts = shifts;
        this.projection = projection == null ? "+proj=longlat" : "+proj=" + projection.replace(" ", " +");
    }

    private static String ellipsoid(String axis, String flattening) {
        String both = axis + ' ' + flattening;
        double inverse = Double.parseDouble(flattening);
        // Proj4J takes +rf for the flattening itself
        double minor = Double.parseDouble(axis) * (inverse == 0 ? 1 : 1 - 1 / inverse);
        return both.equals(WGS84) ? "+ellps=WGS84" : both.equals(GRS80) ? "+ellps=GRS80" : "+a=" + axis
            + " +b=" + minor;
    }

    /**
     * Reads a definition.
     * @param file the map's name for messages
     * @param system EPSG:NUMBER, or that of a geographic system and a projection on it, as
     * {@code EPSG:4314 tmerc lon_0=9}
     * @throws IOException for an unknown system, and for a known one without support, with the reason
     */
    static EpsgSystem of(String file, String system) throws IOException {
        int space = system.indexOf(' ');
        String own = space < 0 ? null : system.substring(space + 1);
        String code = (space < 0 ? system : system.substring(0, space)).replaceFirst("^" + EPSG, "");
        try (InputStream in = EpsgSystem.class.getResourceAsStream(FILE);
            BufferedReader lines = new BufferedReader(new InputStreamReader(in, StandardCharsets.UTF_8))) {
            Search search = new Search(code);
            String line = lines.readLine();
            while (line != null && search.reads(line)) {
                line = lines.readLine();
            }
            if (!search.found) {
                throw unsupported(file, system, "a horizontal system of the EPSG register");
            }
            if (search.unsupported) {
                throw unsupported(file, system + ", " + search.projection,
                    "one with a projection that docs/terrain.md lists");
            }
            if (search.missing != null) {
                throw unsupported(file, EPSG + code + " (" + search.datum[NAME] + ")",
                    "one with a datum shift within 5 m; this one has none without "
                    + "grid files" + (search.missing.equals("0") ? "" : " that is more certain than "
                        + search.missing + " m"));
            }
            return new EpsgSystem(file, code, search.datum, search.shifts, own == null ? search.projection : own);
        }
    }

    /** Search for a system in the list, line by line: a datum, its shifts, and the projected systems on it. */
    private static final class Search {
        final String code;
        final List<double[]> shifts = new ArrayList<>();
        String[] datum;
        /** Uncertainty of the best shift if none is certain enough, metres; null if one is. */
        String missing;
        String projection;
        /** Whether SEAR lacks the projection. */
        boolean unsupported;
        boolean found;

        Search(String code) {
            this.code = code;
        }

        /** Reads the next line. Returns whether the search goes on: a geographic system's shifts follow it. */
        boolean reads(String line) {
            switch (line.charAt(0)) {
                case 'D':
                    return !found && begin(line.split(" ", NAME + 1));
                case 'S':
                    shifts.add(numbers(line));
                    return true;
                case 'N':
                    missing = line.substring(2);
                    return true;
                default:
                    return !ends(line);
            }
        }

        private boolean begin(String... words) {
            datum = words;
            shifts.clear();
            missing = null;
            found = words[1].equals(code);
            return true;
        }

        /** Returns whether the line is that of the projected system. */
        private boolean ends(String line) {
            char kind = line.charAt(0);
            if (kind != 'P' && kind != 'X' || !line.startsWith(code + ' ', 2)) {
                return false;
            }
            projection = line.substring(3 + code.length());
            unsupported = kind == 'X';
            found = true;
            return true;
        }
    }

    private static double[] numbers(String line) {
        String[] words = line.substring(2).split(" ");
        double[] numbers = new double[words.length];
        for (int i = 0; i < words.length; i++) {
            numbers[i] = Double.parseDouble(words[i]);
        }
        return numbers;
    }

    /** Returns the exception for a system that SEAR does not read, with the command that converts the map. */
    static IOException unsupported(String file, String system, String legal) {
        return FileLimits.wrong(file, "the coordinate system", system, legal + ": convert the map by gdalwarp "
            + "-t_srs EPSG:4326 " + PrintableText.line(file.substring(file.lastIndexOf('/') + 1)) + " wgs84.tif");
    }

    /** Returns the system as PROJ parameters, without a datum shift. */
    String withoutShift() {
        return projection + (hasOwnSphere() ? "" : " " + ellipsoid) + meridian + " +no_defs";
    }

    /**
     * Returns the system as PROJ parameters with the most certain datum shift for a place.
     * @param latitude degrees, within 0.1 degrees; likewise longitude
     * @throws IOException for a place outside the areas of all shifts
     */
    String at(double latitude, double longitude) throws IOException {
        if (shifts.isEmpty() || hasOwnSphere()) {
            return withoutShift();
        }
        double[] best = best(latitude, longitude, false);
        best = best == null ? best(latitude, longitude, true) : best;
        if (best == null) {
            throw unsupported(file, title,
                String.format(Locale.ROOT, "at latitude %.4f, longitude %.4f one with a datum shift within 5 m; this "
                + "one's are for %s", latitude, longitude, areas()));
        }
        StringBuilder text = new StringBuilder(projection).append(' ').append(ellipsoid).append(" +towgs84=");
        for (int i = X; i < best.length; i++) {
            text.append(best[i]).append(i < best.length - 1 ? "," : "");
        }
        return text.append(meridian).append(" +no_defs").toString();
    }

    /** @param anywhere whether shifts of a modern datum count outside their areas */
    private double[] best(double latitude, double longitude, boolean anywhere) {
        double[] best = null;
        for (double[] shift : shifts) {
            boolean counts = anywhere ? isSmall(shift) : contains(shift, latitude, longitude);
            best = counts && (best == null || (anywhere ? area(shift) > area(best) : isBetter(shift, best)))
                ? shift : best;
        }
        return best;
    }

    /** Returns whether a shift is below about three metres everywhere, which is so between modern datums. */
    private static boolean isSmall(double[] shift) {
        for (int i = X; i < shift.length; i++) {
            if (Math.abs(shift[i]) > (i < X + 3 ? 2 : 0.1)) {
                return false;
            }
        }
        return true;
    }

    private boolean hasOwnSphere() {
        return projection.contains(" +a=") || projection.contains(" +R=");
    }

    private static boolean contains(double[] shift, double latitude, double longitude) {
        double east = longitude - 360 * Math.floor((longitude - shift[0]) / 360);
        double width = shift[2] >= shift[0] ? shift[2] : shift[2] + 360;
        return latitude >= shift[1] && latitude <= shift[3] && east <= width;
    }

    /** Returns whether a shift is less uncertain, or as uncertain for a smaller area. */
    private static boolean isBetter(double[] shift, double[] than) {
        return shift[4] < than[4] - SAME || shift[4] < than[4] + SAME && area(shift) < area(than);
    }

    private static double area(double[] shift) {
        double width = shift[2] - shift[0];
        return (width < 0 ? width + 360 : width) * (
            Math.sin(Math.toRadians(shift[3])) - Math.sin(Math.toRadians(shift[1])));
    }

    private String areas() {
        List<String> boxes = new ArrayList<>();
        for (double[] shift : shifts.subList(0, Math.min(AREAS, shifts.size()))) {
            boxes.add(String.format(Locale.ROOT, "latitudes %.1f to %.1f and longitudes %.1f to %.1f", shift[1],
                shift[3], shift[0], shift[2]));
        }
        if (shifts.size() > AREAS) {
            boxes.add(shifts.size() - AREAS + " others");
        }
        return String.join("; ", boxes);
    }
}
