// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.List;
import org.SEAR.grammar.Described;
import org.SEAR.protocol.arduino.WireRole;

/**
 * Light reflected by the surface in front of the sensor, percent: 0 for black or no surface, 100 for white. The short
 * constructors point it straight down.
 */
@Described("light reflected by the surface below it, percent: 0 for black or no surface, 100 for white")
public class LineSensor extends SurfaceSensor implements Wirable {

    /** For reading from a file. */
    protected LineSensor() {
    }

    /** Points straight down from the robot's origin. */
    public LineSensor(String name) {
        this(name, 0, 0, 0);
    }

    /** Points straight down from (x, y, z) of the body frame, metres. */
    public LineSensor(String name, double x, double y, double z) {
        super(name, x, y, z);
        created(LineSensor.class);
    }

    /**
     * At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees: (90, 0, 0) points straight down, (0, 0,
     * 0) forward.
     */
    public LineSensor(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name, x, y, z, rx, ry, rz);
        created(LineSensor.class);
    }

    @Override
    public List<WireRole> getWireRoles() {
        return List.of(WireRole.VOLTS);
    }
}
