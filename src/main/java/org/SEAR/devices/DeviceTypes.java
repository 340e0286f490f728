package org.SEAR.devices;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.ServiceLoader;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SearObject;

/**
 * The kinds of serial devices there are: those of SEAR and those that other jars register in {@code META-INF/services/org.SEAR.devices.DeviceType}.
 * Jars are found by SEAR's own class loader and by the thread's context class loader. Immutable, any thread.
 */
public final class DeviceTypes {
    private final List<DeviceType> types;

    /** @param types in the order in which they are asked */
    DeviceTypes(List<DeviceType> types) {
        this.types = List.copyOf(types);
    }

    /** Looks for all kinds that can be found now. */
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

    /** The classes of the object grammar that have devices, in the order in which their kinds are registered, each once. */
    Collection<Class<? extends SearObject>> parameterTypes() {
        return types.stream().map(DeviceType::parameterType).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    /** Whether there is a kind that may sit behind an object's ports. */
    public boolean isKnown(SearObject object) {
        return types.stream().anyMatch(type -> type.parameterType().isInstance(object));
    }

    /**
     * The device of an object: that of the first kind that has one for it.
     *
     * @param context what the device can reach
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
