// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Map;
import java.util.Objects;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** A flat fixed box, length along x and width along z; its top is at its own y. It may be invisible to beams. */
@Described("a flat fixed box 0.1 m thick, length along x and width along z; its top is at its own y")
public class Floor extends Shape {
    /** Depth of the floor below its top, metres. */
    public static final double THICKNESS = 0.1;

    @Param(doc = "size along x", unit = "m", min = SMALL, max = LARGE, required = true, initial = "10")
    private double length;
    @Param(doc = "size along z", unit = "m", min = SMALL, max = LARGE, required = true, initial = "10")
    private double width;
    @Param(doc = "width and height of one repetition of the picture; default: a picture of your own covers the floor "
        + "once", unit = "m", min = 0.01, max = LARGE)
    private Double imageSize;

    /** For reading from a file. */
    protected Floor() {
    }

    /** With the top at height 0, tiled, visible to beams. */
    public Floor(String name, double length, double width) {
        this(name, length, width, true, null);
    }

    /** @param visible whether it is visible to beams */
    public Floor(String name, double length, double width, boolean visible) {
        this(name, length, width, visible, null);
    }

    /** @param image path below assets; null for tiles */
    public Floor(String name, double length, double width, String image) {
        this(name, length, width, true, image);
    }

    /** With visibility and picture. */
    public Floor(String name, double length, double width, boolean visible, String image) {
        this(name, length, width, visible, image, 0, 0, 0, 0, 0, 0);
    }

    /** With all parameters: the middle of the top at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
    public Floor(String name, double length, double width, boolean visible, String image,
            double x, double y, double z, double rx, double ry, double rz) {
        super(name, 0);
        this.length = length;
        this.width = width;
        show(visible);
        wrap(image);
        pose(x, y, z, rx, ry, rz);
        created(Floor.class);
    }

    @Override
    String whyNoComponent() {
        return " can't be a component, legal: a shape, a model, a sensor, dynamics";
    }

    public double getLength() {
        return length;
    }

    public double getWidth() {
        return width;
    }

    public Double getImageSize() {
        return imageSize;
    }

    /**
     * Repeats the picture, which keeps its resolution on a large floor. By default the surface pictures that come with
     * SEAR (tiles, brick, grass) are repeated at their true size. A picture of the user's, such as a map or a line
     * course, covers the floor once.
     *
     * @param metres width and height of one repetition, 0.01 to 100000
     */
    public void setImageSize(double metres) {
        imageSize = checked("imageSize", metres);
        changed();
    }

    @Override
    public Double getPictureTile() {
        return imageSize == null ? super.getPictureTile() : imageSize;
    }

    /**
     * Adds {@code tile}, for a picture of the floor's own: size of its repetition, metres; 0 if it covers the floor
     * once.
     */
    @Override
    protected void addDrawingProperties(Map<String, Object> properties) {
        super.addDrawingProperties(properties);
        if (getImage() != null) {
            properties.put("tile", Objects.requireNonNullElse(getPictureTile(), 0.0));
        }
    }

    @Override
    public boolean isGround() {
        return true;
    }

    @Override
    protected String defaultPicture() {
        return "textures/tiles.png";
    }
}
