package org.SEAR.raycast;

import org.SEAR.raycast.tree.Bvh;

/**
 * The plane of a fan as seen from some frame: of each point its height above the plane and its two coordinates in the fan's frame, x to the left and
 * z ahead. All three are linear in the point. Boxes are looked at by their centre and half sizes, with some slack for the rounding, so that no box
 * is left out whose corner lies on the plane.
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

    /** The rectangle around the part of the last {@link #meets} box, in the fan's frame. */
    double minX;
    double maxX;
    double minZ;
    double maxZ;

    /** What a box's half sizes contribute: half of the absolute factors. */
    private double reachHa;
    private double reachHb;
    private double reachHc;
    private double reachXa;
    private double reachXb;
    private double reachXc;
    private double reachZa;
    private double reachZb;
    private double reachZc;
    /** More than the rounding of each function at any point of the hierarchy. */
    private double slackH;
    private double slackX;
    private double slackZ;

    /**
     * To be called once the coefficients are set.
     *
     * @param tree whose nodes will be asked for
     */
    void ready(Bvh tree) {
        reachHa = Math.abs(ha) / 2;
        reachHb = Math.abs(hb) / 2;
        reachHc = Math.abs(hc) / 2;
        reachXa = Math.abs(xa) / 2;
        reachXb = Math.abs(xb) / 2;
        reachXc = Math.abs(xc) / 2;
        reachZa = Math.abs(za) / 2;
        reachZb = Math.abs(zb) / 2;
        reachZc = Math.abs(zc) / 2;
        double x = tree.farthest(0);
        double y = tree.farthest(1);
        double z = tree.farthest(2);
        slackH = ROUNDING * (reachHa * x + reachHb * y + reachHc * z + Math.abs(hd));
        slackX = ROUNDING * (reachXa * x + reachXb * y + reachXc * z + Math.abs(xd));
        slackZ = ROUNDING * (reachZa * x + reachZb * y + reachZc * z + Math.abs(zd));
    }

    /** Whether the plane meets a box of six floats; if so, computes the rectangle. */
    boolean meets(float[] box, int at) {
        double lowX = box[at];
        double lowY = box[at + 1];
        double lowZ = box[at + 2];
        double x = box[at + 3] + lowX;
        double y = box[at + 4] + lowY;
        double z = box[at + 5] + lowZ;
        double sizeX = x - 2 * lowX;
        double sizeY = y - 2 * lowY;
        double sizeZ = z - 2 * lowZ;
        double height = (ha * x + hb * y + hc * z) * 0.5 + hd;
        if (Math.abs(height) > reachHa * sizeX + reachHb * sizeY + reachHc * sizeZ + slackH) {
            return false;
        }
        double reach = reachXa * sizeX + reachXb * sizeY + reachXc * sizeZ + slackX;
        double middle = (xa * x + xb * y + xc * z) * 0.5 + xd;
        maxX = middle + reach;
        minX = middle - reach;
        reach = reachZa * sizeX + reachZb * sizeY + reachZc * sizeZ + slackZ;
        middle = (za * x + zb * y + zc * z) * 0.5 + zd;
        maxZ = middle + reach;
        minZ = middle - reach;
        return true;
    }

    /** Squared distance of the rectangle from the fan's origin. */
    double distanceSquared() {
        double x = minX > 0 ? minX : maxX < 0 ? maxX : 0;
        double z = minZ > 0 ? minZ : maxZ < 0 ? maxZ : 0;
        return x * x + z * z;
    }

    /** Four times the squared distance of the rectangle's centre. */
    double centreDistance() {
        double x = minX + maxX;
        double z = minZ + maxZ;
        return x * x + z * z;
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
