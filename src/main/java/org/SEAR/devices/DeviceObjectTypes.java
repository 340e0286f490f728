// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.Collection;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SearObject;

/** Adds the parameter class of every registered device to the object grammar, so that its XML files are readable. */
public final class DeviceObjectTypes implements ObjectTypes {
    @Override
    public Collection<Class<? extends SearObject>> types() {
        return DeviceTypes.load().parameterTypes();
    }
}
