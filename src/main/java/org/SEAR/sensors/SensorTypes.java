// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SearObject;

/**
 * All kinds of sensors: SEAR's and those that other jars register in
 * {@code META-INF/services/org.SEAR.sensors.SensorType}. SEAR's own class loader and the thread's context class loader
 * find the jars. Immutable; any thread.
 */
public final class SensorTypes {
    private final Map<String, SensorType> types = new LinkedHashMap<>();

    private SensorTypes() {
    }

    /** Finds all kinds that are present now. */
    public static SensorTypes load() {
        SensorTypes found = new SensorTypes();
        found.add(SensorTypes.class.getClassLoader());
        ClassLoader context = Thread.currentThread().getContextClassLoader();
        if (context != null) {
            found.add(context);
        }
        return found;
    }

    private void add(ClassLoader loader) {
        for (SensorType type : ServiceLoader.load(SensorType.class, loader)) {
            types.putIfAbsent(type.parameterType().getSimpleName(), type);
        }
    }

    /** Returns all kinds, ordered by the simple name of their parameter class. */
    public Collection<SensorType> all() {
        return Collections.unmodifiableCollection(new TreeMap<>(types).values());
    }

    /** Returns the parameter classes of all kinds, in the order of registration. */
    List<Class<? extends SearObject>> parameterTypes() {
        return types.values().stream().map(SensorType::parameterType).collect(Collectors.toList());
    }

    /** Returns the unit of an object's reading; empty if it is no sensor or has no unit. */
    public String unit(SearObject object) {
        SensorType type = find(object);
        return type == null ? "" : type.unit(object);
    }

    /** Returns whether an object describes a sensor. */
    public boolean isSensor(SearObject object) {
        return find(object) != null;
    }

    /**
     * Creates a sensor for an object.
     *
     * @param seed random seed of the simulation
     * @throws IllegalArgumentException with all kinds of sensors, for another object
     */
    public Sensor<?> create(SearObject object, long seed) {
        SensorType type = find(object);
        if (type == null) {
            throw new IllegalArgumentException(object.getClass().getSimpleName() + " " + object.getName()
                + " is no sensor; sensors are " + String.join(", ", new TreeMap<>(types).keySet()));
        }
        return type.create(object, seed);
    }

    private SensorType find(SearObject object) {
        SensorType type = types.get(object.getClass().getSimpleName());
        return type != null && type.parameterType().isInstance(object) ? type : null;
    }
}
