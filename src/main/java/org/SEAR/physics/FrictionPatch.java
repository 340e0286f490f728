package org.SEAR.physics;

import org.SEAR.geometry.Placement;

/**
 * Friction of a manifold, at the middle of its points: against sliding in any direction with the same coefficient (Coulomb's cone), against turning
 * about the normal, and against rolling. Simulation thread.
 */
final class FrictionPatch {
    private final Tangent first = new Tangent();
    private final Tangent second = new Tangent();
    private double turningMass;
    private double turned;
    /** What held in the last substep, in the world, Ns and Nms. */
    private double fx;
    private double fy;
    private double fz;
    private final double[] roll = new double[3];
    private double lever;
    private double rollingMass;
    private boolean aboutAxis;
    private final double[] axis = new double[3];

    /** A row along the surface. */
    private static final class Tangent {
        double x;
        double y;
        double z;
        double impulse;
        private double ax;
        private double ay;
        private double az;
        private double bx;
        private double by;
        private double bz;
        private double iax;
        private double iay;
        private double iaz;
        private double ibx;
        private double iby;
        private double ibz;
        private double mass;

        void prepare(Manifold of, double px, double py, double pz) {
            SolverBody a = of.a;
            SolverBody b = of.b;
            double[] arm = of.arm;
            a.arm(px, py, pz, of.leadA, arm);
            ax = arm[1] * z - arm[2] * y;
            ay = arm[2] * x - arm[0] * z;
            az = arm[0] * y - arm[1] * x;
            b.arm(px, py, pz, of.leadB, arm);
            bx = arm[1] * z - arm[2] * y;
            by = arm[2] * x - arm[0] * z;
            bz = arm[0] * y - arm[1] * x;
            iax = of.massA > 0 ? a.i00 * ax + a.i01 * ay + a.i02 * az : 0;
            iay = of.massA > 0 ? a.i01 * ax + a.i11 * ay + a.i12 * az : 0;
            iaz = of.massA > 0 ? a.i02 * ax + a.i12 * ay + a.i22 * az : 0;
            ibx = of.massB > 0 ? b.i00 * bx + b.i01 * by + b.i02 * bz : 0;
            iby = of.massB > 0 ? b.i01 * bx + b.i11 * by + b.i12 * bz : 0;
            ibz = of.massB > 0 ? b.i02 * bx + b.i12 * by + b.i22 * bz : 0;
            double yields = of.massA + of.massB + ax * iax + ay * iay + az * iaz + bx * ibx + by * iby + bz * ibz;
            mass = yields > 0 ? 1 / yields : 0;
        }

        double wanted(Manifold of) {
            double[] p = of.a.v;
            double[] q = of.b.v;
            return impulse - mass * (x * (p[0] - q[0]) + y * (p[1] - q[1]) + z * (p[2] - q[2]) + ax * p[3] + ay * p[4] + az * p[5]
                - bx * q[3] - by * q[4] - bz * q[5]);
        }

        void push(Manifold of, double change) {
            double[] p = of.a.v;
            double[] q = of.b.v;
            double pa = change * of.massA;
            double pb = change * of.massB;
            p[0] += x * pa;
            p[1] += y * pa;
            p[2] += z * pa;
            p[3] += iax * change;
            p[4] += iay * change;
            p[5] += iaz * change;
            q[0] -= x * pb;
            q[1] -= y * pb;
            q[2] -= z * pb;
            q[3] -= ibx * change;
            q[4] -= iby * change;
            q[5] -= ibz * change;
        }
    }

    void fresh() {
        fx = 0;
        fy = 0;
        fz = 0;
        turned = 0;
        first.impulse = 0;
        second.impulse = 0;
        roll[0] = 0;
        roll[1] = 0;
        roll[2] = 0;
    }

    void inherit(FrictionPatch from) {
        fx = from.fx;
        fy = from.fy;
        fz = from.fz;
        turned = from.turned;
        System.arraycopy(from.roll, 0, roll, 0, 3);
    }

    /** Notes what it pushes as a vector: the tangents may be others in the next step. */
    void keep() {
        fx = first.x * first.impulse + second.x * second.impulse;
        fy = first.y * first.impulse + second.y * second.impulse;
        fz = first.z * first.impulse + second.z * second.impulse;
    }

    /** Whether it pushes. */
    boolean holds() {
        return first.impulse != 0 || second.impulse != 0 || turned != 0 || roll[0] != 0 || roll[1] != 0 || roll[2] != 0;
    }

    /** Makes the rows. */
    void prepare(Manifold of) {
        double mx = 0;
        double my = 0;
        double mz = 0;
        for (int i = 0; i < of.count; i++) {
            mx += of.points[i].x / of.count;
            my += of.points[i].y / of.count;
            mz += of.points[i].z / of.count;
        }
        for (int i = 0; i < of.count; i++) {
            ContactPoint point = of.points[i];
            double dx = point.x - mx;
            double dy = point.y - my;
            double dz = point.z - mz;
            point.aside = Math.sqrt(dx * dx + dy * dy + dz * dz);
        }
        tangents(of);
        first.prepare(of, mx, my, mz);
        second.prepare(of, mx, my, mz);
        first.impulse = fx * first.x + fy * first.y + fz * first.z;
        second.impulse = fx * second.x + fy * second.y + fz * second.z;
        double yields = (of.massA > 0 ? turns(of.a, of.nx, of.ny, of.nz) : 0) + (of.massB > 0 ? turns(of.b, of.nx, of.ny, of.nz) : 0);
        turningMass = yields > 0 ? 1 / yields : 0;
        if (of.rolling > 0) {
            prepareRolling(of, mx, my, mz);
        }
    }

    /** Any two directions at right angles to the normal and to each other, the same for the same normal. */
    private void tangents(Manifold of) {
        if (Math.abs(of.nx) < 0.6) {
            double length = Math.sqrt(of.ny * of.ny + of.nz * of.nz);
            first.x = 0;
            first.y = of.nz / length;
            first.z = -of.ny / length;
        } else {
            double length = Math.sqrt(of.nx * of.nx + of.ny * of.ny);
            first.x = of.ny / length;
            first.y = -of.nx / length;
            first.z = 0;
        }
        second.x = of.ny * first.z - of.nz * first.y;
        second.y = of.nz * first.x - of.nx * first.z;
        second.z = of.nx * first.y - of.ny * first.x;
    }

    private static double turns(SolverBody body, double x, double y, double z) {
        return x * (body.i00 * x + body.i01 * y + body.i02 * z) + y * (body.i01 * x + body.i11 * y + body.i12 * z)
            + z * (body.i02 * x + body.i12 * y + body.i22 * z);
    }

    /**
     * The torque against rolling is the force times the coefficient times how far the middle of what rolls is from the surface. What is round about
     * an axis rolls about that: tipping over its rim is no rolling.
     */
    private void prepareRolling(Manifold of, double x, double y, double z) {
        double fromA = of.bodyA.canRoll() ? distance(of, of.a, x, y, z) : 0;
        double fromB = of.bodyB.canRoll() ? distance(of, of.b, x, y, z) : 0;
        lever = Math.max(fromA, fromB);
        Body roller = fromA >= fromB ? of.bodyA : of.bodyB;
        aboutAxis = roller.isRoundAboutAxis();
        double softest = 0;
        if (aboutAxis) {
            Placement at = roller.getSolver().place;
            axis[0] = at.m01;
            axis[1] = at.m11;
            axis[2] = at.m21;
            softest = (of.massA > 0 ? turns(of.a, axis[0], axis[1], axis[2]) : 0) + (of.massB > 0 ? turns(of.b, axis[0], axis[1], axis[2]) : 0);
            double along = roll[0] * axis[0] + roll[1] * axis[1] + roll[2] * axis[2];
            for (int i = 0; i < 3; i++) {
                roll[i] = along * axis[i];
            }
        } else {
            for (int i = 0; i < 3; i++) {
                double yields = (of.massA > 0 ? diagonal(of.a, i) : 0) + (of.massB > 0 ? diagonal(of.b, i) : 0);
                softest = Math.max(softest, yields);
            }
        }
        rollingMass = softest > 0 ? 1 / softest : 0;
    }

    private static double distance(Manifold of, SolverBody body, double x, double y, double z) {
        return Math.abs((body.place.x - x) * of.nx + (body.place.y - y) * of.ny + (body.place.z - z) * of.nz);
    }

    private static double diagonal(SolverBody body, int axis) {
        return axis == 0 ? body.i00 : axis == 1 ? body.i11 : body.i22;
    }

    /** @param scale length of this substep over that of the last */
    void warmStart(Manifold of, double scale) {
        first.impulse *= scale;
        second.impulse *= scale;
        turned *= scale;
        first.push(of, first.impulse);
        second.push(of, second.impulse);
        twist(of, of.nx * turned, of.ny * turned, of.nz * turned);
        if (of.rolling > 0) {
            for (int i = 0; i < 3; i++) {
                roll[i] *= scale;
            }
            twist(of, roll[0], roll[1], roll[2]);
        }
    }

    private static void twist(Manifold of, double x, double y, double z) {
        if (of.massA > 0) {
            of.a.twist(x, y, z);
        }
        if (of.massB > 0) {
            of.b.twist(-x, -y, -z);
        }
    }

    /**
     * One pass.
     *
     * @param most impulse against sliding, Ns
     * @param mostTurning angular impulse about the normal, Nms
     * @param mostRolling angular impulse against rolling for each metre of lever, Ns
     */
    void solve(Manifold of, double most, double mostTurning, double mostRolling) {
        if (of.rolling > 0) {
            solveRolling(of, mostRolling * lever);
        }
        if (mostTurning > 0 || turned != 0) {
            double[] p = of.a.v;
            double[] q = of.b.v;
            double turning = of.nx * (p[3] - q[3]) + of.ny * (p[4] - q[4]) + of.nz * (p[5] - q[5]);
            double sum = Math.max(-mostTurning, Math.min(mostTurning, turned - turningMass * turning));
            double change = sum - turned;
            turned = sum;
            twist(of, of.nx * change, of.ny * change, of.nz * change);
        }
        double one = first.wanted(of);
        double other = second.wanted(of);
        double length = Math.sqrt(one * one + other * other);
        double scale = length > most ? most / length : 1;
        first.push(of, one * scale - first.impulse);
        second.push(of, other * scale - second.impulse);
        first.impulse = one * scale;
        second.impulse = other * scale;
    }

    private void solveRolling(Manifold of, double most) {
        double wx = of.a.v[3] - of.b.v[3];
        double wy = of.a.v[4] - of.b.v[4];
        double wz = of.a.v[5] - of.b.v[5];
        if (aboutAxis) {
            double along = wx * axis[0] + wy * axis[1] + wz * axis[2];
            wx = along * axis[0];
            wy = along * axis[1];
            wz = along * axis[2];
        }
        double x = roll[0] - rollingMass * wx;
        double y = roll[1] - rollingMass * wy;
        double z = roll[2] - rollingMass * wz;
        double length = Math.sqrt(x * x + y * y + z * z);
        double scale = length > most ? most / length : 1;
        twist(of, x * scale - roll[0], y * scale - roll[1], z * scale - roll[2]);
        roll[0] = x * scale;
        roll[1] = y * scale;
        roll[2] = z * scale;
    }
}
