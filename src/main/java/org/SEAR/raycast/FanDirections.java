package org.SEAR.raycast;

/**
 * The directions of a fan's beams in its own plane: beam i points to (x[i], z[i]) = (sin a, cos a), a = start + i * step; angles grow to the left.
 */
final class FanDirections {
    /** Radians between two beams up to which the search by angle is safe. */
    private static final double GREATEST_STEP = 0.2;
    private static final double TURN = 2 * Math.PI;
    /** Radians; more than the error of {@link #angle}. */
    private static final double ERROR = 1e-5;
    /** Radians; many times that error. */
    private static final double MARGIN = 1e-3;
    /** By octant: 1 where |x| &lt; |z|, plus 2 where x &lt; 0, plus 4 where z &lt; 0: the angle is this many quarter turns ... */
    private static final double[] OCTANT_QUARTERS = {1, 0, 3, 4, 1, 2, 3, 2};
    /** ... and this times the angle to the nearer axis. */
    private static final double[] OCTANT_SIGN = {-1, 1, 1, -1, 1, -1, -1, 1};
    private static final double[] WRAP = {0, TURN};

    final int count;
    final double[] x;
    final double[] z;
    /** Whether {@link #first} can be used: angles grow in small steps through one turn at most. */
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

    /** Twice the area that a point spans with a beam: positive when the point is to the left of it. */
    double side(int beam, double px, double pz) {
        return z[beam] * px - x[beam] * pz;
    }

    /** The angle of a point, from the first beam to the left, radians in [0, 2 pi], to about 1e-5. Without branches, which would be guessed wrong. */
    double angle(double px, double pz) {
        double a = Math.abs(px);
        double b = Math.abs(pz);
        double q = Math.min(a, b) / Math.max(a, b);
        double s = q * q;
        double angle = (((((-0.01172120 * s + 0.05265332) * s - 0.11643287) * s + 0.19354346) * s - 0.33262347) * s + 0.99997726) * q;
        int octant = negative(a - b) + 2 * negative(px) + 4 * negative(pz);
        angle = base[octant] + OCTANT_SIGN[octant] * angle;
        return angle + WRAP[negative(angle)];
    }

    /** 1 for what has a minus, -0 included. */
    static int negative(double value) {
        return (int) (Double.doubleToRawLongBits(value) >>> 63);
    }

    /** The first beam at or to the left of a point, the number of beams where the point is outside of the fan. */
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

    /** The first of some beams at or to the left of a point, the one after the last where none is. They and the point lie within half a turn. */
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

    /** The first beam that may lie to the left of an angle in spite of its error. */
    int from(double angle) {
        double least = (angle - ERROR) * perStep;
        return least < 0 ? 0 : (int) least + 1;
    }

    /** The last beam that may lie to the right of an angle in spite of its error. */
    int to(double angle) {
        return Math.min(count - 1, (int) ((angle + ERROR) * perStep));
    }

    /** Whether nothing between the two angles touches the direction in which angles start. */
    static boolean inOneGo(double right, double left) {
        return right <= left && right > ERROR && left < TURN - ERROR;
    }
}
