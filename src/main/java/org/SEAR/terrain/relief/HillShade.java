// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain.relief;

/**
 * Light on a slope from an infinitely distant sun: Lambert's cosine of the angle between sun and surface normal, 0 if
 * the slope faces away. Immutable, any thread.
 */
public final class HillShade {
    private final double north;
    private final double up;
    private final double east;

    /**
     * @param azimuth direction of the sun, degrees clockwise from north
     * @param altitude degrees above the horizon
     */
    public HillShade(double azimuth, double altitude) {
        double level = Math.cos(Math.toRadians(altitude));
        north = level * Math.cos(Math.toRadians(azimuth));
        east = level * Math.sin(Math.toRadians(azimuth));
        up = Math.sin(Math.toRadians(altitude));
    }

    /**
     * Returns the share of full light, 0 to 1.
     * @param slopeNorth rise per metre to the north, metres, likewise slopeEast
     */
    public double at(double slopeNorth, double slopeEast) {
        double cosine = (up - slopeNorth * north - slopeEast * east) / Math.sqrt(
            1 + slopeNorth * slopeNorth + slopeEast * slopeEast);
        return Math.max(0, cosine);
    }
}
