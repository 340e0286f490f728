// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SearObject;

/**
 * All kinds of serial devices: those of SEAR, and those that other jars register in
 * {@code META-INF/services/org.SEAR.devices.DeviceType}. SEAR's own class loader and the thread's context class loader
 * find them. Immutable, any thread.
 */
public final class DeviceTypes {
    private final List<DeviceType> types;

    /** @param types in the order in which {@link #create} tries them */
    DeviceTypes(List<DeviceType> types) {
        this.types = List.copyOf(types);
    }

    /** Loads all kinds that are available now. */
    public static DeviceTypes load() {
        List<DeviceType> found = new ArrayList<>();
        ClassLoader own = DeviceTypes.class.getClassLoader();
        ServiceLoader.load(DeviceType.class, own).forEach(found::add);
        ClassLoader context = Thread.currentThread().getContextClassLoader();
        if (context != null && context != own) {
            ServiceLoader.load(DeviceType.class, context).forEach(found::add);
        }
        return new DeviceTypes(found);
    }

    /** Object classes with devices, each once, in the order of registration. */
    Collection<Class<? extends SearObject>> parameterTypes() {
        return types.stream().map(DeviceType::parameterType).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** Whether some kind of device may sit behind an object's ports. */
    public boolean isKnown(SearObject object) {
        return types.stream().anyMatch(type -> type.parameterType().isInstance(object));
    }

    /**
     * Creates an object's device with the first kind that has one for it.
     *
     * @param context access of the device to the simulation
     * @return null if no kind has one
     */
    public SerialDevice create(SearObject object, DeviceContext context) {
        for (DeviceType type : types) {
            SerialDevice device = type.parameterType().isInstance(object) ? type.create(object, context) : null;
            if (device != null) {
                return device;
            }
        }
        return null;
    }
}
