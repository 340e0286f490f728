// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Lines over one common axis. Lines of one unit share a box with its own vertical axis; the boxes are stacked. One
 * thread.
 */
public final class Plot {
    /** Maximum number of lines of a plot. */
    public static final int MAX_LINES = 16;

    private final String xTitle;
    private final double[] places;
    private final Map<String, List<Line>> boxes = new LinkedHashMap<>();
    private int count;

    /**
     * Creates a plot without lines.
     *
     * @param xTitle title below the axis, with its unit
     * @param places positions of the lines' values on the axis
     */
    public Plot(String xTitle, double[] places) {
        this.xTitle = xTitle;
        this.places = places.clone();
    }

    /**
     * Adds a line.
     *
     * @param unit of its values; empty for none
     * @param values NaN where there is none
     * @throws IllegalArgumentException if the count of values differs from the axis, or there are too many lines
     */
    public void add(String name, String unit, double[] values) {
        if (values.length != places.length) {
            throw new IllegalArgumentException("\"" + name + "\" has " + values.length + " values, and \"" + xTitle
                + "\" has " + places.length + ", legal: the same number");
        }
        if (++count > MAX_LINES) {
            throw new IllegalArgumentException("more than " + MAX_LINES + " lines, legal: up to " + MAX_LINES);
        }
        boxes.computeIfAbsent(unit, none -> new ArrayList<>()).add(new Line(name, unit, values.clone()));
    }

    /**
     * Draws the plot to a file.
     *
     * @param file ends in .png or .svg; replaced if it exists
     * @throws IllegalArgumentException for another ending, or if there is nothing to draw
     * @throws IOException if it cannot be written
     */
    public void save(Path file) throws IOException {
        DrawingFiles.check(file);
        double[] shown = Arrays.stream(places).filter(Double::isFinite).sorted().toArray();
        boolean hasValues = boxes.values().stream().flatMap(List::stream)
            .anyMatch(line -> Arrays.stream(line.values).anyMatch(Double::isFinite));
        if (shown.length == 0 || !hasValues) {
            throw new IllegalArgumentException("there is nothing to draw: no numbers over \"" + xTitle
                + "\"; fill the lists in a loop, for example with times.append(sear.getTime())");
        }
        DrawingFiles.save(new PlotDrawing(xTitle, places, new Axis(shown[0], shown[shown.length - 1], false),
            new ArrayList<>(boxes.values())), file);
    }
}
