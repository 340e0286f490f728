// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import java.util.Locale;
import org.SEAR.grammar.Described;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.ParameterTable;

/**
 * Centre of mass and inertia tensor of a robot, in its body frame, instead of those of its components. Immutable, any
 * thread.
 */
@Described("centre of mass and inertia tensor of a robot in its body frame, instead of those of its components")
public final class Inertia {
    private static final double MOST = 1e12;
    private static final double FAR = 1000;

    @Param(doc = "centre of mass", unit = "m", min = -FAR, max = FAR)
    private double x;
    @Param(doc = "centre of mass", unit = "m", min = -FAR, max = FAR)
    private double y;
    @Param(doc = "centre of mass", unit = "m", min = -FAR, max = FAR)
    private double z;
    @Param(doc = "moment of inertia about an axis through the centre of mass", unit = "kg m^2", min = 1e-12, max = MOST,
        required = true)
    private double xx;
    @Param(doc = "moment of inertia about an axis through the centre of mass", unit = "kg m^2", min = 1e-12, max = MOST,
        required = true)
    private double yy;
    @Param(doc = "moment of inertia about an axis through the centre of mass", unit = "kg m^2", min = 1e-12, max = MOST,
        required = true)
    private double zz;
    @Param(doc = "element of the tensor: minus the product of inertia", unit = "kg m^2", min = -MOST, max = MOST)
    private double xy;
    @Param(doc = "element of the tensor: minus the product of inertia", unit = "kg m^2", min = -MOST, max = MOST)
    private double xz;
    @Param(doc = "element of the tensor: minus the product of inertia", unit = "kg m^2", min = -MOST, max = MOST)
    private double yz;

    /** For reading from a file. */
    Inertia() {
    }

    /**
     * With all parameters.
     *
     * @param x of the centre of mass, metres, likewise y and z
     * @param xx element of the tensor about the centre of mass, kg m^2, likewise the others
     */
    public Inertia(double x, double y, double z, double xx, double yy, double zz, double xy, double xz, double yz) {
        this.x = checked("x", x);
        this.y = checked("y", y);
        this.z = checked("z", z);
        this.xx = checked("xx", xx);
        this.yy = checked("yy", yy);
        this.zz = checked("zz", zz);
        this.xy = checked("xy", xy);
        this.xz = checked("xz", xz);
        this.yz = checked("yz", yz);
        if (!isPositive()) {
            throw new IllegalArgumentException("Inertia: the tensor has a negative or no principal moment, legal: "
                + "positive ones");
        }
    }

    /** Returns whether all principal moments are positive (Sylvester's criterion). */
    boolean isPositive() {
        return xx > 0 && xx * yy > xy * xy
            && xx * (yy * zz - yz * yz) - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz) > 0;
    }

    private static double checked(String element, double value) {
        Parameter parameter = ParameterTable.of(Inertia.class).get(element);
        if (!parameter.isLegal(value)) {
            throw new IllegalArgumentException(String.format(Locale.ROOT, "Inertia: %s is %s, legal: %s", element,
                Parameter.format(value), parameter.legal()));
        }
        return value + 0.0;
    }

    public double getX() {
        return x;
    }

    public double getY() {
        return y;
    }

    public double getZ() {
        return z;
    }

    public double getXx() {
        return xx;
    }

    public double getYy() {
        return yy;
    }

    public double getZz() {
        return zz;
    }

    public double getXy() {
        return xy;
    }

    public double getXz() {
        return xz;
    }

    public double getYz() {
        return yz;
    }
}
