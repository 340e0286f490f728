package org.myrobotlab.service.lidar;

/** A model as people choose it. JSON-friendly; nobody changes the arrays. */
public final class LidarChoice {
    /** For {@code setModel}. */
    public final String name;
    /** The rates of its line, bits a second, that at power-on first. */
    public final int[] bauds;
    /** Common spreads and resolutions, degrees, for {@code setScanMode}. */
    public final double[][] modes;
    /** Whether it can measure in centimetres, too. */
    public final boolean centimetres;

    LidarChoice(String name, int[] bauds, double[][] modes, boolean centimetres) {
        this.name = name;
        this.bauds = bauds;
        this.modes = modes;
        this.centimetres = centimetres;
    }
}
