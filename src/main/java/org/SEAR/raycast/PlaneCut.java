package org.SEAR.raycast;

/**
 * The plane of a fan as seen from some frame: of each point its height above the plane and its two coordinates in the fan's frame, x to the left and
 * z ahead. All three are linear in the point, rise or fall with each of its coordinates, and so are rounded the same way for a point and for the
 * corner of a box around it.
 */
final class PlaneCut {
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

    /** Offsets of the box corner where each function is greatest. */
    private int hx;
    private int hy;
    private int hz;
    private int xx;
    private int xy;
    private int xz;
    private int zx;
    private int zy;
    private int zz;

    /** To be called once the coefficients are set. */
    void ready() {
        hx = ha >= 0 ? 3 : 0;
        hy = hb >= 0 ? 4 : 1;
        hz = hc >= 0 ? 5 : 2;
        xx = xa >= 0 ? 3 : 0;
        xy = xb >= 0 ? 4 : 1;
        xz = xc >= 0 ? 5 : 2;
        zx = za >= 0 ? 3 : 0;
        zy = zb >= 0 ? 4 : 1;
        zz = zc >= 0 ? 5 : 2;
    }

    /** Whether the plane meets a box of six floats; if so, computes the rectangle. */
    boolean meets(float[] box, int at) {
        if (ha * box[at + hx] + hb * box[at + hy] + hc * box[at + hz] + hd < 0
            || ha * box[at + 3 - hx] + hb * box[at + 5 - hy] + hc * box[at + 7 - hz] + hd > 0) {
            return false;
        }
        maxX = xa * box[at + xx] + xb * box[at + xy] + xc * box[at + xz] + xd;
        minX = xa * box[at + 3 - xx] + xb * box[at + 5 - xy] + xc * box[at + 7 - xz] + xd;
        maxZ = za * box[at + zx] + zb * box[at + zy] + zc * box[at + zz] + zd;
        minZ = za * box[at + 3 - zx] + zb * box[at + 5 - zy] + zc * box[at + 7 - zz] + zd;
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
