package org.SEAR.plot;

import java.io.IOException;
import java.nio.file.Path;

/** What a plot is drawn on: points from the upper left corner, y downwards; colours as #rrggbb. One thread. */
interface Canvas {
    /** Where a text stands to its point. */
    enum Anchor { LEFT, MIDDLE, RIGHT }

    void line(double x1, double y1, double x2, double y2, String color, double width);

    /** A line through points, of which it has as many as it has numbers. */
    void polyline(double[] x, double[] y, int count, String color, double width);

    /** Its base line is at y. */
    void text(String text, double x, double y, Anchor anchor, int size);

    /** A text that runs upwards, its middle at the point. */
    void upwards(String text, double x, double y, int size);

    /** Writes the file, as a whole or not at all. */
    void save(Path file) throws IOException;
}
