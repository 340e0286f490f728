package org.SEAR.robot.servo;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.geometry.Pose;

/**
 * What is mounted on a servo and has a mass: its moment of inertia about the servo's axis, and the moment of its weight. What the robot's own motion
 * and other servos' acceleration add to that is left out. Simulation thread.
 */
public final class ServoLoad {
    private final List<Weight> weights = new ArrayList<>();
    private double inertia;
    /** The weight's moment about the axis is the scalar product of this, kg m, and gravity; body frame. */
    private double leverX;
    private double leverY;
    private double leverZ;
    private double axisX;
    private double axisY;
    private double axisZ;

    /** What weighs. */
    private static final class Weight {
        private final int part;
        private final double mass;
        private final Pose offset;
        private final double[] centre;
        private final double[] moments;

        Weight(int part, double mass, Pose offset, double[] centre, double[] moments) {
            this.part = part;
            this.mass = mass;
            this.offset = offset;
            this.centre = centre;
            this.moments = moments;
        }
    }

    /**
     * Puts something on it.
     *
     * @param part its number among the components
     * @param mass kg
     * @param offset where its solid stands in the component's frame
     * @param centre of mass in the solid's frame, {x, y, z}, metres
     * @param moments of inertia about the solid's axes through the centre of mass, for each kg, m^2
     */
    public void add(int part, double mass, Pose offset, double[] centre, double[] moments) {
        weights.add(new Weight(part, mass, offset, centre, moments));
    }

    /**
     * Takes over where everything is now.
     *
     * @param places of the components in the body frame
     * @param servo the number of the servo among them
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
            Pose solid = places[weight.part].times(weight.offset);
            double[] centre = solid.transform(weight.centre[0], weight.centre[1], weight.centre[2]);
            double x = centre[0] - at.x;
            double y = centre[1] - at.y;
            double z = centre[2] - at.z;
            double along = x * axisX + y * axisY + z * axisZ;
            double[] own = solid.rotateBack(axisX, axisY, axisZ);
            inertia += weight.mass * (x * x + y * y + z * z - along * along + weight.moments[0] * own[0] * own[0]
                + weight.moments[1] * own[1] * own[1] + weight.moments[2] * own[2] * own[2]);
            sumX += weight.mass * x;
            sumY += weight.mass * y;
            sumZ += weight.mass * z;
        }
        leverX = axisY * sumZ - axisZ * sumY;
        leverY = axisZ * sumX - axisX * sumZ;
        leverZ = axisX * sumY - axisY * sumX;
    }

    /** Whether nothing with a mass is on it. */
    boolean isEmpty() {
        return weights.isEmpty();
    }

    /** About the axis, kg m^2. */
    double inertia() {
        return inertia;
    }

    /**
     * How the weight turns the servo, N m, + counter-clockwise seen from the end of its axis.
     *
     * @param gx gravity in the body frame, m/s^2, likewise gy and gz
     */
    double moment(double gx, double gy, double gz) {
        return leverX * gx + leverY * gy + leverZ * gz;
    }

    /** The greatest moment that the weight has at any angle, N m; gravity as for {@link #moment}. */
    double greatest(double gx, double gy, double gz) {
        double along = gx * axisX + gy * axisY + gz * axisZ;
        double across = Math.max(0, gx * gx + gy * gy + gz * gz - along * along);
        return Math.sqrt((leverX * leverX + leverY * leverY + leverZ * leverZ) * across);
    }
}
