// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Appearance of a cylinder or a cone about its y axis, with circular or elliptic ends. One picture goes around its
 * side, from +z counter-clockwise seen from above, another covers each cap. A wheel has spokes on its caps. Immutable,
 * any thread.
 */
public final class RoundAppearance extends Appearance {
    /** Distance from a cap, as a share of the height, below which a position is on the cap. */
    private static final double ON_CAP = 1e-9;
    /** Half width and half length of a wheel's spoke, as shares of its radius. */
    private static final double SPOKE_WIDE = 0.18;
    private static final double SPOKE_LONG = 0.85;

    private final double a;
    private final double h;
    private final double c;
    private final boolean cone;
    private final Paint paint;
    private final Paint spoke;

    /**
     * @param half half extents along x, y and z, metres
     * @param spoke paint of a wheel's spokes; null for none
     */
    public RoundAppearance(double[] half, boolean cone, Paint paint, Paint spoke, double temperature) {
        super(temperature, true);
        a = half[0];
        h = half[1];
        c = half[2];
        this.cone = cone;
        this.paint = paint;
        this.spoke = spoke;
    }

    /** Returns 1 for a position on the upper cap, -1 on the lower one, 0 on the side. */
    private int cap(SurfaceHit s) {
        double edge = h * (1 - ON_CAP);
        double x = s.x / a;
        double z = s.z / c;
        if (s.y <= -edge) {
            return -1;
        }
        return !cone && s.y >= edge && x * x + z * z < 1 ? 1 : 0;
    }

    @Override
    protected void normal(SurfaceHit s) {
        int cap = cap(s);
        if (cap != 0) {
            s.nx = 0;
            s.ny = cap;
            s.nz = 0;
            return;
        }
        double x = s.x / a;
        double z = s.z / c;
        double around = Math.sqrt(x * x + z * z);
        if (around == 0) {
            s.setNormal(0, 1, 0);
        } else {
            s.setNormal(x / around / a, cone ? 1 / (2 * h) : 0, z / around / c);
        }
    }

    @Override
    protected void color(SurfaceHit s) {
        int cap = cap(s);
        if (cap != 0 && spoke != null && Math.abs(s.x) <= SPOKE_WIDE * a && Math.abs(s.z) <= SPOKE_LONG * c) {
            spoke.look(0, 0, 0, 0, 0, 0, s);
        } else if (paint.isPlain()) {
            paint.look(0, 0, 0, 0, 0, 0, s);
        } else if (cap != 0) {
            paint.look(0.5 + s.x / a / 2, 0.5 - cap * s.z / c / 2, s.rightX / a / 2, -cap * s.rightZ / c / 2,
                s.downX / a / 2, -cap * s.downZ / c / 2, s);
        } else {
            double x = s.x / a;
            double z = s.z / c;
            double scale = 1 / (2 * Math.PI * Math.max(1e-12, x * x + z * z));
            double turn = StrictMath.atan2(x, z) / (2 * Math.PI);
            paint.look(turn < 0 ? turn + 1 : turn, (s.y + h) / (2 * h), scale * (z * s.rightX / a - x * s.rightZ / c),
                s.rightY / (2 * h), scale * (z * s.downX / a - x * s.downZ / c), s.downY / (2 * h), s);
        }
    }
}
