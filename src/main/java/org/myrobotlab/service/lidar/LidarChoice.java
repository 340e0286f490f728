// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

/** A scanner model and its options, for selection in a panel. JSON-friendly; callers must not change the arrays. */
public final class LidarChoice {
    /** Name for {@code setModel}. */
    public final String name;
    /** Legal baud rates; the first is the rate at power-on. */
    public final int[] bauds;
    /** Common spreads and resolutions, degrees, for {@code setScanMode}. */
    public final double[][] modes;
    /** Whether the model can also measure in centimetres. */
    public final boolean centimetres;

    LidarChoice(String name, int[] bauds, double[][] modes, boolean centimetres) {
        this.name = name;
        this.bauds = bauds;
        this.modes = modes;
        this.centimetres = centimetres;
    }
}
