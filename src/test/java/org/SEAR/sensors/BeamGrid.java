// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.SEAR.POJOs.Distance;
import org.SEAR.raycast.BeamScene;
import org.SEAR.raycast.solid.RayRound;

/**
 * The test of the data sheets: an upright pole stands on each point of a grid before a sensor, which reports whether it
 * sees the pole.
 */
final class BeamGrid {
    private static final double POLE_HALF_HEIGHT = 0.61;
    private static final double MARGIN = 0.25;
    private static final double SCALE = 100;

    final BeamOutline outline;
    final double cell;
    final int columns;
    final int rows;
    private final boolean[][] seen;

    /** @param cell distance between two points, metres */
    BeamGrid(BeamOutline outline, double cell) {
        this.outline = outline;
        this.cell = cell;
        Distance parameters = new Distance("sensor", outline.beam);
        DistanceSensor sensor = new DistanceSensor(parameters, 1);
        double far = Math.max(outline.end(), BeamPattern.of(parameters.getCones()).getMaxRange()) + MARGIN;
        double widest = MARGIN;
        for (double width : outline.widths) {
            widest = Math.max(widest, width + MARGIN);
        }
        this.rows = (int) Math.ceil(far / cell);
        this.columns = 2 * (int) Math.ceil(widest / cell);
        this.seen = new boolean[rows][columns];
        look(sensor);
    }

    private void look(DistanceSensor sensor) {
        ScriptedTruth truth = new ScriptedTruth();
        truth.scene = new BeamScene();
        int pole = truth.scene.addSolid(RayRound.cylinder(outline.radius, POLE_HALF_HEIGHT), BeamScene.WORLD);
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                truth.scene.setPose(pole, side(column), 0, depth(row), 0, 0, 0, 1);
                truth.scene.commit();
                truth.step++;
                seen[row][column] = sensor.read(truth).isReturn();
            }
        }
    }

    /** Returns the distance to the left, metres. */
    double side(int column) {
        return (column + 0.5 - columns / 2) * cell;
    }

    /** Returns the distance ahead, metres. */
    double depth(int row) {
        return (row + 0.5) * cell;
    }

    /** Returns intersection over union of the seen area and the outline. */
    double overlap() {
        int both = 0;
        int either = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                boolean inside = outline.contains(side(column), depth(row));
                both += inside && seen[row][column] ? 1 : 0;
                either += inside || seen[row][column] ? 1 : 0;
            }
        }
        return both / (double) either;
    }

    /** Draws detections as squares, the data sheet's outline as a line, and a scale in metres. */
    void draw(Path file) throws IOException {
        double width = columns * cell * SCALE;
        double height = rows * cell * SCALE;
        StringBuilder svg = new StringBuilder();
        add(svg, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"%.0f %.0f %.0f %.0f\" width=\"%.0f\""
            + " font-family=\"sans-serif\" font-size=\"11\">",
            -width / 2 - 45, -height - 15, width + 60, height + 60, width + 60);
        add(svg, "<rect x=\"%.0f\" y=\"%.0f\" width=\"%.0f\" height=\"%.0f\" fill=\"white\"/>",
            -width / 2 - 45, -height - 15, width + 60, height + 60);
        scale(svg, width, height);
        for (int row = 0; row < rows; row++) {
            runs(svg, row);
        }
        line(svg);
        add(svg, "<text x=\"0\" y=\"%.0f\" text-anchor=\"middle\">%s, pole of %.1f mm, overlap %.1f %%</text>", 29.0,
            outline.beam, 2000 * outline.radius, 100 * overlap());
        add(svg, "<text x=\"0\" y=\"%.0f\" text-anchor=\"middle\">blue: seen, red: data sheet</text>", 42.0);
        svg.append("</svg>\n");
        Files.createDirectories(file.getParent());
        Files.write(file, svg.toString().getBytes(StandardCharsets.UTF_8));
    }

    private static void add(StringBuilder svg, String format, Object... values) {
        svg.append(String.format(Locale.ROOT, format, values)).append('\n');
    }

    private static void scale(StringBuilder svg, double width, double height) {
        for (double metres = 0; metres * SCALE < height; metres += 0.5) {
            add(svg, "<path d=\"M%.0f %.0fH%.0f\" stroke=\"#ddd\"/><text x=\"%.0f\" y=\"%.0f\" "
                + "text-anchor=\"end\">%.1f m</text>", -width / 2,
                -metres * SCALE, width / 2, -width / 2 - 4, -metres * SCALE + 4, metres);
        }
        for (double metres = 0; metres * SCALE < width / 2; metres += 0.5) {
            for (double side : metres == 0 ? new double[] {0} : new double[] {-metres, metres}) {
                add(svg, "<path d=\"M%.0f 0V%.0f\" stroke=\"#ddd\"/><text x=\"%.0f\" y=\"16\" "
                    + "text-anchor=\"middle\">%.1f</text>", side * SCALE, -height, side * SCALE, Math.abs(side));
            }
        }
    }

    private void runs(StringBuilder svg, int row) {
        for (int column = 0; column < columns; column++) {
            int end = column;
            while (end < columns && seen[row][end]) {
                end++;
            }
            if (end > column) {
                add(svg, "<rect x=\"%.1f\" y=\"%.1f\" width=\"%.1f\" height=\"%.1f\" fill=\"#6fa8dc\"/>",
                    (side(column) - cell / 2) * SCALE,
                    -(depth(row) + cell / 2) * SCALE, (end - column) * cell * SCALE, cell * SCALE);
                column = end;
            }
        }
    }

    private void line(StringBuilder svg) {
        StringBuilder path = new StringBuilder("M0 0");
        for (int i = 1; i < outline.depths.length; i++) {
            path.append(String.format(Locale.ROOT, "L%.1f %.1f", outline.widths[i] * SCALE,
                -outline.depths[i] * SCALE));
        }
        for (int i = outline.depths.length - 1; i > 0; i--) {
            path.append(String.format(Locale.ROOT, "L%.1f %.1f", -outline.widths[i] * SCALE,
                -outline.depths[i] * SCALE));
        }
        add(svg, "<path d=\"%sZ\" fill=\"none\" stroke=\"#cc0000\" stroke-width=\"2\"/>", path);
    }
}
