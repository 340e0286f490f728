// SPDX-License-Identifier: Apache-2.0
package org.example;

import org.SEAR.POJOs.SensorObject;
import org.SEAR.grammar.Param;

/** Parameters of a sensor from outside SEAR, the example of docs/add-a-sensor.md. */
public class Thermometer extends SensorObject {
    @Param(doc = "temperature at the world's origin", unit = "degC", min = -100, max = 100)
    private double ground = 20;
    @Param(doc = "how much colder it gets with height", unit = "K/m", max = 1)
    private double lapse = 0.0065;

    /** Constructor for reading from a file. */
    protected Thermometer() {
    }

    /** Makes a thermometer with the standard atmosphere's temperature gradient. */
    public Thermometer(String name) {
        super(name);
        created(Thermometer.class);
    }

    /** Temperature at the world's origin, degrees Celsius. */
    public double getGround() {
        return ground;
    }

    /** Kelvin per metre of height. */
    public double getLapse() {
        return lapse;
    }

    /** @param celsius -100 to 100 */
    public void setGround(double celsius) {
        ground = checked("ground", celsius);
        changed();
    }
}
