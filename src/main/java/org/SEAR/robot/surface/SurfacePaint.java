package org.SEAR.robot.surface;

/** What is on the surface of one thing. Simulation thread. */
interface SurfacePaint {
    /**
     * The colour at a point of the surface.
     *
     * @param point {x, y, z} in the frame of the thing's solid, metres
     * @return 0xRRGGBB
     */
    int at(double[] point);
}
