// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Included;

/** Yaw, pitch and roll, acceleration, angular velocity and magnetic field; with ports also a Razor 9DOF. */
@Described("yaw, pitch and roll, acceleration, angular velocity, magnetic field; with ports also a Razor 9DOF")
public class IMU extends SensorObject implements SerialObject {
    @Included
    private final SerialParameters serial = new SerialParameters(this, 57600);

    /** For reading from a file. */
    protected IMU() {
    }

    /** At the body's origin. */
    public IMU(String name) {
        this(name, 0, 0, 0, 0, 0, 0);
    }

    /**
     * With ports.
     *
     * @param uart the device's end
     * @param user the end that the user opens
     */
    public IMU(String name, String uart, String user) {
        super(name);
        setPorts(uart, user);
        created(IMU.class);
    }

    /** At (x, y, z) of the body frame, metres, turned by (rx, ry, rz), degrees. */
    public IMU(String name, double x, double y, double z, double rx, double ry, double rz) {
        super(name);
        pose(x, y, z, rx, ry, rz);
        created(IMU.class);
    }

    @Override
    public SerialParameters getSerial() {
        return serial;
    }
}
