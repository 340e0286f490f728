package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/** The colour of the surface before it: red, green and blue, 0 to 255. By itself it looks straight down. */
@Described("the colour of the surface below it: red, green and blue, 0 to 255")
public class ColorSensor extends SurfaceSensor {

    /** For reading from a file. */
    protected ColorSensor() {
    }

    /** Looks straight down from the robot's origin. */
    public ColorSensor(String name) {
        this(name, 0, 0, 0);
    }

    /** Looks straight down from (x, y, z) of the body frame, metres. */
    public ColorSensor(String name, double x, double y, double z) {
        super(name, x, y, z);
        created(ColorSensor.class);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees; (90, 0, 0) looks straight down, (0, 0, 0) forward. */
    public ColorSensor(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name, x, y, z, rx, ry, rz);
        created(ColorSensor.class);
    }
}
