// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.cola;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.LidarSettings;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.lidar.LidarProtocol;

/** Creates the SICK LMS1xx or TiM of a LIDAR of such a model. */
public final class ColaType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return LIDAR.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        LidarSettings settings = LidarSettings.of((LIDAR) parameters, LidarProtocol.COLA, context);
        return settings == null ? null
            : new ColaScanner(ColaModel.of(settings.model), settings.spread, settings.resolution,
                settings.baud, context);
    }
}
