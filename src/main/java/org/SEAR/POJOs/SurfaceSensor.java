// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/** A sensor of a small spot on a nearby surface. The short constructors point it straight down. */
public abstract class SurfaceSensor extends SensorObject {
    private static final double DOWN = 90;

    @Param(doc = "diameter of the measured spot", unit = "m", min = 0.0001, max = 1)
    private double spot = 0.006;
    @Param(doc = "largest distance of a surface; beyond it is dark", unit = "m", min = 0.001, max = 10)
    private double range = 0.05;

    /** For reading from a file. */
    protected SurfaceSensor() {
    }

    /** Points straight down from (x, y, z) of the body frame, metres. */
    SurfaceSensor(String name, double x, double y, double z) {
        this(name, x, y, z, DOWN, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    SurfaceSensor(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        pose(x, y, z, rx, ry, rz);
    }

    public double getSpot() {
        return spot;
    }

    /** @param metres diameter of the spot, 0.0001 to 1 */
    public void setSpot(double metres) {
        spot = checked("spot", metres);
        changed();
    }

    public double getRange() {
        return range;
    }

    /** @param metres largest distance of a surface, 0.001 to 10 */
    public void setRange(double metres) {
        range = checked("range", metres);
        changed();
    }
}
