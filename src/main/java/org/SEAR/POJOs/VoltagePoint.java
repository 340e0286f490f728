package org.SEAR.POJOs;

import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;

/** One point of a triangulating infrared sensor's curve. Immutable, any thread. */
@Described("one point of an infrared sensor's curve")
public class VoltagePoint {
    @Param(doc = "distance of the object", unit = "m", max = 10000, required = true)
    private double distance;
    @Param(doc = "output of the sensor", unit = "V", max = 100, required = true)
    private double volts;

    /** For reading from a file. */
    protected VoltagePoint() {
    }

    /** Metres. */
    public double getDistance() {
        return distance;
    }

    /** Volts. */
    public double getVolts() {
        return volts;
    }
}
