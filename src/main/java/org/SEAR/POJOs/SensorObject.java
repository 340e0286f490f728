package org.SEAR.POJOs;

import org.SEAR.grammar.Param;

/** A sensor's parameters. A sensor is a component of a robot; without rotation it looks forward. */
public abstract class SensorObject extends SearObject {
    @Param(doc = "error model; none by default")
    private Noise noise;

    /** For reading from a file. */
    protected SensorObject() {
    }

    /** @param name by which scripts ask for its readings */
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

    /** The error model; null for none. */
    public Noise getNoise() {
        return noise;
    }

    /** @param newNoise the error model; later changes to it are saved too; null for none */
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
