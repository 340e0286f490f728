// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The main magnetic field of the Earth by a spherical-harmonic model such as the World Magnetic Model: B = -grad V, V =
 * a sum (a/r)^(n+1) (g cos m*lon + h sin m*lon) P(n, m), with Schmidt semi-normalised P and a = 6371.2 km. The
 * coefficients change linearly with time. Geodetic positions are WGS84. Source: Chulliat et al., "The US/UK World
 * Magnetic Model", sections 1.2 and 1.3. Immutable; any thread.
 */
public final class MagneticModel {
    /** Validity of a model of the series, years. */
    public static final double YEARS_VALID = 5;

    private static final String STANDARD = "WMM2025.COF";
    private static final double SEMI_MAJOR = 6378.137;
    private static final double FLATTENING = 1 / 298.257223563;
    private static final double REFERENCE_RADIUS = 6371.2;
    private static final int MAX_DEGREE = 133;
    private static final double POLE = 1e-10;

    private final double epoch;
    private final String name;
    private final int degree;
    private final double[] g;
    private final double[] h;
    private final double[] gRate;
    private final double[] hRate;

    private MagneticModel(double epoch, String name, List<double[]> rows) {
        this.epoch = epoch;
        this.name = name;
        this.degree = (int) rows.stream().mapToDouble(row -> row[0]).max().orElse(0);
        int size = index(degree, degree) + 1;
        this.g = new double[size];
        this.h = new double[size];
        this.gRate = new double[size];
        this.hRate = new double[size];
        for (double[] row : rows) {
            int at = index((int) row[0], (int) row[1]);
            g[at] = row[2];
            h[at] = row[3];
            gRate[at] = row[4];
            hRate[at] = row[5];
        }
    }

    /**
     * Returns SEAR's copy of the World Magnetic Model 2025 of NOAA and the British Geological Survey (public domain).
     */
    public static MagneticModel standard() {
        return Standard.MODEL;
    }

    private static final class Standard {
        static final MagneticModel MODEL = load();

        private static MagneticModel load() {
            try (InputStream in = MagneticModel.class.getResourceAsStream(STANDARD)) {
                return parse(new BufferedReader(new InputStreamReader(in, StandardCharsets.US_ASCII)));
            } catch (IOException e) {
                throw new IllegalStateException(STANDARD + " in sear.jar can't be read", e);
            }
        }
    }

    /**
     * Reads a file in NOAA's COF format.
     *
     * @throws FormatException with the line and the error
     */
    public static MagneticModel read(Path file) throws FormatException {
        try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.ISO_8859_1)) {
            return parse(in);
        } catch (FormatException e) {
            throw e;
        } catch (IOException e) {
            throw new FormatException(0, "can't be read: " + e.getMessage(), "a readable file in NOAA's COF form");
        }
    }

    private static MagneticModel parse(BufferedReader in) throws IOException {
        String[] head = words(in.readLine());
        String legal = "a first line of epoch and model name such as \"2025.0 WMM-2025 11/13/2024\"";
        if (head.length < 2) {
            throw new FormatException(1, "first line is incomplete", legal);
        }
        double epoch = number(head[0], 1, legal);
        List<double[]> rows = new ArrayList<>();
        int line = 1;
        for (String text = in.readLine(); text != null; text = in.readLine()) {
            line++;
            String[] words = words(text);
            if (words.length > 0 && words[0].startsWith("9999")) {
                break;
            }
            if (words.length > 0) {
                rows.add(row(words, line));
            }
        }
        if (rows.isEmpty()) {
            throw new FormatException(line, "no coefficients", "lines of n, m, g, h and their rates a year");
        }
        return new MagneticModel(epoch, head[1], rows);
    }

    private static double[] row(String[] words, int line) throws FormatException {
        String legal = "n, m, g, h, dg/dt, dh/dt with n from 1 to " + MAX_DEGREE + " and m from 0 to n";
        if (words.length < 6) {
            throw new FormatException(line, words.length + " numbers", legal);
        }
        double[] row = new double[6];
        for (int i = 0; i < row.length; i++) {
            row[i] = number(words[i], line, legal);
        }
        boolean whole = row[0] == Math.rint(row[0]) && row[1] == Math.rint(row[1]);
        if (!whole || row[0] < 1 || row[0] > MAX_DEGREE || row[1] < 0 || row[1] > row[0]) {
            throw new FormatException(line, "n, m is " + words[0] + ", " + words[1], legal);
        }
        return row;
    }

    private static double number(String word, int line, String legal) throws FormatException {
        try {
            double value = Double.parseDouble(word);
            if (Double.isFinite(value)) {
                return value;
            }
            throw new FormatException(line, "\"" + word + "\" is not finite", legal);
        } catch (NumberFormatException e) {
            throw new FormatException(line, "\"" + word + "\" is no number", legal);
        }
    }

    private static String[] words(String line) {
        return line == null || line.isBlank() ? new String[0] : line.trim().split("\\s+");
    }

    private static int index(int n, int m) {
        return n * (n + 1) / 2 + m;
    }

    /** Returns the year of the coefficients. */
    public double getEpoch() {
        return epoch;
    }

    /** Returns the name in the file, for example WMM-2025. */
    public String getName() {
        return name;
    }

    /**
     * Returns whether the model is valid in a year.
     *
     * @param decimalYear for example 2026.5
     */
    public boolean covers(double decimalYear) {
        return decimalYear >= epoch && decimalYear <= epoch + YEARS_VALID;
    }

    /**
     * Returns the field at a position.
     *
     * @param latitude geodetic, degrees, + north
     * @param longitude degrees, + east
     * @param height kilometres above the WGS84 ellipsoid
     * @param decimalYear for example 2026.5
     */
    public Field field(double latitude, double longitude, double height, double decimalYear) {
        double phi = Math.toRadians(latitude);
        double square = FLATTENING * (2 - FLATTENING);
        double sin = Math.sin(phi);
        double normal = SEMI_MAJOR / Math.sqrt(1 - square * sin * sin);
        double axial = (normal * (1 - square) + height) * sin;
        double equatorial = (normal + height) * Math.cos(phi);
        double radius = Math.hypot(axial, equatorial);
        double[] b = geocentric(Math.atan2(axial, equatorial), Math.toRadians(longitude), radius, decimalYear - epoch);
        double tilt = phi - Math.atan2(axial, equatorial);
        return new Field(b[0] * Math.cos(tilt) + b[2] * Math.sin(tilt), b[1], b[2] * Math.cos(tilt)
            - b[0] * Math.sin(tilt));
    }

    /** Returns {north, east, down} in the geocentric frame, nT. */
    private double[] geocentric(double latitude, double longitude, double radius, double years) {
        double sin = Math.sin(latitude);
        double cos = Math.max(Math.cos(latitude), POLE);
        double[] p = new double[g.length];
        double[] slope = new double[g.length];
        legendre(sin, cos, p, slope);
        double north = 0;
        double east = 0;
        double down = 0;
        double ratio = REFERENCE_RADIUS / radius;
        double power = ratio * ratio;
        for (int n = 1; n <= degree; n++) {
            power *= ratio;
            for (int m = 0; m <= n; m++) {
                int at = index(n, m);
                double gNow = g[at] + years * gRate[at];
                double hNow = h[at] + years * hRate[at];
                double cosLongitude = Math.cos(m * longitude);
                double sinLongitude = Math.sin(m * longitude);
                double along = gNow * cosLongitude + hNow * sinLongitude;
                north -= power * along * slope[at];
                east += power * m * (gNow * sinLongitude - hNow * cosLongitude) * p[at] / cos;
                down -= power * (n + 1) * along * p[at];
            }
        }
        return new double[] {north, east, down};
    }

    /**
     * Computes the Schmidt semi-normalised P(n, m) of sin(latitude) and their derivatives by latitude, both by
     * recursion over n.
     */
    private void legendre(double sin, double cos, double[] p, double[] slope) {
        p[0] = 1;
        for (int m = 0; m <= degree; m++) {
            int top = index(m, m);
            if (m > 0) {
                double factor = m == 1 ? 1 : Math.sqrt((2.0 * m - 1) / (2.0 * m));
                int before = index(m - 1, m - 1);
                p[top] = factor * cos * p[before];
                slope[top] = factor * (cos * slope[before] - sin * p[before]);
            }
            for (int n = m + 1; n <= degree; n++) {
                double scale = Math.sqrt((double) n * n - (double) m * m);
                double first = (2.0 * n - 1) / scale;
                int one = index(n - 1, m);
                int at = index(n, m);
                p[at] = first * sin * p[one];
                slope[at] = first * (sin * slope[one] + cos * p[one]);
                if (n > m + 1) {
                    double second = Math.sqrt((n - 1.0) * (n - 1.0) - (double) m * m) / scale;
                    int two = index(n - 2, m);
                    p[at] -= second * p[two];
                    slope[at] -= second * slope[two];
                }
            }
        }
    }

    /** A magnetic field vector at a position. Immutable. */
    public static final class Field {
        /** Towards geodetic north, nT. */
        public final double north;
        /** Towards east, nT. */
        public final double east;
        /** Downwards, nT. */
        public final double down;

        Field(double north, double east, double down) {
            this.north = north;
            this.east = east;
            this.down = down;
        }

        /** Returns the angle from true to magnetic north, degrees, + east. */
        public double declination() {
            return Math.toDegrees(Math.atan2(east, north));
        }

        /** Returns the angle below the horizontal, degrees. */
        public double inclination() {
            return Math.toDegrees(Math.atan2(down, horizontal()));
        }

        /** Returns the horizontal field strength, nT. */
        public double horizontal() {
            return Math.hypot(north, east);
        }

        /** Returns the field strength, nT. */
        public double total() {
            return Math.hypot(horizontal(), down);
        }
    }

    /** A coefficient file that cannot be used. */
    public static final class FormatException extends IOException {
        private static final long serialVersionUID = 1L;
        private final int line;
        private final String legal;

        FormatException(int line, String message, String legal) {
            super(message);
            this.line = line;
            this.legal = legal;
        }

        /** Returns the line, from 1; 0 if unknown. */
        public int getLine() {
            return line;
        }

        /** Returns the legal contents. */
        public String getLegal() {
            return legal;
        }
    }
}
