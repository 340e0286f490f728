// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.gps;

import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;

/** Creates the receiver of a GPS object. */
public final class GpsType implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return GPS.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        GPS gps = (GPS) parameters;
        GpsModel model = GpsModel.of(gps.getModel());
        Receiver receiver = model == GpsModel.NEOM8N
            ? new NeoM8n(gps.getBaud(), gps.getRate(), gps.getTimeToFix(), context)
            : new Mt3301(model, gps.getBaud(), gps.getRate(), gps.getTimeToFix(), context);
        return receiver.withLatency(gps.getLatency());
    }
}
