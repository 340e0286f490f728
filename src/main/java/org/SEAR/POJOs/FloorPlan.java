// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Locale;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.TextRule;

/**
 * Walls from a picture whose dark pixels are walls, or from a ROS map: a {@code .yaml} file that names a picture, its
 * resolution, origin and thresholds. The upper edge of the picture is north (+x), its right edge east (+z). The middle
 * of a picture is the object's origin; a ROS map keeps its own origin, with ROS's x eastwards and y northwards.
 */
@Described("walls from a picture's dark pixels or from a ROS map (.yaml); its upper edge is north; the origin is the "
    + "middle of a picture, or that of the ROS map")
public class FloorPlan extends Walls {
    private static final double HEIGHT = 0.5;
    private static final double DARK = 0.5;
    private static final double FINEST = 0.0001;

    @Param(doc = "picture below assets: .pgm, .png, .jpg, .gif or .bmp, or a ROS map: .yaml or .yml",
        text = TextRule.ASSET, required = true)
    private String path;
    @Param(doc = "side of a pixel; none for a ROS map, which has its own", unit = "m", min = FINEST, max = 1000)
    private Double metresPerPixel;
    @Param(doc = "darkness of a pixel, 0 white to 1 black, above which it is a wall; a ROS map has its own", max = 1)
    private double darkness = DARK;

    /** For reading from a file. */
    protected FloorPlan() {
        super(HEIGHT);
    }

    /**
     * A ROS map with walls 0.5 m high.
     *
     * @param path of its .yaml file below assets
     */
    public FloorPlan(String name, String path) {
        this(name, path, HEIGHT);
    }

    /**
     * A ROS map.
     *
     * @param path of its .yaml file below assets
     * @param height of the walls, metres
     */
    public FloorPlan(String name, String path, double height) {
        super(name, height);
        this.path = path;
        created(FloorPlan.class);
    }

    /**
     * A picture.
     *
     * @param path below assets
     * @param metresPerPixel side of a pixel, metres
     * @param height of the walls, metres
     */
    public FloorPlan(String name, String path, double metresPerPixel, double height) {
        super(name, height);
        this.path = path;
        this.metresPerPixel = metresPerPixel;
        created(FloorPlan.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (path != null && isRosMap() && metresPerPixel != null) {
            faults.add("metresPerPixel", metresPerPixel, "none: a ROS map has its own resolution");
        } else if (path != null && !isRosMap() && metresPerPixel == null) {
            faults.add("metresPerPixel", "", "the side of a pixel in metres, for a picture without a .yaml file");
        }
    }

    /** Returns whether the path is that of a ROS map. */
    public boolean isRosMap() {
        String lower = path.toLowerCase(Locale.ROOT);
        return lower.endsWith(".yaml") || lower.endsWith(".yml");
    }

    public String getPath() {
        return path;
    }

    /** Returns the side of a pixel, metres; null for a ROS map. */
    public Double getMetresPerPixel() {
        return metresPerPixel;
    }

    public double getDarkness() {
        return darkness;
    }

    /** @param share darkness of a pixel above which it is a wall, 0 (white) to 1 (black); default 0.5 */
    public void setDarkness(double share) {
        darkness = checked("darkness", share);
        changed();
    }
}
