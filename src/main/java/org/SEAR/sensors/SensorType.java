// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.SearObject;

/**
 * Registry entry of a kind of sensor, found by {@link java.util.ServiceLoader}. A new sensor consists of a parameter
 * class, a sensor class with this entry beside it, and a line in {@code META-INF/services/org.SEAR.sensors.SensorType}.
 */
public interface SensorType {
    /** Returns the class of the object grammar that describes such a sensor. */
    Class<? extends SearObject> parameterType();

    /** Returns one sentence: the measured quantity and its reading, with unit. {@code sear sensors} prints it. */
    String description();

    /**
     * Returns the unit for display, for example {@code deg} or {@code m/s2}. Values with different units have one each:
     * {@code deg, deg, m}. Empty for none.
     */
    default String unit() {
        return "";
    }

    /** Returns the unit of an object's sensor, where objects of this kind differ. */
    default String unit(SearObject parameters) {
        return unit();
    }

    /**
     * Creates a sensor for the object.
     *
     * @param seed random seed of the simulation, from which the sensor derives its own random numbers
     */
    Sensor<?> create(SearObject parameters, long seed);
}
