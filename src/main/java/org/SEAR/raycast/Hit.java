// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

/** Hit of a ray. Mutable so that casting allocates nothing; belongs to the caller. */
public final class Hit {
    /** Number of the shape in its scene, or -1. */
    public int shape = -1;
    /** Distance from the ray's origin, metres. */
    public double distance;
    /** Outward unit normal of the surface in the world frame. */
    public double nx;
    public double ny;
    public double nz;
}
