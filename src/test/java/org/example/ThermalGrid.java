// SPDX-License-Identifier: Apache-2.0
package org.example;

import java.util.List;
import org.SEAR.POJOs.SensorObject;
import org.SEAR.POJOs.Wirable;
import org.SEAR.grammar.Param;
import org.SEAR.protocol.arduino.WireRole;

/** Parameters of a thermal camera of 8 x 8 pixels that sees warm objects before cold ground and air. */
public class ThermalGrid extends SensorObject implements Wirable {
    @Param(doc = "temperature of the ground and of what is out of range", unit = "degC", min = -40, max = 80)
    private double air = 20;
    @Param(doc = "temperature of things", unit = "degC", min = -40, max = 80)
    private double things = 34;

    /** Constructor for reading from a file. */
    protected ThermalGrid() {
    }

    /** Air of 20 and objects of 34 degrees Celsius. */
    public ThermalGrid(String name) {
        super(name);
        created(ThermalGrid.class);
    }

    /** Degrees Celsius. */
    public double getAir() {
        return air;
    }

    /** Degrees Celsius. */
    public double getThings() {
        return things;
    }

    @Override
    public List<WireRole> getWireRoles() {
        return List.of(WireRole.VOLTS);
    }
}
