// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

/** Colour ramp: linear between stops in ascending order; red, green and blue from 0 to 1. Immutable, any thread. */
public final class ColorRamp {
    private final float[][] stops;

    /** @param stops {position, red, green, blue} each, positions ascending */
    public ColorRamp(float[]... stops) {
        this.stops = stops;
    }

    /**
     * Writes the colour at a position; clamps to the first and last stop.
     * @param into receives red, green and blue
     */
    public void at(double place, float[] into) {
        int next = 1;
        while (next < stops.length - 1 && place > stops[next][0]) {
            next++;
        }
        float[] low = stops[next - 1];
        float[] high = stops[next];
        float share = (float) Math.max(0, Math.min(1, (place - low[0]) / (high[0] - low[0])));
        for (int i = 0; i < 3; i++) {
            into[i] = low[i + 1] + share * (high[i + 1] - low[i + 1]);
        }
    }
}
