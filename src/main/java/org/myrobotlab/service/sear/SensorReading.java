// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear;

import java.util.Arrays;

/** A published reading. JSON-friendly, immutable. */
public final class SensorReading {
    public final String name;
    /** Simulated time, seconds. */
    public final double time;
    /** The result of the sensor's get...Result call: a number, a text "x,y,z" or an array. */
    public final Object value;

    public SensorReading(String name, double time, Object value) {
        this.name = name;
        this.time = time;
        this.value = value;
    }

    /** Returns for example {@code ping at 2.5 s: 0.47}. */
    @Override
    public String toString() {
        return name + " at " + time + " s: " + (value instanceof float[] ? Arrays.toString((float[]) value)
            : value instanceof double[] ? Arrays.toString((double[]) value) : value);
    }
}
