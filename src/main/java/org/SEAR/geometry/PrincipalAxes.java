// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Principal axes of inertia: the frame in which the tensor is diagonal. Jacobi's method (Golub and Van Loan, "Matrix
 * Computations", section 8.5) rotates each plane by at most 45 degrees, so that axes of symmetry keep their names.
 * Immutable, any thread.
 */
public final class PrincipalAxes {
    /** Largest element off the diagonal, as a share of the trace, that counts as zero. */
    private static final double DIAGONAL = 1e-10;
    /** The same after the rotations. */
    private static final double EXACT = 1e-17;
    /** Sweeps over the three planes; convergence is quadratic, and four usually suffice. */
    private static final int SWEEPS = 20;

    /** Principal moments of inertia about the axes x, y and z of {@link #frame}, kg m^2. */
    public final double x;
    public final double y;
    public final double z;
    /** Principal axes in the tensor's frame: a rotation, {@link Pose#IDENTITY} if they are the frame's own axes. */
    public final Pose frame;

    private PrincipalAxes(double x, double y, double z, Pose frame) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.frame = frame;
    }

    public static PrincipalAxes of(InertiaTensor tensor) {
        double[][] a = tensor.toRows();
        double trace = a[0][0] + a[1][1] + a[2][2];
        Pose frame = Pose.IDENTITY;
        for (int sweep = 0; sweep < SWEEPS && off(a) > (sweep == 0 ? DIAGONAL : EXACT) * trace; sweep++) {
            for (int p = 0; p < 3; p++) {
                frame = frame.times(annihilate(a, p, (p + 1) % 3));
            }
        }
        return new PrincipalAxes(a[0][0], a[1][1], a[2][2], frame == Pose.IDENTITY ? frame : normalized(frame));
    }

    private static double off(double[][] a) {
        return Math.max(Math.abs(a[0][1]), Math.max(Math.abs(a[0][2]), Math.abs(a[1][2])));
    }

    /**
     * Makes one element zero by a rotation about the third axis.
     * @param a symmetric matrix, changed to the one in the rotated frame
     * @return the rotation
     */
    private static Pose annihilate(double[][] a, int p, int q) {
        int r = 3 - p - q;
        double angle = a[p][q] == 0 ? 0 : Math.atan(tangent(a[q][q] - a[p][p], 2 * a[p][q]));
        double c = Math.cos(angle);
        double s = Math.sin(angle);
        double shift = a[p][q] * Math.tan(angle);
        double rp = a[r][p];
        double rq = a[r][q];
        a[p][p] -= shift;
        a[q][q] += shift;
        a[p][q] = 0;
        a[q][p] = 0;
        a[r][p] = c * rp - s * rq;
        a[p][r] = a[r][p];
        a[r][q] = s * rp + c * rq;
        a[q][r] = a[r][q];
        double sine = -Math.sin(angle / 2);
        return new Pose(0, 0, 0, r == 0 ? sine : 0, r == 1 ? sine : 0, r == 2 ? sine : 0, Math.cos(angle / 2));
    }

    /** Returns the smaller root t of t^2 + 2 (above / below) t - 1, at most 1 in size. */
    private static double tangent(double above, double below) {
        double t = Math.abs(below) / (Math.abs(above) + Math.sqrt(above * above + below * below));
        return above * below < 0 ? -t : t;
    }

    private static Pose normalized(Pose pose) {
        double scale = 1 / Math.sqrt(pose.qx * pose.qx + pose.qy * pose.qy + pose.qz * pose.qz + pose.qw * pose.qw);
        return new Pose(0, 0, 0, pose.qx * scale, pose.qy * scale, pose.qz * scale, pose.qw * scale);
    }

    /** Returns the same axes with moments of at least {@code least} each, kg m^2. */
    public PrincipalAxes atLeast(double least) {
        return new PrincipalAxes(Math.max(x, least), Math.max(y, least), Math.max(z, least), frame);
    }
}
