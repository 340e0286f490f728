package org.SEAR.robot.wheel;

import java.util.List;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Wheel;
import org.SEAR.physics.PhysicsWorld;

/**
 * The springs of a robot's wheels. Where its {@link Dynamics} says no stiffness, each spring gives way by the same little under what its wheel
 * carries, so that all have one natural frequency and the robot stands level; and it hangs as low as the body needs to be clear of the ground.
 */
public final class SpringDesign {
    /** How far springs give way under the robot, as a share of its smallest wheel's radius, and metres at most. */
    private static final double SAG = 0.1;
    private static final double MAX_SAG = 0.01;
    /** The moment with which springs set the robot upright is at least so many times that with which its weight lays it over. */
    private static final double UPRIGHT = 10;
    /** Length of a suspension whose stiffness is known, but not its length, and the greatest that is chosen, metres. */
    private static final double LENGTH = 0.1;
    /** A wheel that carries less than this share of an equal one counts as if it carried so much. */
    private static final double MIN_LOAD = 0.05;
    /** A spring that is chosen can press its wheel down by so many times what that carries: else wheels of heavy robots would have no grip. */
    private static final double MIN_FORCE = 10;

    private final Dynamics dynamics;
    private final List<Wheel> wheels;
    private final double[] centre;

    private SpringDesign(Dynamics dynamics, List<Wheel> wheels, double[] centre) {
        this.dynamics = dynamics;
        this.wheels = wheels;
        this.centre = centre;
    }

    /**
     * Those of a robot, in the order of its wheels.
     *
     * @param centre of mass in the body frame, {x, y, z}, metres
     * @param lowest point of the body, metres
     */
    public static Spring[] of(Dynamics dynamics, List<Wheel> wheels, double[] centre, double lowest) {
        SpringDesign design = new SpringDesign(dynamics, wheels, centre);
        return dynamics.getStiffness() == null ? design.chosen(lowest) : design.given(dynamics.getStiffness());
    }

    /** In Bullet's measure: each spring has the stiffness times the mass of the whole robot. */
    private Spring[] given(double stiffness) {
        double rest = dynamics.getRestLength() == null ? LENGTH : dynamics.getRestLength();
        double sag = stiffness == 0 ? 0 : PhysicsWorld.GRAVITY / (wheels.size() * stiffness);
        Spring[] springs = new Spring[wheels.size()];
        for (int i = 0; i < springs.length; i++) {
            springs[i] = spring(dynamics.getMass() / springs.length, stiffness * dynamics.getMass(),
                2 * Math.sqrt(stiffness) * dynamics.getMass(), dynamics.getMaxSuspensionForce(), rest, Math.max(0, rest - sag));
        }
        return springs;
    }

    private Spring spring(double carried, double stiffness, double critical, double force, double rest, double hangs) {
        return new Spring(carried, stiffness, critical, dynamics.getCompression(), dynamics.getDamping(), force, rest, hangs);
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
            double square = PhysicsWorld.GRAVITY / sag;
            double force = Math.max(dynamics.getMaxSuspensionForce(), MIN_FORCE * PhysicsWorld.GRAVITY * loads[i]);
            springs[i] = spring(loads[i], loads[i] * square, 2 * loads[i] * Math.sqrt(square), force, rest, hangs);
        }
        return springs;
    }

    private static double radius(Wheel wheel) {
        return wheel.getRadius() * wheel.getScaleY();
    }

    /**
     * How many times as stiff the springs of a robot would have to be to hold it upright: their moment against that of its weight.
     *
     * @param alongX whether it could fall sideways; else forwards or backwards
     * @return 1 or less if they do; 0 if its wheels don't span an area, so that it rests on its body
     */
    public static double tooSoft(Spring[] springs, List<Wheel> wheels, double[] centre, double mass, boolean alongX) {
        if (CentreOfMass.room(centre[0], centre[2], wheels) <= 0) {
            return 0;
        }
        double upright = 0;
        double ground = Double.POSITIVE_INFINITY;
        for (int i = 0; i < springs.length; i++) {
            double lever = alongX ? CentreOfMass.footX(wheels.get(i)) - centre[0] : CentreOfMass.footZ(wheels.get(i)) - centre[2];
            upright += springs[i].stiffness * lever * lever;
            ground = Math.min(ground, wheels.get(i).getY() - springs[i].hangs - radius(wheels.get(i)));
        }
        return upright == 0 ? 0 : mass * PhysicsWorld.GRAVITY * (centre[1] - ground) / upright;
    }

    /** The greatest sag at which springs hold the robot upright, metres. */
    private double upright(double[] loads, double height) {
        double across = 0;
        double along = 0;
        for (int i = 0; i < loads.length; i++) {
            across += loads[i] * Math.pow(CentreOfMass.footX(wheels.get(i)) - centre[0], 2);
            along += loads[i] * Math.pow(CentreOfMass.footZ(wheels.get(i)) - centre[2], 2);
        }
        return Math.min(across, along) / (UPRIGHT * dynamics.getMass() * Math.max(height, MAX_SAG));
    }

    /** What each wheel carries, kg, by equal springs under a stiff body. */
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

    /** Cramer's rule; null if wheels stand on a line, or all under the centre of mass. */
    private static double[] solve(double[][] m) {
        double whole = determinant(m, -1);
        if (Math.abs(whole) <= 1e-12 * m[0][0] * (m[1][1] + m[2][2]) * (m[1][1] + m[2][2])) {
            return null;
        }
        return new double[] {determinant(m, 0) / whole, determinant(m, 1) / whole, determinant(m, 2) / whole};
    }

    /** With the right side in the place of a column; -1 for none. */
    private static double determinant(double[][] m, int replaced) {
        double sum = 0;
        for (int i = 0; i < 3; i++) {
            double a = m[0][replaced == i ? 3 : i];
            int k = (i + 1) % 3;
            int l = (i + 2) % 3;
            sum += a * (m[1][replaced == k ? 3 : k] * m[2][replaced == l ? 3 : l] - m[1][replaced == l ? 3 : l] * m[2][replaced == k ? 3 : k]);
        }
        return sum;
    }
}
