package org.SEAR.camera;

/** The skins of a scene. Simulation thread. */
public interface Looks {
    /** The skin of a shape of the scene; never null. */
    Skin of(int shape);
}
