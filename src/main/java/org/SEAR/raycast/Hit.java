package org.SEAR.raycast;

/** What a beam met. Mutable so that casting allocates nothing; belongs to the caller. */
public final class Hit {
    /** Number of the shape in its scene, or -1. */
    public int shape = -1;
    /** Metres from the beam's origin. */
    public double distance;
    /** Outward unit normal of the surface, world frame. */
    public double nx;
    public double ny;
    public double nz;
}
