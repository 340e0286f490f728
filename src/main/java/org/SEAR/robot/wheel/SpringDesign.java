// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import java.util.List;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Wheel;

/**
 * Springs of a robot's wheels, designed for the world's gravity at the start. Without a stiffness in its
 * {@link Dynamics}, all springs deflect equally little under their wheels' loads. They then have one natural frequency,
 * the robot stands level, and the wheels hang low enough to lift the body off the ground.
 */
public final class SpringDesign {
    /** Deflection of springs under the robot, as a share of its smallest wheel's radius, and its limit, metres. */
    private static final double SAG = 0.1;
    private static final double MAX_SAG = 0.01;
    /** Smallest ratio of the springs' righting moment to the tipping moment of the weight. */
    private static final double UPRIGHT = 10;
    /** Suspension length for a given stiffness without a length, and the greatest chosen length, metres. */
    private static final double LENGTH = 0.1;
    /** Smallest load of a wheel, as a share of an equal one. */
    private static final double MIN_LOAD = 0.05;
    /**
     * Smallest ratio of a chosen spring's greatest force to the wheel's load; heavy robots would otherwise lose grip.
     */
    private static final double MIN_FORCE = 10;
    /** Least gravity that springs are designed for, m/s^2: the Moon's. In a weaker one they hang lower. */
    private static final double MIN_GRAVITY = 1.62;

    private final Dynamics dynamics;
    private final List<Wheel> wheels;
    private final double[] centre;
    /** Gravity of the world, and the one that the springs are designed for, m/s^2. */
    private final double gravity;
    private final double designed;

    private SpringDesign(Dynamics dynamics, List<Wheel> wheels, double[] centre, double gravity) {
        this.dynamics = dynamics;
        this.wheels = wheels;
        this.centre = centre;
        this.gravity = gravity;
        designed = Math.max(gravity, MIN_GRAVITY);
    }

    /**
     * Returns the springs of a robot, in the order of its wheels.
     * @param centre of mass in the body frame, {x, y, z}, metres
     * @param lowest y of the body's lowest point, metres
     * @param gravity of the world at the start, m/s^2
     */
    public static Spring[] of(Dynamics dynamics, List<Wheel> wheels, double[] centre, double lowest, double gravity) {
        SpringDesign design = new SpringDesign(dynamics, wheels, centre, gravity);
        return dynamics.getStiffness() == null ? design.chosen(lowest) : design.given(dynamics.getStiffness());
    }

    /** Uses Bullet's convention: the stiffness of each spring is the value times the mass of the whole robot. */
    private Spring[] given(double stiffness) {
        double rest = dynamics.getRestLength() == null ? LENGTH : dynamics.getRestLength();
        double sag = stiffness == 0 ? 0 : gravity / (wheels.size() * stiffness);
        Spring[] springs = new Spring[wheels.size()];
        for (int i = 0; i < springs.length; i++) {
            springs[i] = spring(dynamics.getMass() / springs.length, stiffness * dynamics.getMass(),
                2 * Math.sqrt(stiffness) * dynamics.getMass(), dynamics.getMaxSuspensionForce(), rest,
                    Math.max(0, rest - sag));
        }
        return springs;
    }

    private Spring spring(double carried, double stiffness, double critical, double force, double rest, double hangs) {
        return new Spring(carried, stiffness, critical, dynamics.getCompression(), dynamics.getDamping(), force,
            rest, hangs);
    }

    private Spring[] chosen(double lowest) {
        double[] loads = loads();
        double smallest = wheels.stream().mapToDouble(SpringDesign::radius).min().orElse(0);
        double bottom = wheels.stream().mapToDouble(wheel -> wheel.getY() - radius(wheel)).min().orElse(0);
        boolean stands = CentreOfMass.room(centre[0], centre[2], wheels) > 0;
        double clear = Math.min(MAX_SAG, SAG * smallest);
        double ground = stands ? Math.min(bottom, lowest) - clear : bottom;
        double sag = Math.min(clear, stands ? upright(loads, centre[1] - ground) : clear);
        Spring[] springs = new Spring[wheels.size()];
        for (int i = 0; i < springs.length; i++) {
            double hangs = Math.min(LENGTH, wheels.get(i).getY() - radius(wheels.get(i)) - ground);
            double rest = hangs + sag;
            if (dynamics.getRestLength() != null) {
                rest = dynamics.getRestLength();
                hangs = Math.max(0, rest - sag);
            }
            double square = designed / sag;
            double force = Math.max(dynamics.getMaxSuspensionForce(), MIN_FORCE * designed * loads[i]);
            springs[i] = spring(loads[i], loads[i] * square, 2 * loads[i] * Math.sqrt(square), force, rest,
                hangs + sag * (1 - gravity / designed));
        }
        return springs;
    }

    private static double radius(Wheel wheel) {
        return wheel.getRadius() * wheel.getScaleY();
    }

    /**
     * Returns the factor by which springs are too soft to hold a robot upright: tipping moment over righting moment.
     * @param weight of the robot, N
     * @param alongX tests falling sideways, otherwise forwards or backwards
     * @return at most 1 if they hold; 0 if the wheels don't span an area, so that it rests on its body
     */
    public static double tooSoft(Spring[] springs, List<Wheel> wheels, double[] centre, double weight, boolean alongX) {
        if (CentreOfMass.room(centre[0], centre[2], wheels) <= 0) {
            return 0;
        }
        double upright = 0;
        double ground = Double.POSITIVE_INFINITY;
        for (int i = 0; i < springs.length; i++) {
            double lever = alongX ? CentreOfMass.footX(wheels.get(i)) - centre[0] : CentreOfMass.footZ(wheels.get(i))
                - centre[2];
            upright += springs[i].stiffness * lever * lever;
            ground = Math.min(ground, wheels.get(i).getY() - springs[i].hangs - radius(wheels.get(i)));
        }
        return upright == 0 ? 0 : weight * (centre[1] - ground) / upright;
    }

    /** Returns the greatest deflection at which springs hold the robot upright, metres. */
    private double upright(double[] loads, double height) {
        double across = 0;
        double along = 0;
        for (int i = 0; i < loads.length; i++) {
            across += loads[i] * Math.pow(CentreOfMass.footX(wheels.get(i)) - centre[0], 2);
            along += loads[i] * Math.pow(CentreOfMass.footZ(wheels.get(i)) - centre[2], 2);
        }
        return Math.min(across, along) / (UPRIGHT * dynamics.getMass() * Math.max(height, MAX_SAG));
    }

    /** Returns the load of each wheel, kg, for equal springs under a rigid body. */
    private double[] loads() {
        double[] loads = new double[wheels.size()];
        double[][] sums = new double[3][4];
        for (Wheel wheel : wheels) {
            double[] at = {1, CentreOfMass.footX(wheel) - centre[0], CentreOfMass.footZ(wheel) - centre[2]};
            for (int i = 0; i < 3; i++) {
                for (int k = 0; k < 3; k++) {
                    sums[i][k] += at[i] * at[k];
                }
            }
        }
        sums[0][3] = dynamics.getMass();
        double[] plane = solve(sums);
        double equal = dynamics.getMass() / wheels.size();
        for (int i = 0; i < loads.length; i++) {
            double x = CentreOfMass.footX(wheels.get(i)) - centre[0];
            double z = CentreOfMass.footZ(wheels.get(i)) - centre[2];
            loads[i] = plane == null ? equal : Math.max(MIN_LOAD * equal, plane[0] + plane[1] * x + plane[2] * z);
        }
        return loads;
    }

    /** Solves by Cramer's rule; null if all wheels are on a line, or below the centre of mass. */
    private static double[] solve(double[][] m) {
        double whole = determinant(m, -1);
        if (Math.abs(whole) <= 1e-12 * m[0][0] * (m[1][1] + m[2][2]) * (m[1][1] + m[2][2])) {
            return null;
        }
        return new double[] {determinant(m, 0) / whole, determinant(m, 1) / whole, determinant(m, 2) / whole};
    }

    /** Returns the determinant with the right side in place of a column; -1 for none. */
    private static double determinant(double[][] m, int replaced) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double a = m[0][replaced == i ? 3 : i];
            int k = (i + 1) % 3;
            int l = (i + 2) % 3;
            sum += a * (m[1][replaced == k ? 3 : k] * m[2][replaced == l ? 3 : l] - m[1][replaced == l ? 3 : l]
                * m[2][replaced == k ? 3 : k]);
        }
        return sum;
    }
}
