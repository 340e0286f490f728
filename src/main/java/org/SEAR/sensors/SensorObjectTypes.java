package org.SEAR.sensors;

import java.util.Collection;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SearObject;

/** Makes the parameter class of every registered sensor a part of the object grammar, so that its XML files are read. */
public final class SensorObjectTypes implements ObjectTypes {
    @Override
    public Collection<Class<? extends SearObject>> types() {
        return SensorTypes.load().parameterTypes();
    }
}
