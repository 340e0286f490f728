// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/** A picture or a colour. Immutable, any thread. */
public final class Paint {
    private final Texture texture;
    private final int color;

    private Paint(Texture texture, int color) {
        this.texture = texture;
        this.color = color;
    }

    /** Returns a paint of one colour, 0xRRGGBB. */
    public static Paint of(int color) {
        return new Paint(null, color);
    }

    /** Returns a paint of a picture. */
    public static Paint of(Texture texture) {
        return new Paint(texture, 0);
    }

    /** Returns whether it is a colour, the same at all texture coordinates. */
    boolean isPlain() {
        return texture == null;
    }

    /** Sets the colour of a hit; see {@link Texture#look}. */
    void look(double u, double v, double ux, double vx, double uy, double vy, SurfaceHit spot) {
        if (texture == null) {
            spot.setColor(color);
        } else {
            texture.look(u, v, ux, vx, uy, vy, spot);
        }
    }
}
