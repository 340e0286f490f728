// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;

/**
 * An ArUco or AprilTag marker, by whose corners a camera program finds its position. The size is that of the black
 * square; around it is a white margin of one cell's width.
 */
@Described("a vertical plate with an ArUco or AprilTag marker, its front towards -z; its origin is the middle "
    + "of the marker")
public class Marker extends Board {
    private static final String APRILTAG = "APRILTAG_36h11";
    private static final int APRILTAGS = 587;
    private static final int APRILTAG_CELLS = 6;
    /** Cells of the black border on two opposite sides; the white margin adds as many. */
    private static final int EDGES = 2;

    @Param(doc = "OpenCV's name of the dictionary", values = {"DICT_4X4_50", "DICT_4X4_100", "DICT_4X4_250",
        "DICT_4X4_1000", "DICT_5X5_50", "DICT_5X5_100", "DICT_5X5_250", "DICT_5X5_1000", "DICT_6X6_50", "DICT_6X6_100",
        "DICT_6X6_250", "DICT_6X6_1000", "DICT_7X7_50", "DICT_7X7_100", "DICT_7X7_250", "DICT_7X7_1000", APRILTAG})
    private String dictionary = "DICT_4X4_50";
    @Param(doc = "number in the dictionary", max = 999)
    private int id;
    @Param(doc = "side of the black square", unit = "m", min = SMALL, max = 100, required = true, initial = "0.15")
    private double size;

    /** For reading from a file. */
    protected Marker() {
    }

    /**
     * Fixed in place.
     *
     * @param dictionary OpenCV's name: DICT_4X4_50 ... DICT_7X7_1000, or APRILTAG_36h11
     * @param id number of the marker in the dictionary, from 0
     * @param size side of the black square, metres
     */
    public Marker(String name, String dictionary, int id, double size) {
        this(name, dictionary, id, size, 0, 0, 0, 0, 0, 0);
    }

    /** With its middle at (x, y, z), metres. */
    public Marker(String name, String dictionary, int id, double size, double x, double y, double z) {
        this(name, dictionary, id, size, x, y, z, 0, 0, 0);
    }

    /** With its middle at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Marker(String name, String dictionary, int id, double size, double x, double y, double z, double rx,
        double ry, double rz) {
        super(name, 0);
        this.dictionary = dictionary;
        this.id = id;
        this.size = size;
        pose(x, y, z, rx, ry, rz);
        created(Marker.class);
    }

    public String getDictionary() {
        return dictionary;
    }

    public int getId() {
        return id;
    }

    public double getSize() {
        return size;
    }

    /** Returns the cells of a row, without the black border. */
    private int cells() {
        return dictionary.equals(APRILTAG) ? APRILTAG_CELLS : dictionary.charAt("DICT_".length()) - '0';
    }

    private int count() {
        return dictionary.equals(APRILTAG) ? APRILTAGS
            : Integer.parseInt(dictionary.substring(dictionary.lastIndexOf('_') + 1));
    }

    @Override
    public double getBoardWidth() {
        return size * (cells() + 2 * EDGES) / (cells() + EDGES);
    }

    @Override
    public double getBoardHeight() {
        return getBoardWidth();
    }

    @Override
    public String getPicture() {
        return "made/marker/" + dictionary + '/' + id + ".png";
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (id >= count()) {
            faults.add("id", id, "0 to " + (count() - 1) + " in " + dictionary);
        }
        if (getImage() != null) {
            faults.add("image", getImage(), "none: a marker has the picture of its number");
        }
    }
}
