// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.rplidar;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.LidarSettings;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.lidar.LidarProtocol;

/**
 * Creates the RPLIDAR A1 of a LIDAR of that model. It always scans the whole circle; the object's resolution sets its
 * motor's speed.
 */
public final class RplidarType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return LIDAR.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        LidarSettings settings = LidarSettings.of((LIDAR) parameters, LidarProtocol.RPLIDAR, context);
        return settings == null ? null : new RplidarA1(settings.resolution, settings.model.getNearest(), context);
    }
}
