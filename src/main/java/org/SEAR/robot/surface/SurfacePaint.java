// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.surface;

/** Colours on the surface of one object. Simulation thread. */
interface SurfacePaint {
    /**
     * Returns the colour at a point of the surface.
     * @param point {x, y, z} in the solid's frame, metres
     * @return 0xRRGGBB
     */
    int at(double[] point);
}
