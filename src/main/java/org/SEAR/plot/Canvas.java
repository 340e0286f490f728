package org.SEAR.plot;

/** What a plot is drawn on: points from the upper left corner, y downwards; colours as #rrggbb. One thread. */
public interface Canvas {
    /** Where a text stands to its point. */
    enum Anchor { LEFT, MIDDLE, RIGHT }

    /** A straight line. */
    void line(double x1, double y1, double x2, double y2, String color, double width);

    /** A line through points, of which it has as many as it has numbers. */
    void polyline(double[] x, double[] y, int count, String color, double width);

    /**
     * An area with corners, of which it has as many as it has numbers.
     *
     * @param opacity of the area: 0 to 1; its edge is opaque
     * @param edge colour of its outline, one point wide
     */
    void area(double[] x, double[] y, String color, double opacity, String edge);

    /** Its base line is at y. */
    void text(String text, double x, double y, Anchor anchor, int size);

    /** The same with a white rim, to be read on any ground. */
    void label(String text, double x, double y, Anchor anchor, int size);

    /** A text that runs upwards, its middle at the point. */
    void upwards(String text, double x, double y, int size);
}
