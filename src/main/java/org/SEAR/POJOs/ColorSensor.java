// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;

/**
 * Colour of the surface in front of the sensor: red, green and blue, 0 to 255. The short constructors point it straight
 * down.
 */
@Described("the colour of the surface below it: red, green and blue, 0 to 255")
public class ColorSensor extends SurfaceSensor {

    /** For reading from a file. */
    protected ColorSensor() {
    }

    /** Points straight down from the robot's origin. */
    public ColorSensor(String name) {
        this(name, 0, 0, 0);
    }

    /** Points straight down from (x, y, z) of the body frame, metres. */
    public ColorSensor(String name, double x, double y, double z) {
        super(name, x, y, z);
        created(ColorSensor.class);
    }

    /**
     * At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees: (90, 0, 0) points straight down, (0, 0,
     * 0) forward.
     */
    public ColorSensor(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name, x, y, z, rx, ry, rz);
        created(ColorSensor.class);
    }
}
