// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/** Appearance of an unknown shape: one colour, lit as if it faced the camera. Immutable, any thread. */
public final class PlainAppearance extends Appearance {
    private final int color;

    /** @param color 0xRRGGBB */
    public PlainAppearance(int color, double temperature) {
        super(temperature, true);
        this.color = color;
    }

    @Override
    protected void normal(SurfaceHit s) {
        s.setNormal(-s.dx, -s.dy, -s.dz);
    }

    @Override
    protected void color(SurfaceHit s) {
        s.setColor(color);
    }
}
