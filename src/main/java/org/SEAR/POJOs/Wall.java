// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;

/** A wall along a line from corner to corner; its ends are square. Corners are relative to the object's origin. */
@Described("a wall along a line from corner to corner")
public class Wall extends Walls {
    private static final double HEIGHT = 1;
    private static final double THICKNESS = 0.1;
    private static final int MAX_CORNERS = 1000;
    private static final double SHORTEST = 0.0001;
    private static final String LEGAL = "2 to " + MAX_CORNERS + " corners";

    @Param(doc = "corner of the line; default: a wall of 1 m eastwards", element = "corner", maxEntries = MAX_CORNERS)
    private List<WallCorner> corners = new ArrayList<>(List.of(new WallCorner(0, 0), new WallCorner(0, 1)));
    @Param(doc = "thickness of the wall", unit = "m", min = 0.001, max = 100)
    private double thickness = THICKNESS;

    /** For reading from a file. */
    protected Wall() {
        super(HEIGHT);
    }

    /**
     * A wall 1 m high and 0.1 m thick.
     *
     * @param corners each a {@link WallCorner}, or (x, z) in metres
     */
    public Wall(String name, List<?> corners) {
        this(name, corners, THICKNESS, HEIGHT);
    }

    /**
     * @param thickness metres
     * @param height metres
     */
    public Wall(String name, List<?> corners, double thickness, double height) {
        super(name, height);
        this.corners = listed(corners);
        this.thickness = thickness;
        created(Wall.class);
    }

    private List<WallCorner> listed(List<?> entries) {
        if (entries == null) {
            throw new IllegalArgumentException(label() + ": corner is missing, legal: " + LEGAL);
        }
        try {
            return entries.stream().map(WallCorner::of).collect(Collectors.toList());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(label() + ": " + e.getMessage(), e);
        }
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        check(corners, faults);
    }

    private static void check(List<WallCorner> corners, Faults faults) {
        if (corners.size() < 2 || corners.size() > MAX_CORNERS) {
            faults.add("corner", corners.size() + " corners", LEGAL);
        }
        for (int i = 1; i < corners.size(); i++) {
            WallCorner one = corners.get(i - 1);
            WallCorner next = corners.get(i);
            if (!(Math.hypot(next.getX() - one.getX(), next.getZ() - one.getZ()) >= SHORTEST)) {
                faults.add("corner#" + i, next.getX() + ", " + next.getZ(), "at least " + SHORTEST
                    + " m from the corner before it");
            }
        }
    }

    @Override
    protected void addDrawingProperties(Map<String, Object> properties) {
        super.addDrawingProperties(properties);
        properties.put("line", corners.stream().map(corner -> new double[] {corner.getX() * getScaleX(),
            corner.getZ() * getScaleZ()}).toArray(double[][]::new));
    }

    public List<WallCorner> getCorners() {
        return List.copyOf(corners);
    }

    /** @param newCorners as in the constructor */
    public void setCorners(List<?> newCorners) {
        List<WallCorner> wanted = listed(newCorners);
        check(wanted, (element, value, legal) -> {
            throw new IllegalArgumentException(label() + ": " + element + " is " + value + ", legal: " + legal);
        });
        corners = wanted;
        changed();
    }

    public double getThickness() {
        return thickness;
    }

    /** @param metres thickness of the wall */
    public void setThickness(double metres) {
        thickness = checked("thickness", metres);
        changed();
    }
}
