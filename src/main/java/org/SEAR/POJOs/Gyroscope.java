// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** Angular velocity about the body axes, rad/s. */
@Described("angular velocity about the three body axes, rad/s")
public class Gyroscope extends SensorObject {
    @Param(doc = "new readings a second", unit = "Hz", min = 0.01, max = 10000)
    private double bandwidth = 60;

    /** For reading from a file. */
    protected Gyroscope() {
    }

    /** 60 Hz. */
    public Gyroscope(String name) {
        this(name, 60);
    }

    /** @param bandwidth Hz */
    public Gyroscope(String name, double bandwidth) {
        this(name, bandwidth, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public Gyroscope(String name, double bandwidth, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        this.bandwidth = bandwidth;
        pose(x, y, z, rx, ry, rz);
        created(Gyroscope.class);
    }

    public double getBandwidth() {
        return bandwidth;
    }

    /** @param hertz 0.01 to 10000 */
    public void setBandwidth(double hertz) {
        bandwidth = checked("bandwidth", hertz);
        changed();
    }
}
