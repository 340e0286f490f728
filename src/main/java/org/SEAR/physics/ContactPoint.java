package org.SEAR.physics;

/**
 * One point at which two bodies touch or may touch within the step: a row that keeps them apart. The direction is the manifold's. Simulation thread.
 */
final class ContactPoint {
    /** On the second body, world frame, when it was found, metres. */
    double x;
    double y;
    double z;
    /** Of both bodies when it was found, metres; negative: so deep they are in each other. */
    double found;
    /** The same point in the frames of both bodies, by which it is known again. */
    final double[] inA = new double[3];
    final double[] inB = new double[3];
    /** Push of this substep, Ns. */
    double impulse;
    /** What it took to throw them apart in this substep, Ns: friction counts it, too. */
    double thrown;
    /** Whether it comes to throw both apart, at the end of this substep or later: until then nothing brakes them. */
    boolean awaited;
    /** How far from the manifold's middle, metres. */
    double aside;
    /** Present distance of both surfaces here, metres. */
    double gap;

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
    private double blow;
    /** What the distance would be if neither had moved in this step, metres. */
    private double base;

    /** Makes the row of the step, or of what is left of it. */
    void prepare(Manifold of) {
        SolverBody a = of.a;
        SolverBody b = of.b;
        double half = found / 2;
        double px = x + half * of.nx;
        double py = y + half * of.ny;
        double pz = z + half * of.nz;
        double[] arm = of.arm;
        a.arm(px, py, pz, of.leadA, arm);
        ax = arm[1] * of.nz - arm[2] * of.ny;
        ay = arm[2] * of.nx - arm[0] * of.nz;
        az = arm[0] * of.ny - arm[1] * of.nx;
        b.arm(px, py, pz, of.leadB, arm);
        bx = arm[1] * of.nz - arm[2] * of.ny;
        by = arm[2] * of.nx - arm[0] * of.nz;
        bz = arm[0] * of.ny - arm[1] * of.nx;
        double yields = of.massA + of.massB;
        iax = 0;
        iay = 0;
        iaz = 0;
        if (of.massA > 0) {
            iax = a.i00 * ax + a.i01 * ay + a.i02 * az;
            iay = a.i01 * ax + a.i11 * ay + a.i12 * az;
            iaz = a.i02 * ax + a.i12 * ay + a.i22 * az;
            yields += ax * iax + ay * iay + az * iaz;
        }
        ibx = 0;
        iby = 0;
        ibz = 0;
        if (of.massB > 0) {
            ibx = b.i00 * bx + b.i01 * by + b.i02 * bz;
            iby = b.i01 * bx + b.i11 * by + b.i12 * bz;
            ibz = b.i02 * bx + b.i12 * by + b.i22 * bz;
            yields += bx * ibx + by * iby + bz * ibz;
        }
        mass = yields > 0 ? 1 / yields : 0;
        base = found - along(of, a.moved, b.moved);
        gap = found;
    }

    /** How both part here as they move: of their velocities a speed, m/s, of their ways a distance, metres. */
    private double along(Manifold of, double[] p, double[] q) {
        return of.nx * (p[0] - q[0]) + of.ny * (p[1] - q[1]) + of.nz * (p[2] - q[2]) + ax * p[3] + ay * p[4] + az * p[5]
            - bx * q[3] - by * q[4] - bz * q[5];
    }

    /** Looks how far both are from each other now. */
    void measure(Manifold of) {
        gap = base + along(of, of.a.moved, of.b.moved);
    }

    /** Speed at which both part, m/s. */
    double parting(Manifold of) {
        return along(of, of.a.v, of.b.v);
    }

    /** Speed at which both part here for an impulse of 1 Ns at another point, 1/kg. */
    double yields(Manifold of, ContactPoint other) {
        return of.massA + of.massB + ax * other.iax + ay * other.iay + az * other.iaz + bx * other.ibx + by * other.iby + bz * other.ibz;
    }

    /** Adds to the impulse so that both part with a speed, m/s, or faster. */
    void part(Manifold of, double speed) {
        double sum = Math.max(0, impulse + mass * (speed - parting(of)));
        push(of, sum - impulse);
        impulse = sum;
    }

    /** A blow begins. */
    void startBlow() {
        blow = 0;
    }

    /** Adds to the blow so that both part with a speed, m/s, or faster. */
    void rebound(Manifold of, double speed) {
        double sum = Math.max(0, blow + mass * (speed - parting(of)));
        push(of, sum - blow);
        blow = sum;
    }

    /** The blow has ended. */
    void endBlow() {
        thrown += blow;
    }

    /** Changes the velocities of both bodies. */
    void push(Manifold of, double change) {
        if (change == 0) {
            return;
        }
        double[] p = of.a.v;
        double[] q = of.b.v;
        double pa = change * of.massA;
        double pb = change * of.massB;
        p[0] += of.nx * pa;
        p[1] += of.ny * pa;
        p[2] += of.nz * pa;
        p[3] += iax * change;
        p[4] += iay * change;
        p[5] += iaz * change;
        q[0] -= of.nx * pb;
        q[1] -= of.ny * pb;
        q[2] -= of.nz * pb;
        q[3] -= ibx * change;
        q[4] -= iby * change;
        q[5] -= ibz * change;
    }

    /** The square of the distance from another point, in the frame in which both are nearer, m^2. */
    double square(ContactPoint other) {
        return Math.min(square(inA, other.inA), square(inB, other.inB));
    }

    private static double square(double[] p, double[] q) {
        return (p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) + (p[2] - q[2]) * (p[2] - q[2]);
    }
}
