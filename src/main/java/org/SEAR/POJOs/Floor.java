package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** A flat fixed box, length along x and width along z; its top is at y = its own y. It may be invisible to beams. */
@Described("a flat fixed box 0.1 m thick, length along x and width along z; its top is at its own y")
public class Floor extends Shape {
    /** How far a floor reaches down below its top, metres. */
    public static final double THICKNESS = 0.1;

    @Param(doc = "size along x", unit = "m", min = SMALL, max = LARGE, required = true, initial = "10")
    private double length;
    @Param(doc = "size along z", unit = "m", min = SMALL, max = LARGE, required = true, initial = "10")
    private double width;
    @Param(doc = "metres that the picture is wide and high, after which it is repeated; without it a picture of its own covers the floor once",
        unit = "m", min = 0.01, max = LARGE)
    private Double imageSize;

    /** For reading from a file. */
    protected Floor() {
    }

    /** With the top at height 0, tiled, seen by beams. */
    public Floor(String name, double length, double width) {
        this(name, length, width, true, null);
    }

    /** @param visible whether beams see it */
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

    /** With everything: the middle of the top at (x, y, z), metres, turned by (rx, ry, rz), degrees. */
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

    /** Size along x, metres, before scaling. */
    public double getLength() {
        return length;
    }

    /** Size along z, metres, before scaling. */
    public double getWidth() {
        return width;
    }

    /** Metres after which the picture is repeated; null if one of its own covers the floor once. */
    public Double getImageSize() {
        return imageSize;
    }

    /**
     * Repeats the picture, so that it is as fine on a large floor as on a small one. The pictures of surfaces that come with SEAR (tiles, brick,
     * grass) are repeated in their true size unless told otherwise; a picture of its own, such as a plan or a line course, covers the floor once.
     *
     * @param metres that one picture is wide and high, 0.01 to 100000
     */
    public void setImageSize(double metres) {
        imageSize = checked("imageSize", metres);
        changed();
    }

    @Override
    public Double getPictureTile() {
        return imageSize == null ? super.getPictureTile() : imageSize;
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
