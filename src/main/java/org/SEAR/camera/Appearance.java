package org.SEAR.camera;

/** What is seen of one shape: its normals, its picture or colour, how warm it is. Immutable, any thread. */
public abstract class Appearance {
    /** How warm everything is that has no temperature of its own, and the sky, degrees Celsius. */
    static final double SKY_TEMPERATURE = -20;

    /** Degrees Celsius. */
    final double temperature;
    private final boolean casting;

    /**
     * @param temperature degrees Celsius
     * @param casting whether it casts a shadow
     */
    protected Appearance(double temperature, boolean casting) {
        this.temperature = temperature;
        this.casting = casting;
    }

    /** Whether it casts a shadow: the ground doesn't. */
    public final boolean isCasting() {
        return casting;
    }

    /** Whether the sun and the sky are to be reckoned; false for a picture with the light in it. */
    boolean isLit() {
        return true;
    }

    /** Sets the normal of a spot's plane, of which the place and the part are known. */
    protected abstract void normal(SurfaceHit spot);

    /** Sets the normal that counts for the light, if it is another than the plane's. */
    void shade(SurfaceHit spot) {
    }

    /** Sets the colour of a spot, of which all else is known. */
    protected abstract void color(SurfaceHit spot);
}
