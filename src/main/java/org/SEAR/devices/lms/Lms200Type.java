// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.lms;

import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.LidarSettings;
import org.SEAR.devices.SerialDevice;
import org.SEAR.protocol.lidar.LidarProtocol;
import org.SEAR.protocol.lms.Identity;
import org.SEAR.protocol.lms.Variant;

/** Creates the SICK LMS2xx of a LIDAR of such a model. */
public final class Lms200Type implements DeviceType {
    private static final int HUNDREDTHS = 100;

    @Override
    public Class<? extends SearObject> parameterType() {
        return LIDAR.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        LIDAR lidar = (LIDAR) parameters;
        LidarSettings settings = LidarSettings.of(lidar, LidarProtocol.LMS, context);
        if (settings == null) {
            return null;
        }
        Variant variant = Variant.of((int) Math.round(settings.spread),
            (int) Math.round(settings.resolution * HUNDREDTHS));
        return new Lms200(new PowerOnSettings(variant, settings.baud, lidar.isLenient(),
            Identity.of(settings.model.getName())), context);
    }
}
