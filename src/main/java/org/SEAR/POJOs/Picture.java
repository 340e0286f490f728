// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** A picture on a plate. The plate's edges and back have the colour of the picture's lower left corner. */
@Described("a vertical plate with a picture of your own, its front towards -z; its origin is the middle of the picture")
public class Picture extends Board {
    @Param(doc = "size along x", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.6")
    private double width;
    @Param(doc = "size along y", unit = "m", min = SMALL, max = LARGE, required = true, initial = "0.3")
    private double height;

    /** For reading from a file. */
    protected Picture() {
    }

    /** Fixed in place, with a test card: bars of eight colours. */
    public Picture(String name, double width, double height) {
        this(name, width, height, null);
    }

    /**
     * Fixed in place.
     *
     * @param width size along x, metres
     * @param height size along y, metres
     * @param image path below assets; null for a test card
     */
    public Picture(String name, double width, double height, String image) {
        this(name, width, height, image, 0, 0, 0, 0, 0, 0);
    }

    /** With its middle at (x, y, z), metres. */
    public Picture(String name, double width, double height, String image, double x, double y, double z) {
        this(name, width, height, image, x, y, z, 0, 0, 0);
    }

    /** With its middle at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Picture(String name, double width, double height, String image, double x, double y, double z, double rx,
        double ry, double rz) {
        super(name, 0);
        this.width = width;
        this.height = height;
        wrap(image);
        pose(x, y, z, rx, ry, rz);
        created(Picture.class);
    }

    public double getWidth() {
        return width;
    }

    public double getHeight() {
        return height;
    }

    @Override
    public double getBoardWidth() {
        return width;
    }

    @Override
    public double getBoardHeight() {
        return height;
    }

    @Override
    protected String defaultPicture() {
        return "made/testcard.png";
    }
}
