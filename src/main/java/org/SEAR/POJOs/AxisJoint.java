// SPDX-License-Identifier: Apache-2.0
package org.SEAR.POJOs;

import org.SEAR.grammar.Faults;
import org.SEAR.grammar.Param;
import org.SEAR.grammar.Parameter;
import org.SEAR.grammar.TextRule;

/**
 * A joint with one free direction: limits, friction, damper, spring and motor. Positions are degrees of a hinge and
 * metres of a slider or rope; forces are torques of a hinge.
 */
public abstract class AxisJoint extends Joint {
    private static final double MOST = 1e6;
    private static final double MOST_FORCE = 1e9;

    @Param(doc = "smallest position", unit = "deg or m", min = -MOST, max = MOST)
    private Double lower;
    @Param(doc = "greatest position", unit = "deg or m", min = -MOST, max = MOST)
    private Double upper;
    @Param(doc = "speed after a hit against a limit, as a share of the speed before", max = 1)
    private double restitution;
    @Param(doc = "dry friction, independent of the speed", unit = "N m or N", max = MOST_FORCE)
    private double friction;
    @Param(doc = "force of the damper per speed", unit = "N m s/rad or N s/m", max = MOST_FORCE)
    private double damping;
    @Param(doc = "rate of the spring; 0 for none", unit = "N m/rad or N/m", max = MOST_FORCE)
    private double stiffness;
    @Param(doc = "position at which the spring has no force", unit = "deg or m", min = -MOST, max = MOST)
    private double rest;
    @Param(doc = "force of the motor at standstill and full power; 0 for no motor", unit = "N m or N", max = MOST_FORCE)
    private double stallForce;
    @Param(doc = "speed of the motor at full power without load", unit = "deg/s or m/s", min = 1e-6, max = MOST_FORCE)
    private Double noLoadSpeed;
    @Param(doc = "name of another hinge, slider or rope whose position its own follows, by a gear; without it no gear",
        text = TextRule.NAME, names = AxisJoint.class)
    private String gear;
    @Param(doc = "change of its position per change of the position of the joint that it follows; 1 if missing",
        unit = "deg or m per deg or m", min = -MOST, max = MOST)
    private Double ratio;

    /** For reading from a file. */
    protected AxisJoint() {
    }

    /** @param first null for the world */
    protected AxisJoint(String name, SearObject first, SearObject second) {
        super(name, first, second);
    }

    /** Sets the limits during construction. */
    final void limit(Double newLower, Double newUpper) {
        lower = newLower;
        upper = newUpper;
    }

    @Override
    protected void crossCheck(Faults faults) {
        super.crossCheck(faults);
        if (getName() != null && getName().equals(gear)) {
            faults.add("gear", gear, "another joint than itself");
        }
        if (getRatio() == 0) {
            faults.add("ratio", ratio, "any number but 0");
        }
        if (lower != null && upper != null && lower > upper) {
            faults.add("lower", lower, "at most upper, which is " + Parameter.format(upper));
        }
    }

    /** Returns the smallest position; null without a limit. */
    public Double getLower() {
        return lower;
    }

    /** Returns the greatest position; null without a limit. */
    public Double getUpper() {
        return upper;
    }

    /** @param smallest degrees of a hinge, metres of a slider or rope, likewise {@code greatest} */
    public void setLimits(double smallest, double greatest) {
        double checkedLower = checked("lower", smallest);
        double checkedUpper = checked("upper", greatest);
        if (checkedLower > checkedUpper) {
            throw new IllegalArgumentException(label() + ": lower is " + Parameter.format(smallest)
                + ", legal: at most upper, which is " + Parameter.format(greatest));
        }
        lower = checkedLower;
        upper = checkedUpper;
        changed();
    }

    public double getRestitution() {
        return restitution;
    }

    /** @param share speed after a hit against a limit, as a share of the speed before, 0 to 1 */
    public void setRestitution(double share) {
        restitution = checked("restitution", share);
        changed();
    }

    public double getFriction() {
        return friction;
    }

    /** @param force dry friction, N; N m of a hinge */
    public void setFriction(double force) {
        friction = checked("friction", force);
        changed();
    }

    public double getDamping() {
        return damping;
    }

    /** @param rate force per speed, N s/m; N m s/rad of a hinge */
    public void setDamping(double rate) {
        damping = checked("damping", rate);
        changed();
    }

    public double getStiffness() {
        return stiffness;
    }

    public double getRest() {
        return rest;
    }

    /**
     * @param rate of the spring, N/m; N m/rad of a hinge; 0 for none
     * @param position without force, degrees of a hinge, metres of a slider or rope
     */
    public void setSpring(double rate, double position) {
        double checkedRate = checked("stiffness", rate);
        rest = checked("rest", position);
        stiffness = checkedRate;
        changed();
    }

    public double getStallForce() {
        return stallForce;
    }

    /** Returns degrees or metres a second; null if the motor's force does not depend on the speed. */
    public Double getNoLoadSpeed() {
        return noLoadSpeed;
    }

    /**
     * Adds a motor: force = force at standstill (power - speed / speed without load).
     * {@code sear.setJointPosition(name, value)} and its siblings command it; before the first command it holds the
     * position of the start.
     *
     * @param force at standstill, N; N m of a hinge; 0 for no motor
     * @param speed without load, degrees or metres a second
     */
    public void setMotor(double force, double speed) {
        double checkedForce = checked("stallForce", force);
        noLoadSpeed = checked("noLoadSpeed", speed);
        stallForce = checkedForce;
        changed();
    }

    /** Returns the name of the joint whose position it follows; null without a gear. */
    public String getGear() {
        return gear;
    }

    public double getRatio() {
        return ratio == null ? 1 : ratio;
    }

    /**
     * Adds a gear, as a toothed wheel, a rack or a linkage: its position follows that of another joint from the start,
     * and both feel each other's load.
     *
     * @param other a hinge, slider or rope
     * @param newRatio change of its position per change of the other's, degrees of a hinge, metres of a slider or rope;
     *     not 0; two meshing toothed wheels turn in opposite directions, with a negative one
     */
    public void setGear(AxisJoint other, double newRatio) {
        if (other == null || other.getName().equals(getName())) {
            throw new IllegalArgumentException(label() + ": the joint that it follows is "
                + (other == null ? "missing (None)" : "itself") + ", legal: another Hinge, Slider or Rope");
        }
        if (newRatio == 0) {
            throw new IllegalArgumentException(label() + ": ratio is 0, legal: any number but 0");
        }
        double checkedRatio = checked("ratio", newRatio);
        gear = checked("gear", other.getName());
        ratio = checkedRatio;
        changed();
    }
}
