package org.SEAR.terrain.relief;

/**
 * How much light a slope gets from a sun that is infinitely far away: Lambert's cosine of the angle between the sun and the normal of the ground, 0
 * where it looks away. Immutable, any thread.
 */
public final class HillShade {
    private final double north;
    private final double up;
    private final double east;

    /**
     * @param azimuth where the sun stands, degrees clockwise from north
     * @param altitude degrees above the horizon
     */
    public HillShade(double azimuth, double altitude) {
        double level = Math.cos(Math.toRadians(altitude));
        north = level * Math.cos(Math.toRadians(azimuth));
        east = level * Math.sin(Math.toRadians(azimuth));
        up = Math.sin(Math.toRadians(altitude));
    }

    /**
     * The share of full light, 0 to 1.
     *
     * @param slopeNorth metres up for a metre north, likewise slopeEast
     */
    public double at(double slopeNorth, double slopeEast) {
        double cosine = (up - slopeNorth * north - slopeEast * east) / Math.sqrt(1 + slopeNorth * slopeNorth + slopeEast * slopeEast);
        return Math.max(0, cosine);
    }
}
