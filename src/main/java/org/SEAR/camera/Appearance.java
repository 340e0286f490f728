// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Appearance of one shape to cameras: its normals, its picture or colour, and its temperature. Immutable, any thread.
 */
public abstract class Appearance {
    /** Temperature of the sky, degrees Celsius. */
    static final double SKY_TEMPERATURE = -20;

    /** Temperature, degrees Celsius. */
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

    /** Returns whether it casts a shadow. The ground does not. */
    public final boolean isCasting() {
        return casting;
    }

    /** Returns whether the light of sun and sky is computed; false for a picture that contains the light. */
    boolean isLit() {
        return true;
    }

    /** Sets the normal of a hit whose position and triangle are known. */
    protected abstract void normal(SurfaceHit spot);

    /** Sets the shading normal, if it differs from the surface normal. */
    void shade(SurfaceHit spot) {
    }

    /** Sets the colour of a hit whose other values are known. */
    protected abstract void color(SurfaceHit spot);
}
