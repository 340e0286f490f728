// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Inertia tensor about one point, kg m^2, as a symmetric matrix in some frame. The elements off the diagonal are the
 * negative products of inertia: {@code xy} is minus the integral of x y over the mass. Immutable, any thread.
 */
public final class InertiaTensor {
    /** Tensor of a body that does not rotate. */
    public static final InertiaTensor ZERO = new InertiaTensor(0, 0, 0);

    public final double xx;
    public final double yy;
    public final double zz;
    public final double xy;
    public final double xz;
    public final double yz;

    /** Tensor in the frame of the principal axes. */
    public InertiaTensor(double xx, double yy, double zz) {
        this(xx, yy, zz, 0, 0, 0);
    }

    public InertiaTensor(double xx, double yy, double zz, double xy, double xz, double yz) {
        this.xx = xx;
        this.yy = yy;
        this.zz = zz;
        this.xy = xy;
        this.xz = xz;
        this.yz = yz;
    }

    /** Returns the tensor of a body with the same shape and another mass. */
    public InertiaTensor times(double factor) {
        return new InertiaTensor(factor * xx, factor * yy, factor * zz, factor * xy, factor * xz, factor * yz);
    }

    /** Returns the tensor of two bodies together, about the same point in the same frame. */
    public InertiaTensor plus(InertiaTensor other) {
        return new InertiaTensor(xx + other.xx, yy + other.yy, zz + other.zz, xy + other.xy, xz + other.xz,
            yz + other.yz);
    }

    /**
     * Returns the tensor about a point off the centre of mass (parallel axis theorem); this one is about the centre.
     * @param mass kg
     * @param x displacement of the point, metres, likewise y and z
     */
    public InertiaTensor displaced(double mass, double x, double y, double z) {
        return plus(new InertiaTensor(mass * (y * y + z * z), mass * (x * x + z * z), mass * (x * x + y * y),
            -mass * x * y, -mass * x * z, -mass * y * z));
    }

    /**
     * Returns the tensor about the same point in the parent frame.
     * @param frame of this tensor in its parent; only its rotation counts
     */
    public InertiaTensor inParent(Pose frame) {
        if (frame.qx == 0 && frame.qy == 0 && frame.qz == 0) {
            return this;
        }
        double[] x = frame.rotateBack(1, 0, 0);
        double[] y = frame.rotateBack(0, 1, 0);
        double[] z = frame.rotateBack(0, 0, 1);
        return new InertiaTensor(product(x, x), product(y, y), product(z, z), product(x, y), product(x, z),
            product(y, z));
    }

    private double product(double[] u, double[] v) {
        return u[0] * (xx * v[0] + xy * v[1] + xz * v[2]) + u[1] * (xy * v[0] + yy * v[1] + yz * v[2])
            + u[2] * (xz * v[0] + yz * v[1] + zz * v[2]);
    }

    /** Returns the moment of inertia about an axis through the same point, kg m^2; (x, y, z) is its unit direction. */
    public double about(double x, double y, double z) {
        double[] axis = {x, y, z};
        return product(axis, axis);
    }

    /** Returns the rows of the matrix. */
    public double[][] toRows() {
        return new double[][] {{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}};
    }
}
