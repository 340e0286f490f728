// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import org.SEAR.POJOs.IMU;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;

/** Creates the Razor 9DOF of an IMU. */
public final class RazorType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return IMU.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        return new Razor(((IMU) parameters).getBaud(), context);
    }
}
