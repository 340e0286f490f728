// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** Acceleration along the body axes, m/s^2: the change of velocity over one period of the bandwidth. */
@Described("acceleration along the three body axes, m/s^2")
public class Accelerometer extends SensorObject {
    @Param(doc = "new readings a second", unit = "Hz", min = 0.01, max = 10000)
    private double bandwidth = 60;
    @Param(doc = "whether the reading includes gravity, as a real one does")
    private boolean gravity;

    /** For reading from a file. */
    protected Accelerometer() {
    }

    /** 60 Hz. */
    public Accelerometer(String name) {
        this(name, 60);
    }

    /** @param bandwidth Hz */
    public Accelerometer(String name, double bandwidth) {
        this(name, bandwidth, 0, 0, 0, 0, 0, 0);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public Accelerometer(String name, double bandwidth, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        this.bandwidth = bandwidth;
        pose(x, y, z, rx, ry, rz);
        created(Accelerometer.class);
    }

    public double getBandwidth() {
        return bandwidth;
    }

    public boolean isGravity() {
        return gravity;
    }

    /** @param hertz 0.01 to 10000 */
    public void setBandwidth(double hertz) {
        bandwidth = checked("bandwidth", hertz);
        changed();
    }

    /** @param on whether gravity is part of the reading (proper acceleration); default false */
    public void setGravity(boolean on) {
        gravity = checked("gravity", on);
        changed();
    }
}
