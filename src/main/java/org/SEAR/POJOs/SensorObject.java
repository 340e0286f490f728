// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/** Parameters of a sensor. A sensor is a component of a robot; without rotation it faces forward. */
public abstract class SensorObject extends SearObject {
    @Param(doc = "error model; default none")
    private Noise noise;

    /** For reading from a file. */
    protected SensorObject() {
    }

    /** @param name by which scripts read the sensor */
    protected SensorObject(String name) {
        super(name);
    }

    @Override
    final boolean isRobotPart() {
        return true;
    }

    @Override
    void valuesSet() {
        if (noise != null) {
            noise.setOwner(this);
        }
    }

    public Noise getNoise() {
        return noise;
    }

    /** @param newNoise the error model, whose later changes are saved too; null for none */
    public void setNoise(Noise newNoise) {
        checkChangeable();
        if (noise != null) {
            noise.setOwner(null);
        }
        noise = newNoise;
        if (newNoise != null) {
            newNoise.setOwner(this);
        }
        changed();
    }
}
