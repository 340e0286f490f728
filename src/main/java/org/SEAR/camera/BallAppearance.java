// SPDX-License-Identifier: Apache-2.0
package org.SEAR.camera;

/**
 * Appearance of a sphere or an ellipsoid. The picture goes around it once, from +z counter-clockwise seen from above,
 * with its lower edge at the lowest point. Immutable, any thread.
 */
public final class BallAppearance extends Appearance {
    private final double a;
    private final double b;
    private final double c;
    private final Paint paint;

    /** @param half half extents along x, y and z, metres */
    public BallAppearance(double[] half, Paint paint, double temperature) {
        super(temperature, true);
        a = half[0];
        b = half[1];
        c = half[2];
        this.paint = paint;
    }

    @Override
    protected void normal(SurfaceHit s) {
        s.setNormal(s.x / (a * a), s.y / (b * b), s.z / (c * c));
    }

    @Override
    protected void color(SurfaceHit s) {
        if (paint.isPlain()) {
            paint.look(0, 0, 0, 0, 0, 0, s);
            return;
        }
        double x = s.x / a;
        double y = Math.max(-1, Math.min(1, s.y / b));
        double z = s.z / c;
        double level = Math.max(1e-12, x * x + z * z);
        double around = 1 / (2 * Math.PI * level);
        double up = 1 / (Math.PI * Math.sqrt(level) * b);
        double turn = StrictMath.atan2(x, z) / (2 * Math.PI);
        paint.look(turn < 0 ? turn + 1 : turn, StrictMath.acos(-y) / Math.PI,
            around * (z * s.rightX / a - x * s.rightZ / c), up * s.rightY,
            around * (z * s.downX / a - x * s.downZ / c), up * s.downY, s);
    }
}
