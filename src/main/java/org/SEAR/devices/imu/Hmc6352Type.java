// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.imu;

import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;

/** Creates the HMC6352 of a Compass. */
public final class Hmc6352Type implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return Compass.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        return new Hmc6352(((Compass) parameters).getBaud(), context);
    }
}
