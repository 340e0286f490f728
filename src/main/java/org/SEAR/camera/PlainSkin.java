package org.SEAR.camera;

/** Of what nothing is known: one colour, seen as if it looked to the eye. Immutable, any thread. */
public final class PlainSkin extends Skin {
    private final int color;

    /** @param color 0xRRGGBB */
    public PlainSkin(int color, double temperature) {
        super(temperature, true);
        this.color = color;
    }

    @Override
    protected void normal(Spot s) {
        s.setNormal(-s.dx, -s.dy, -s.dz);
    }

    @Override
    protected void color(Spot s) {
        s.setColor(color);
    }
}
