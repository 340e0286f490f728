// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices;

/** A light of a robot, for firmware and scripts. Simulation thread only. */
public interface LightHardware {
    /** Name of its object. */
    String getName();

    /**
     * Sets the brightness until the next command.
     *
     * @param brightness 0 (dark) to 1
     * @throws IllegalArgumentException that names the light, the value and the legal range
     */
    void setBrightness(double brightness);

    /** Brightness, 0 to 1. */
    double getBrightness();
}
