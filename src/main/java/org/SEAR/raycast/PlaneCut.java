// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

/**
 * A fan's plane seen from another frame. Maps a point to its height above the plane and its coordinates in the fan's
 * frame, x to the left and z ahead; all three are linear. For a box, computes a rectangle around its intersection with
 * the plane, facing the fan's origin. Tolerances ensure that no box with a corner on the plane is missed.
 */
final class PlaneCut {
    /** Tolerance, many times the relative error of the three functions. */
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

    /** Centre of the last {@link #intersects} box in the fan's frame, and its distance, metres. */
    double left;
    double ahead;
    double distance;
    /** Half width of that box across the line of sight to its centre, and the distance where it begins, metres. */
    double wide;
    double nearest;

    private double slack;
    private double range;

    /**
     * Computes the tolerances. Call after setting the coefficients.
     * @param farX maximum absolute x of any later point, metres, likewise farY and farZ
     * @param maxRange range of the fan, metres
     */
    void ready(double farX, double farY, double farZ, double maxRange) {
        slack = ROUNDING * ((Math.abs(ha) + Math.abs(xa) + Math.abs(za)) * farX
            + (Math.abs(hb) + Math.abs(xb) + Math.abs(zb)) * farY
            + (Math.abs(hc) + Math.abs(xc) + Math.abs(zc)) * farZ + Math.abs(hd) + Math.abs(xd) + Math.abs(zd));
        range = maxRange;
    }

    /** Returns whether the plane intersects a node of a hierarchy within the range. Computes the rectangle if so. */
    boolean intersects(float[] box, int at) {
        double x = box[at];
        double y = box[at + 1];
        double z = box[at + 2];
        double halfX = (box[at + 3] - x) * 0.5;
        double halfY = (box[at + 4] - y) * 0.5;
        double halfZ = (box[at + 5] - z) * 0.5;
        return intersects(x + halfX, y + halfY, z + halfZ, halfX, halfY, halfZ);
    }

    /** The same for a box with this centre and these half sizes. */
    boolean intersects(double x, double y, double z, double halfX, double halfY, double halfZ) {
        if (!(Math.abs(height(x, y, z)) <= Math.abs(ha) * halfX + Math.abs(hb) * halfY
            + Math.abs(hc) * halfZ + slack)) {
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
