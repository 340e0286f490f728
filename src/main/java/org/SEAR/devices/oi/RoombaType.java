// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;

/** Creates the Roomba 400, Create or Create 2 of a robot's dynamics. */
public final class RoombaType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return Dynamics.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        Dynamics dynamics = (Dynamics) parameters;
        return new RoombaFirmware(OiModel.of(dynamics.getModel()), dynamics.getBaud(),
            dynamics.isStreamHeaderSummed(), context);
    }
}
