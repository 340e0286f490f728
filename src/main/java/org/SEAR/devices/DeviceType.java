package org.SEAR.devices;

import org.SEAR.POJOs.SearObject;

/** The registry entry of a kind of serial device; found by {@link java.util.ServiceLoader}. */
public interface DeviceType {
    /** The class of the object grammar that has such a device behind its ports; being registered here makes its files readable. */
    Class<? extends SearObject> parameterType();

    /** A device for the object, powered on; null if this object has none (a LIDAR of another model). */
    SerialDevice create(SearObject parameters, DeviceContext context);
}
