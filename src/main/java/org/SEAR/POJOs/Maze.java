// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.ScriptText;
import org.SEAR.grammar.TextRule;

/**
 * Walls from a drawing by characters, EyeSim's maze format. In a line, the 1st, 3rd, 5th.. character may be {@code |},
 * a wall between two cells; the 2nd, 4th.. may be {@code _}, a wall below its cell. A letter is a robot's start: S or U
 * faces up, D, L, R down, left, right; o is a ball. Capitals have a wall below them. The upper edge is north (+x), the
 * right edge east (+z), the middle the object's origin.
 */
@Described("walls drawn by | and _ in lines of text, EyeSim's maze format; its upper edge is north, its middle the "
    + "origin")
public class Maze extends Walls {
    private static final double CELL = 0.36;
    private static final double HEIGHT = 0.3;
    private static final double THICKNESS = 0.012;
    private static final int MAX_LINES = 101;
    private static final double MILLIMETRES = 1000;
    private static final String STARTS = "SUDLR";
    /** Rotation about y of a robot that faces +z without one, for each of {@link #STARTS}. */
    private static final double[] HEADINGS = {90, 90, -90, 180, 0};
    private static final String INITIAL = " _ _ _\n|_  | |\n| | |_|\n|_|r__|";
    private static final String LEGAL = " _|oSUDLRsudlr";

    @Param(doc = "line of the drawing, from above", element = "line", text = TextRule.DRAWING, required = true,
        initial = INITIAL, maxEntries = MAX_LINES)
    private List<String> lines = new ArrayList<>();
    @Param(doc = "side of a cell", unit = "m", min = 0.01, max = 1000)
    private double cell = CELL;
    @Param(doc = "thickness of the walls", unit = "m", min = 0.001, max = 100)
    private double thickness = THICKNESS;

    /** For reading from a file. */
    protected Maze() {
        super(HEIGHT);
    }

    /**
     * Cells of 0.36 m, or of the number of millimetres in the last line.
     *
     * @param text the drawing, lines separated by line feeds
     */
    public Maze(String name, String text) {
        super(name, HEIGHT);
        lines = split(ScriptText.of(text));
        String last = lines.isEmpty() ? "" : lines.get(lines.size() - 1).trim();
        if (last.matches("[0-9]{1,7}")) {
            lines.remove(lines.size() - 1);
            cell = Integer.parseInt(last) / MILLIMETRES;
        }
        created(Maze.class);
    }

    /** @param cell side of a cell, metres */
    public Maze(String name, String text, double cell) {
        super(name, HEIGHT);
        lines = split(ScriptText.of(text));
        this.cell = cell;
        created(Maze.class);
    }

    private static List<String> split(String text) {
        List<String> all = new ArrayList<>();
        for (String line : text.split("\r?\n", -1)) {
            all.add(line.stripTrailing());
        }
        while (!all.isEmpty() && all.get(0).isEmpty()) {
            all.remove(0);
        }
        while (!all.isEmpty() && all.get(all.size() - 1).isEmpty()) {
            all.remove(all.size() - 1);
        }
        return all;
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (lines.size() < 2 || lines.size() > MAX_LINES || getColumns() < 1) {
            faults.add("line", lines.size() + " lines with " + getColumns() + " cells", "2 to " + MAX_LINES
                + " lines with at least one cell each");
        }
        for (int row = 0; row < lines.size(); row++) {
            String wrong = wrong(lines.get(row));
            if (wrong != null) {
                faults.add("line#" + row, wrong, "a | at the 1st, 3rd, 5th.. place, a _ or one of oSUDLRsudlr at the "
                    + "2nd, 4th.. place, or a blank");
            }
        }
        if (thickness >= cell) {
            faults.add("thickness", thickness, "less than the cell's " + cell + " m");
        }
    }

    /** Returns the first illegal character of a line with its place; null if there is none. */
    private static String wrong(String line) {
        for (int i = 0; i < line.length(); i++) {
            char c = line.charAt(i);
            boolean post = i % 2 == 0;
            if (LEGAL.indexOf(c) < 0 || c == '|' && !post || post && c != ' ' && c != '_' && c != '|') {
                return "'" + c + "' at place " + (i + 1);
            }
        }
        return null;
    }

    /** Returns the lines of the drawing, from above. */
    public List<String> getLines() {
        return List.copyOf(lines);
    }

    /** Returns the number of rows of cells. */
    public int getRows() {
        return lines.size() - 1;
    }

    /** Returns the number of cells in a row. */
    public int getColumns() {
        return lines.stream().mapToInt(String::length).max().orElse(0) / 2;
    }

    public double getCell() {
        return cell;
    }

    public double getThickness() {
        return thickness;
    }

    /** @param metres thickness of the walls, less than a cell */
    public void setThickness(double metres) {
        double newThickness = checked("thickness", metres);
        if (newThickness >= cell) {
            throw new IllegalArgumentException(label() + ": thickness is " + newThickness + ", legal: less than the "
                + "cell's " + cell + " m");
        }
        thickness = newThickness;
        changed();
    }

    private char at(int line, int place) {
        return line < lines.size() && place < lines.get(line).length() ? lines.get(line).charAt(place) : ' ';
    }

    /** Returns whether there is a wall above a cell; the row after the last one is the lower edge. */
    public boolean hasWallAbove(int row, int column) {
        char c = at(row, 2 * column + 1);
        return c == '_' || STARTS.indexOf(c) >= 0;
    }

    /** Returns whether there is a wall to the left of a cell; the column after the last one is the right edge. */
    public boolean hasWallLeft(int row, int column) {
        return at(row + 1, 2 * column) == '|';
    }

    /**
     * Returns the starts in the drawing, from above and from the left: north and east of the object's origin, metres,
     * and {@code ry}, degrees, for {@code robot.move(north, 0, east)} and {@code robot.rotate(0, ry, 0)} of a robot
     * that looks east without rotation.
     */
    public List<double[]> getStarts() {
        List<double[]> starts = new ArrayList<>();
        for (int row = 0; row < getRows(); row++) {
            for (int column = 0; column < getColumns(); column++) {
                int way = STARTS.indexOf(Character.toUpperCase(at(row + 1, 2 * column + 1)));
                if (way >= 0) {
                    starts.add(new double[] {(getRows() / 2.0 - row - 0.5) * cell,
                        (column + 0.5 - getColumns() / 2.0) * cell, HEADINGS[way]});
                }
            }
        }
        return starts;
    }
}
