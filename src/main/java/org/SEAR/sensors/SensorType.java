package org.SEAR.sensors;

import org.SEAR.POJOs.SearObject;

/**
 * The registry entry of a kind of sensor. Found by {@link java.util.ServiceLoader}: adding a sensor is a parameter class, a sensor class with this
 * beside it, and a line in {@code META-INF/services/org.SEAR.sensors.SensorType}.
 */
public interface SensorType {
    /** The class of the object grammar that describes such a sensor. */
    Class<? extends SearObject> parameterType();

    /** What it measures and what its reading is, with unit, in one sentence; {@code sear sensors} prints it. */
    String description();

    /**
     * The unit in which its reading is shown to people, for example {@code deg} or {@code m/s2}; where values differ, one for each,
     * {@code deg, deg, m}; empty for what has none.
     */
    default String unit() {
        return "";
    }

    /** The unit of a sensor of an object, where objects of the kind differ in it. */
    default String unit(SearObject parameters) {
        return unit();
    }

    /**
     * A sensor for the object.
     *
     * @param seed of the simulation, from which the sensor derives its own random numbers
     */
    Sensor<?> create(SearObject parameters, long seed);
}
