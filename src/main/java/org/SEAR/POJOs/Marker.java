package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;

/**
 * A marker of ArUco or AprilTag, by whose corners a camera's program finds out where it is. Its black square is so large as is said; around it is a
 * white margin, as wide as one of its cells.
 */
@Described("a plate with a marker of ArUco or AprilTag, upright, its front towards -z; the middle of the marker is its origin")
public class Marker extends Board {
    private static final String APRILTAG = "APRILTAG_36h11";
    private static final int APRILTAGS = 587;
    private static final int APRILTAG_CELLS = 6;
    /** Cells of the black edge, and of the margin, on both sides. */
    private static final int EDGES = 2;

    @Param(doc = "dictionary, as OpenCV calls it", values = {"DICT_4X4_50", "DICT_4X4_100", "DICT_4X4_250", "DICT_4X4_1000", "DICT_5X5_50",
        "DICT_5X5_100", "DICT_5X5_250", "DICT_5X5_1000", "DICT_6X6_50", "DICT_6X6_100", "DICT_6X6_250", "DICT_6X6_1000", "DICT_7X7_50",
        "DICT_7X7_100", "DICT_7X7_250", "DICT_7X7_1000", APRILTAG})
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
     * @param dictionary as OpenCV calls it: DICT_4X4_50 ... DICT_7X7_1000, or APRILTAG_36h11
     * @param id number in it, from 0
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
    public Marker(String name, String dictionary, int id, double size, double x, double y, double z, double rx, double ry, double rz) {
        super(name, 0);
        this.dictionary = dictionary;
        this.id = id;
        this.size = size;
        pose(x, y, z, rx, ry, rz);
        created(Marker.class);
    }

    /** The dictionary, as OpenCV calls it. */
    public String getDictionary() {
        return dictionary;
    }

    /** Number in the dictionary. */
    public int getId() {
        return id;
    }

    /** Side of the black square, metres, before scaling. */
    public double getSize() {
        return size;
    }

    /** Cells of a row, without the black edge. */
    private int cells() {
        return dictionary.equals(APRILTAG) ? APRILTAG_CELLS : dictionary.charAt("DICT_".length()) - '0';
    }

    private int count() {
        return dictionary.equals(APRILTAG) ? APRILTAGS : Integer.parseInt(dictionary.substring(dictionary.lastIndexOf('_') + 1));
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
