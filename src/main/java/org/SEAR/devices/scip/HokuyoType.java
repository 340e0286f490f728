// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.scip;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.LidarSettings;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.lidar.LidarProtocol;
import org.SEAR.protocol.scip.HokuyoModel;

/** Creates the Hokuyo of a LIDAR with SCIP 2.0. It measures the model's whole angle; commands request a part of it. */
public final class HokuyoType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return LIDAR.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        LidarSettings settings = LidarSettings.of((LIDAR) parameters, LidarProtocol.SCIP, context);
        return settings == null ? null : new Hokuyo(HokuyoModel.of(settings.model), settings.baud, context);
    }
}
