// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/**
 * A massless rope from a point of the first object to one of the second: it is never longer than {@code upper}. With a
 * lower limit it is a rod, with a spring a coil spring, with a motor a winch.
 */
@Described("a massless rope from (x, y, z) on the first object to (endX, endY, endZ) on the second; its position "
    + "is its length")
public class Rope extends AxisJoint {
    @Param(doc = "end on the second object, northwards", unit = "m", min = -FAR, max = FAR)
    private double endX;
    @Param(doc = "end on the second object, upwards", unit = "m", min = -FAR, max = FAR)
    private double endY;
    @Param(doc = "end on the second object, eastwards", unit = "m", min = -FAR, max = FAR)
    private double endZ;

    /** For reading from a file. */
    protected Rope() {
    }

    /**
     * From (x, y, z) to (endX, endY, endZ), metres; it is taut there.
     *
     * @param first null for the world
     */
    public Rope(String name, SearObject first, SearObject second, double x, double y, double z, double endX,
        double endY, double endZ) {
        super(name, first, second);
        pose(x, y, z, 0, 0, 0);
        this.endX = endX;
        this.endY = endY;
        this.endZ = endZ;
        limit(null, Math.sqrt((endX - x) * (endX - x) + (endY - y) * (endY - y) + (endZ - z) * (endZ - z)));
        created(Rope.class);
    }

    public double getEndX() {
        return endX;
    }

    public double getEndY() {
        return endY;
    }

    public double getEndZ() {
        return endZ;
    }
}
