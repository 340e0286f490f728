package org.SEAR.raycast;

/**
 * The plane of a fan as seen from some frame: of each point its height above the plane and its two coordinates in the fan's frame, x to the left and
 * z ahead. All three are linear in the point. Of a box it tells the rectangle around its part of the plane that looks at the fan's origin, with some
 * slack for the rounding, so that no box is left out whose corner lies on the plane.
 */
final class PlaneCut {
    /** Relative error of the three functions, many times over. */
    private static final double ROUNDING = 1e-14;

    /** Coefficients of height, x and z: three factors and a constant each. */
    double ha;
    double hb;
    double hc;
    double hd;
    double xa;
    double xb;
    double xc;
    double xd;
    double za;
    double zb;
    double zc;
    double zd;

    /** The middle of the last {@link #intersects} box, as the fan sees it ... */
    double left;
    double ahead;
    double distance;
    /** ... how far its part of the plane reaches to either side of the way there, and where along that way it begins. */
    double wide;
    double nearest;

    private double slack;
    private double range;

    /**
     * To be called once the coefficients are set.
     *
     * @param farX the greatest absolute x of anything that will be asked for, likewise farY and farZ
     * @param maxRange how far the fan reaches
     */
    void ready(double farX, double farY, double farZ, double maxRange) {
        slack = ROUNDING * ((Math.abs(ha) + Math.abs(xa) + Math.abs(za)) * farX + (Math.abs(hb) + Math.abs(xb) + Math.abs(zb)) * farY
            + (Math.abs(hc) + Math.abs(xc) + Math.abs(zc)) * farZ + Math.abs(hd) + Math.abs(xd) + Math.abs(zd));
        range = maxRange;
    }

    /** Whether the plane meets a node of a hierarchy within the range; if so, computes the rectangle. */
    boolean intersects(float[] box, int at) {
        double x = box[at];
        double y = box[at + 1];
        double z = box[at + 2];
        double halfX = (box[at + 3] - x) * 0.5;
        double halfY = (box[at + 4] - y) * 0.5;
        double halfZ = (box[at + 5] - z) * 0.5;
        return intersects(x + halfX, y + halfY, z + halfZ, halfX, halfY, halfZ);
    }

    /** The same for a box with this middle and these half sizes. */
    boolean intersects(double x, double y, double z, double halfX, double halfY, double halfZ) {
        if (!(Math.abs(height(x, y, z)) <= Math.abs(ha) * halfX + Math.abs(hb) * halfY + Math.abs(hc) * halfZ + slack)) {
            return false;
        }
        left = x(x, y, z);
        ahead = z(x, y, z);
        distance = Math.sqrt(left * left + ahead * ahead);
        double inverse = 1 / distance;
        double toLeft = left * inverse;
        double toAhead = ahead * inverse;
        wide = Math.abs(xa * toAhead - za * toLeft) * halfX + Math.abs(xb * toAhead - zb * toLeft) * halfY
            + Math.abs(xc * toAhead - zc * toLeft) * halfZ + slack;
        nearest = distance - Math.abs(xa * toLeft + za * toAhead) * halfX - Math.abs(xb * toLeft + zb * toAhead) * halfY
            - Math.abs(xc * toLeft + zc * toAhead) * halfZ - slack;
        return !(nearest > range);
    }

    double height(double x, double y, double z) {
        return ha * x + hb * y + hc * z + hd;
    }

    double x(double x, double y, double z) {
        return xa * x + xb * y + xc * z + xd;
    }

    double z(double x, double y, double z) {
        return za * x + zb * y + zc * z + zd;
    }
}
