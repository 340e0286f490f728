package org.SEAR.terrain.relief;

/** Colours along a line: stops in rising order, straight between them, red, green and blue from 0 to 1. Immutable, any thread. */
public final class ColorRamp {
    private final float[][] stops;

    /** @param stops each {place, red, green, blue}, places rising */
    public ColorRamp(float[]... stops) {
        this.stops = stops;
    }

    /**
     * The colour at a place; before the first stop that of the first, behind the last that of the last.
     *
     * @param into takes red, green and blue
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
