// SPDX-License-Identifier: Apache-2.0
package org.SEAR.plot;

import java.util.List;

/** Layout of a plot, in points. One thread. */
final class PlotDrawing implements Drawing {
    static final int WIDTH = 900;
    /** Font size. */
    static final int SIZE = 14;
    private static final int BOX = 260;
    private static final int LEFT = 105;
    private static final int RIGHT = 30;
    /** Height above a box for the names of its lines. */
    private static final int LEGEND = 40;
    private static final int BOTTOM = 60;
    private static final int MARK = 5;
    private static final int SAMPLE = 24;
    /** Approximate width of a letter, as a fraction of its height. */
    private static final double LETTER = 0.62;
    private static final String FRAME = "#444444";
    private static final String GRID = "#dddddd";
    /** Colour-blind safe palette of Okabe and Ito. */
    private static final String[] COLORS = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00",
        "#000000", "#8c6d31"};
    private static final double THICK = 2;

    private final String xTitle;
    private final double[] places;
    private final Axis along;
    private final List<List<Line>> boxes;

    PlotDrawing(String xTitle, double[] places, Axis along, List<List<Line>> boxes) {
        this.xTitle = xTitle;
        this.places = places;
        this.along = along;
        this.boxes = boxes;
    }

    @Override
    public int width() {
        return WIDTH;
    }

    @Override
    public int height() {
        return boxes.size() * (LEGEND + BOX) + BOTTOM;
    }

    @Override
    public void on(Canvas canvas) {
        int colour = 0;
        for (int i = 0; i < boxes.size(); i++) {
            double top = LEGEND + i * (double) (LEGEND + BOX);
            box(canvas, boxes.get(i), top, colour, i == boxes.size() - 1);
            colour += boxes.get(i).size();
        }
        canvas.text(xTitle, (LEFT + WIDTH - RIGHT) / 2.0, height() - SIZE, Canvas.Anchor.MIDDLE, SIZE);
    }

    private void box(Canvas canvas, List<Line> lines, double top, int firstColor, boolean isLast) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (Line line : lines) {
            for (double value : line.values) {
                least = Double.isFinite(value) ? Math.min(least, value) : least;
                most = Double.isFinite(value) ? Math.max(most, value) : most;
            }
        }
        Axis up = least > most ? new Axis(0, 1, true) : new Axis(least, most, true);
        axes(canvas, up, top, isLast);
        canvas.upwards(title(lines), SIZE + MARK, top + BOX / 2.0, SIZE);
        double x = LEFT;
        for (int i = 0; i < lines.size(); i++) {
            String color = COLORS[(firstColor + i) % COLORS.length];
            canvas.line(x, top - SIZE, x + SAMPLE, top - SIZE, color, THICK);
            canvas.text(lines.get(i).name, x + SAMPLE + MARK, top - SIZE + MARK, Canvas.Anchor.LEFT, SIZE);
            x += SAMPLE + 4 * MARK + lines.get(i).name.length() * SIZE * LETTER;
            draw(canvas, lines.get(i), up, top, color);
        }
    }

    /** Returns a single line's name with unit; for several lines only the unit. */
    private static String title(List<Line> lines) {
        String unit = lines.get(0).unit;
        String name = lines.size() == 1 ? lines.get(0).name : "";
        return unit.isEmpty() ? name : name.isEmpty() ? unit : name + " (" + unit + ")";
    }

    private void axes(Canvas canvas, Axis up, double top, boolean isLast) {
        double bottom = top + BOX;
        for (double mark : up.marks()) {
            double y = bottom - up.share(mark) * BOX;
            canvas.line(LEFT, y, WIDTH - RIGHT, y, GRID, 1);
            canvas.text(up.label(mark), LEFT - 2 * MARK, y + MARK, Canvas.Anchor.RIGHT, SIZE);
        }
        for (double mark : along.marks()) {
            double x = LEFT + along.share(mark) * (WIDTH - RIGHT - LEFT);
            canvas.line(x, top, x, bottom + MARK, GRID, 1);
            if (isLast) {
                canvas.text(along.label(mark), x, bottom + MARK + SIZE, Canvas.Anchor.MIDDLE, SIZE);
            }
        }
        canvas.line(LEFT, top, LEFT, bottom, FRAME, 1);
        canvas.line(LEFT, bottom, WIDTH - RIGHT, bottom, FRAME, 1);
    }

    /** Draws a line and leaves its gaps open. */
    private void draw(Canvas canvas, Line line, Axis up, double top, String color) {
        double[] x = new double[places.length];
        double[] y = new double[places.length];
        int count = 0;
        for (int i = 0; i <= places.length; i++) {
            if (i < places.length && Double.isFinite(places[i]) && Double.isFinite(line.values[i])) {
                x[count] = LEFT + along.share(places[i]) * (WIDTH - RIGHT - LEFT);
                y[count] = top + BOX - up.share(line.values[i]) * BOX;
                count++;
            } else if (count > 0) {
                if (count == 1) {
                    canvas.line(x[0] - THICK, y[0], x[0] + THICK, y[0], color, 2 * THICK);
                } else {
                    canvas.polyline(x, y, count, color, THICK);
                }
                count = 0;
            }
        }
    }
}
