// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

/** Drawing surface: points from the upper left corner, y down; colours as #rrggbb. One thread. */
public interface Canvas {
    /** Position of a text relative to its point. */
    enum Anchor { LEFT, MIDDLE, RIGHT }

    /** Draws a straight line. */
    void line(double x1, double y1, double x2, double y2, String color, double width);

    /** Draws a line through the first {@code count} points. */
    void polyline(double[] x, double[] y, int count, String color, double width);

    /**
     * Draws a polygon.
     *
     * @param opacity of the area, 0 to 1; its edge is opaque
     * @param edge colour of its outline, one point wide
     */
    void area(double[] x, double[] y, String color, double opacity, String edge);

    /** Draws a text with its baseline at y. */
    void text(String text, double x, double y, Anchor anchor, int size);

    /** Draws a text with a white rim, legible on any background. */
    void label(String text, double x, double y, Anchor anchor, int size);

    /** Draws a text that runs upwards, centred at the point. */
    void upwards(String text, double x, double y, int size);
}
