// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Included;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;

/** Angle from north to the forward axis, degrees clockwise; with ports also an HMC6352 on a serial bridge. */
@Described("angle from north to the forward axis, degrees clockwise; with ports also an HMC6352 on a serial bridge")
public class Compass extends SensorObject implements SerialObject {
    @Param(doc = "whether north is magnetic north at the robot's place and date")
    private boolean declination;
    @Param(doc = "a point to the north: x", unit = "m", min = -1e7, max = 1e7)
    private double northX = 100000;
    @Param(doc = "a point to the north: y", unit = "m", min = -1e7, max = 1e7)
    private double northY;
    @Param(doc = "a point to the north: z", unit = "m", min = -1e7, max = 1e7)
    private double northZ;
    @Included
    private final SerialParameters serial = new SerialParameters(this, 9600);

    /** For reading from a file. */
    protected Compass() {
    }

    /** Relative to true north, the world's +x. */
    public Compass(String name) {
        this(name, false);
    }

    /** @param declination whether to return magnetic north */
    public Compass(String name, boolean declination) {
        this(name, declination, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public Compass(String name, boolean declination, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        this.declination = declination;
        pose(x, y, z, rx, ry, rz);
        created(Compass.class);
    }

    @Override
    protected void crossCheck(Faults faults) {
        if (northX == 0 && northZ == 0) {
            faults.add("northX", northX, "a point that isn't straight above or below the origin");
        }
    }

    public boolean isDeclination() {
        return declination;
    }

    public double getNorthX() {
        return northX;
    }

    public double getNorthY() {
        return northY;
    }

    public double getNorthZ() {
        return northZ;
    }

    /** @param on whether north is magnetic north */
    public void setDeclination(boolean on) {
        declination = checked("declination", on);
        changed();
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }

    /** @param newNorthX metres, a point of the world to the north; not directly above or below the origin */
    public void setNorth(double newNorthX, double newNorthY, double newNorthZ) {
        if (newNorthX == 0 && newNorthZ == 0) {
            throw new IllegalArgumentException(this + ": north is (0, " + Parameter.format(newNorthY)
                + ", 0), legal: a point that isn't straight above or below the origin");
        }
        double checkedX = checked("northX", newNorthX);
        double checkedY = checked("northY", newNorthY);
        northZ = checked("northZ", newNorthZ);
        northX = checkedX;
        northY = checkedY;
        changed();
    }
}
