// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Collection;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SearObject;

/** Adds the parameter class of every registered sensor to the object grammar, so that its XML files can be read. */
public final class SensorObjectTypes implements ObjectTypes {
    @Override
    public Collection<Class<? extends SearObject>> types() {
        return SensorTypes.load().parameterTypes();
    }
}
