// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import org.SEAR.POJOs.SearObject;

/** Registry entry of a kind of serial device; found by {@link java.util.ServiceLoader}. */
public interface DeviceType {
    /**
     * Class of the object grammar whose objects have such a device behind their ports. Registration makes its files
     * readable.
     */
    Class<? extends SearObject> parameterType();

    /** Creates the device of an object, powered on; null if this object has none (a LIDAR of another model). */
    SerialDevice create(SearObject parameters, DeviceContext context);
}
