package org.SEAR.geometry;

/**
 * Where a frame stands in the world, as a rotation matrix (world = R * own) and a position in metres, set in place for each step. Not for several
 * threads at once.
 */
public final class Placement {
    public double m00 = 1;
    public double m01;
    public double m02;
    public double m10;
    public double m11 = 1;
    public double m12;
    public double m20;
    public double m21;
    public double m22 = 1;
    public double x;
    public double y;
    public double z;

    /**
     * The point (px, py, pz) of the frame in the world.
     *
     * @param into takes {x, y, z}, metres, from {@code at} on
     */
    public void transform(double px, double py, double pz, double[] into, int at) {
        into[at] = x + m00 * px + m01 * py + m02 * pz;
        into[at + 1] = y + m10 * px + m11 * py + m12 * pz;
        into[at + 2] = z + m20 * px + m21 * py + m22 * pz;
    }
}
