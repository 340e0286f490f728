// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;

/** Region of a data sheet in which a sensor sees an upright pole: half width by depth, metres. */
final class BeamOutline {
    private static final double FOOT = 0.3048;
    private static final double INCH = 0.0254;

    final String beam;
    /** Radius of the pole. */
    final double radius;
    /** Depths with a measured width, from the sensor's face to the outline's end. */
    final double[] depths;
    final double[] widths;

    private BeamOutline(String line) {
        String[] fields = line.split("\\|");
        String[] points = fields[3].trim().split(" ");
        this.beam = fields[0].trim();
        this.radius = Double.parseDouble(fields[1].trim()) * INCH;
        this.depths = new double[points.length + 2];
        this.widths = new double[depths.length];
        for (int i = 0; i < points.length; i++) {
            String[] point = points[i].split(":");
            depths[i + 1] = Double.parseDouble(point[0]) * FOOT;
            widths[i + 1] = depths[i + 1] * Math.tan(Math.toRadians(Double.parseDouble(point[1])));
        }
        depths[points.length + 1] = Double.parseDouble(fields[2].trim()) * FOOT;
    }

    static List<BeamOutline> all() throws IOException {
        try (BufferedReader in = new BufferedReader(
            new InputStreamReader(BeamOutline.class.getResourceAsStream("beam-outlines.txt"),
                StandardCharsets.US_ASCII))) {
            return in.lines().filter(line -> !line.startsWith("#")).map(BeamOutline::new).collect(Collectors.toList());
        }
    }

    double end() {
        return depths[depths.length - 1];
    }

    /** Returns the half width at a depth, 0 beyond the end. */
    double width(double depth) {
        for (int i = 1; i < depths.length; i++) {
            if (depth <= depths[i]) {
                double share = (depth - depths[i - 1]) / (depths[i] - depths[i - 1]);
                return widths[i - 1] + share * (widths[i] - widths[i - 1]);
            }
        }
        return 0;
    }

    boolean contains(double side, double depth) {
        return Math.abs(side) <= width(depth);
    }
}
