package org.SEAR.sensors;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.SEAR.POJOs.ObjectTypes;
import org.SEAR.POJOs.SearObject;

/** Makes the parameter class of every registered sensor a part of the object grammar, so that its XML files are read. */
public final class SensorObjectTypes implements ObjectTypes {
    @Override
    public Collection<Class<? extends SearObject>> types() {
        List<Class<? extends SearObject>> types = new ArrayList<>();
        for (SensorType type : SensorTypes.load().all()) {
            types.add(type.parameterType());
        }
        return types;
    }
}
