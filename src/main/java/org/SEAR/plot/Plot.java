package org.SEAR.plot;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Lines over one axis. Those of one unit share a box with an axis of its own; the boxes stand one below the other. One thread.
 */
public final class Plot {
    /** Lines that a plot has at most. */
    public static final int MAX_LINES = 16;

    private final String xTitle;
    private final double[] places;
    private final Map<String, List<Line>> boxes = new LinkedHashMap<>();
    private int count;

    /**
     * One without lines.
     *
     * @param xTitle what stands below the axis, with its unit
     * @param places where on the axis the values of its lines are
     */
    public Plot(String xTitle, double[] places) {
        this.xTitle = xTitle;
        this.places = places.clone();
    }

    /**
     * Adds a line.
     *
     * @param unit of its values; empty for none
     * @param values not a number where there is none
     * @throws IllegalArgumentException if it has more or fewer values than the axis, or there are too many lines
     */
    public void add(String name, String unit, double[] values) {
        if (values.length != places.length) {
            throw new IllegalArgumentException("\"" + name + "\" has " + values.length + " values, and \"" + xTitle + "\" has " + places.length
                + ", legal: as many");
        }
        if (++count > MAX_LINES) {
            throw new IllegalArgumentException("more than " + MAX_LINES + " lines, legal: up to " + MAX_LINES);
        }
        boxes.computeIfAbsent(unit, none -> new ArrayList<>()).add(new Line(name, unit, values.clone()));
    }

    /**
     * Draws it into a file.
     *
     * @param file of the ending .png or .svg; one of that name is replaced
     * @throws IllegalArgumentException for another ending, or if there is nothing to draw
     * @throws IOException if it can't be written
     */
    public void save(Path file) throws IOException {
        DrawingFiles.check(file);
        double[] shown = Arrays.stream(places).filter(Double::isFinite).sorted().toArray();
        boolean hasValues = boxes.values().stream().flatMap(List::stream).anyMatch(line -> Arrays.stream(line.values).anyMatch(Double::isFinite));
        if (shown.length == 0 || !hasValues) {
            throw new IllegalArgumentException("there is nothing to draw: no number over \"" + xTitle + "\"; lists are filled in a loop, as with"
                + " times.append(sear.getTime())");
        }
        DrawingFiles.save(new PlotDrawing(xTitle, places, new Axis(shown[0], shown[shown.length - 1], false), new ArrayList<>(boxes.values())), file);
    }
}
