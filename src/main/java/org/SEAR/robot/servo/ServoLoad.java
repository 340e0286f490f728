// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.servo;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.MassProperties;

/**
 * Mass mounted on a servo: moment of inertia about the servo's axis, and torque of the weight. Neglects the robot's own
 * motion and the acceleration of other servos. Simulation thread.
 */
public final class ServoLoad {
    private final List<Weight> weights = new ArrayList<>();
    private double inertia;
    /** Scalar product with gravity gives the torque of the weight about the axis: kg m, body frame. */
    private double leverX;
    private double leverY;
    private double leverZ;
    private double axisX;
    private double axisY;
    private double axisZ;

    /** Part with a mass. */
    private static final class Weight {
        private final int part;
        private final MassProperties properties;

        Weight(int part, MassProperties properties) {
            this.part = part;
            this.properties = properties;
        }
    }

    /**
     * Adds a part.
     * @param part its index among the components
     * @param properties in the component's frame
     */
    public void add(int part, MassProperties properties) {
        weights.add(new Weight(part, properties));
    }

    /**
     * Updates the load after a change of the poses.
     * @param places of the components in the body frame
     * @param servo index of the servo among them
     */
    public void place(Pose[] places, int servo) {
        Pose at = places[servo];
        double[] axis = at.rotate(0, 1, 0);
        axisX = axis[0];
        axisY = axis[1];
        axisZ = axis[2];
        inertia = 0;
        double sumX = 0;
        double sumY = 0;
        double sumZ = 0;
        for (Weight weight : weights) {
            double mass = weight.properties.mass;
            double[] own = weight.properties.centre();
            double[] centre = places[weight.part].transform(own[0], own[1], own[2]);
            double x = centre[0] - at.x;
            double y = centre[1] - at.y;
            double z = centre[2] - at.z;
            double along = x * axisX + y * axisY + z * axisZ;
            double[] turned = places[weight.part].rotateBack(axisX, axisY, axisZ);
            inertia += mass * (x * x + y * y + z * z - along * along)
                + weight.properties.inertia.about(turned[0], turned[1], turned[2]);
            sumX += mass * x;
            sumY += mass * y;
            sumZ += mass * z;
        }
        leverX = axisY * sumZ - axisZ * sumY;
        leverY = axisZ * sumX - axisX * sumZ;
        leverZ = axisX * sumY - axisY * sumX;
    }

    /** Whether no part with a mass is mounted. */
    boolean isEmpty() {
        return weights.isEmpty();
    }

    /** Moment of inertia about the axis, kg m^2. */
    double inertia() {
        return inertia;
    }

    /**
     * Returns the torque of the weight, N m, + counter-clockwise seen from the end of the axis.
     * @param gx gravity in the body frame, m/s^2, likewise gy and gz
     */
    double moment(double gx, double gy, double gz) {
        return leverX * gx + leverY * gy + leverZ * gz;
    }

    /** Returns the greatest torque of the weight at any angle, N m; gravity as for {@link #moment}. */
    double greatest(double gx, double gy, double gz) {
        double along = gx * axisX + gy * axisY + gz * axisZ;
        double across = Math.max(0, gx * gx + gy * gy + gz * gz - along * along);
        return Math.sqrt((leverX * leverX + leverY * leverY + leverZ * leverZ) * across);
    }
}
