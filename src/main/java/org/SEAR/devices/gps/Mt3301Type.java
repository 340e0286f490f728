package org.SEAR.devices.gps;

import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.SearObject;
import org.SEAR.devices.DeviceContext;
import org.SEAR.devices.DeviceType;
import org.SEAR.devices.SerialDevice;

/** Puts a MediaTek receiver behind the ports of a GPS. */
public final class Mt3301Type implements DeviceType {
    @Override
    public Class<? extends SearObject> parameterType() {
        return GPS.class;
    }

    @Override
    public SerialDevice create(SearObject parameters, DeviceContext context) {
        GPS gps = (GPS) parameters;
        return new Mt3301(GpsModel.of(gps.getModel()), gps.getBaud(), gps.getRate(), gps.getTimeToFix(), context);
    }
}
