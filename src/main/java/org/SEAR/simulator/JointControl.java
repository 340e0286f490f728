// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import org.SEAR.POJOs.AxisJoint;
import org.SEAR.POJOs.Joint;
import org.SEAR.POJOs.Rope;

/** The command of a joint's motor that sliders and learners give, with its range. Immutable, any thread. */
public final class JointControl {
    public final ActuatorOrder.Kind kind;
    /** Degrees or metres, the same a second, or a share of the full power. */
    public final double least;
    public final double most;

    private JointControl(ActuatorOrder.Kind kind, double least, double most) {
        this.kind = kind;
        this.least = least;
        this.most = most;
    }

    /**
     * Returns the position of a joint between limits, else its speed up to that without load, else its power; null
     * without a motor.
     */
    public static JointControl of(Joint joint) {
        if (!(joint instanceof AxisJoint) || ((AxisJoint) joint).getStallForce() == 0) {
            return null;
        }
        AxisJoint driven = (AxisJoint) joint;
        Double least = driven.getLower() == null && joint instanceof Rope ? Double.valueOf(0) : driven.getLower();
        if (least != null && driven.getUpper() != null) {
            return new JointControl(ActuatorOrder.Kind.JOINT_POSITION, least, driven.getUpper());
        }
        return of(driven, driven.getNoLoadSpeed() == null ? ActuatorOrder.Kind.JOINT_POWER
            : ActuatorOrder.Kind.JOINT_SPEED);
    }

    /** Returns one command of a joint with a motor; its range is unlimited without limits. */
    public static JointControl of(AxisJoint driven, ActuatorOrder.Kind kind) {
        if (kind == ActuatorOrder.Kind.JOINT_POSITION) {
            return new JointControl(kind, orElse(driven.getLower(), Double.NEGATIVE_INFINITY),
                orElse(driven.getUpper(), Double.POSITIVE_INFINITY));
        }
        double most = kind == ActuatorOrder.Kind.JOINT_POWER ? 1
            : orElse(driven.getNoLoadSpeed(), Double.POSITIVE_INFINITY);
        return new JointControl(kind, -most, most);
    }

    private static double orElse(Double value, double other) {
        return value == null ? other : value;
    }
}
