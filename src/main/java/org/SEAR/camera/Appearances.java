package org.SEAR.camera;

/** The skins of a scene. Simulation thread. */
public interface Appearances {
    /** The skin of a shape of the scene; never null. */
    Appearance of(int shape);
}
