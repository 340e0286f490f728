// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** One point of the voltage curve of a triangulating infrared sensor. Immutable, any thread. */
@Described("one point of an infrared sensor's curve")
public class VoltagePoint {
    @Param(doc = "distance of the object", unit = "m", max = 10000, required = true)
    private double distance;
    @Param(doc = "output of the sensor", unit = "V", max = 100, required = true)
    private double volts;

    /** For reading from a file. */
    protected VoltagePoint() {
    }

    public double getDistance() {
        return distance;
    }

    public double getVolts() {
        return volts;
    }
}
