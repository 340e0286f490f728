package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/** A sensor that looks at a small spot of a surface near by. Its short constructors have it look straight down. */
public abstract class SurfaceSensor extends SensorObject {
    private static final double DOWN = 90;

    @Param(doc = "diameter of the spot that it looks at", unit = "m", min = 0.0001, max = 1)
    private double spot = 0.006;
    @Param(doc = "how far away a surface may be; farther ones are dark", unit = "m", min = 0.001, max = 10)
    private double range = 0.05;

    /** For reading from a file. */
    protected SurfaceSensor() {
    }

    /** Looks straight down from (x, y, z) of the body frame, metres. */
    SurfaceSensor(String name, double x, double y, double z) {
        this(name, x, y, z, DOWN, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    SurfaceSensor(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        pose(x, y, z, rx, ry, rz);
    }

    /** Diameter of the spot that it looks at, metres. */
    public double getSpot() {
        return spot;
    }

    /** @param metres diameter of the spot that it looks at, 0.0001 to 1 */
    public void setSpot(double metres) {
        spot = checked("spot", metres);
        changed();
    }

    /** How far away a surface may be, metres. */
    public double getRange() {
        return range;
    }

    /** @param metres how far away a surface may be, 0.001 to 10 */
    public void setRange(double metres) {
        range = checked("range", metres);
        changed();
    }
}
