// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

/**
 * Directions of a fan's rays in its own plane: ray i points to (x[i], z[i]) = (sin a, cos a), a = start + i * step.
 * Angles grow to the left.
 */
final class FanDirections {
    /** Maximum step between two rays for the search by angle, radians. */
    private static final double GREATEST_STEP = 0.2;
    private static final double TURN = 2 * Math.PI;
    /** Upper bound of the error of {@link #angle}, radians. */
    private static final double ERROR = 1e-5;
    /** Safety margin around the start direction, radians; many times {@link #ERROR}. */
    private static final double MARGIN = 1e-3;
    /** Quarter turns to add to the angle by octant: 1 if |x| &lt; |z|, plus 2 if x &lt; 0, plus 4 if z &lt; 0. */
    private static final double[] OCTANT_QUARTERS = {1, 0, 3, 4, 1, 2, 3, 2};
    /** Sign, by octant, of the angle to the nearer axis. */
    private static final double[] OCTANT_SIGN = {-1, 1, 1, -1, 1, -1, -1, 1};
    private static final double[] WRAP = {0, TURN};

    final int count;
    final double[] x;
    final double[] z;
    /** Whether {@link #first} is usable: angles grow in small steps through at most one turn. */
    final boolean regular;
    private final double start;
    private final double step;
    private final double[] base = new double[OCTANT_QUARTERS.length];
    private final double perStep;

    FanDirections(double start, double step, int count) {
        this.start = start;
        this.step = step;
        this.count = count;
        regular = step > 0 && step <= GREATEST_STEP && (count - 1) * step <= TURN * (1 + 1e-12);
        double origin = start - TURN * Math.floor(start / TURN);
        for (int octant = 0; octant < base.length; octant++) {
            base[octant] = OCTANT_QUARTERS[octant] * Math.PI / 2 - origin;
        }
        perStep = 1 / step;
        x = new double[count];
        z = new double[count];
        for (int i = 0; i < count; i++) {
            x[i] = Math.sin(start + i * step);
            z[i] = Math.cos(start + i * step);
        }
    }

    boolean is(double otherStart, double otherStep, int otherCount) {
        return start == otherStart && step == otherStep && count == otherCount;
    }

    /** Returns the cross product of a ray and a point: positive if the point is to the left of the ray. */
    double side(int beam, double px, double pz) {
        return z[beam] * px - x[beam] * pz;
    }

    /**
     * Returns the angle of a point from the first ray to the left, radians in [0, 2 pi], accurate to about 1e-5. Has no
     * branches, which would be mispredicted.
     */
    double angle(double px, double pz) {
        double a = Math.abs(px);
        double b = Math.abs(pz);
        double q = Math.min(a, b) / Math.max(a, b);
        double s = q * q;
        double angle = (((((-0.01172120 * s + 0.05265332) * s - 0.11643287) * s + 0.19354346) * s - 0.33262347) * s
            + 0.99997726) * q;
        int octant = negative(a - b) + 2 * negative(px) + 4 * negative(pz);
        angle = base[octant] + OCTANT_SIGN[octant] * angle;
        return angle + WRAP[negative(angle)];
    }

    /** Returns 1 for a set sign bit, including -0. */
    static int negative(double value) {
        return (int) (Double.doubleToRawLongBits(value) >>> 63);
    }

    /** Returns the first ray at or to the left of a point, or the number of rays if the point is outside the fan. */
    int first(double px, double pz) {
        double angle = angle(px, pz);
        if (angle > TURN - MARGIN && side(0, px, pz) >= 0) {
            angle = 0;
        } else if (angle < MARGIN && side(0, px, pz) < 0) {
            angle += TURN;
        }
        double guess = angle * perStep;
        if (guess > count + MARGIN * perStep) {
            return count;
        }
        int i = Math.min(count, (int) guess + 1);
        while (i > 0 && side(i - 1, px, pz) <= 0) {
            i--;
        }
        while (i < count && side(i, px, pz) > 0) {
            i++;
        }
        return i;
    }

    /**
     * Returns the first ray of a range at or to the left of a point, or the one after the range. Range and point span
     * less than half a turn.
     */
    int first(double px, double pz, int from, int to) {
        double right = side(from, px, pz);
        double guess = right / (right - side(to, px, pz)) * (to - from);
        int i = from + Math.max(0, Math.min((int) (guess + 1), to - from + 1));
        while (i > from && side(i - 1, px, pz) <= 0) {
            i--;
        }
        while (i <= to && side(i, px, pz) > 0) {
            i++;
        }
        return i;
    }

    /** Returns the first ray that may lie to the left of an angle, allowing for its error. */
    int from(double angle) {
        double least = (angle - ERROR) * perStep;
        return least < 0 ? 0 : (int) least + 1;
    }

    /** Returns the last ray that may lie to the right of an angle, allowing for its error. */
    int to(double angle) {
        return Math.min(count - 1, (int) ((angle + ERROR) * perStep));
    }

    /** Returns whether the interval of two angles excludes the direction where angles start. */
    static boolean inOneGo(double right, double left) {
        return right <= left && right > ERROR && left < TURN - ERROR;
    }
}
