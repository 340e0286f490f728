package org.SEAR.devices;

/** A light of a robot as firmware and scripts see it. Simulation thread only. */
public interface LightHardware {
    /** Its name, as that of its object. */
    String getName();

    /**
     * Has it shine until the next command.
     *
     * @param brightness 0 (dark) to 1
     * @throws IllegalArgumentException that names the light, the value and the legal range
     */
    void setBrightness(double brightness);

    /** How bright it shines, 0 to 1. */
    double getBrightness();
}
