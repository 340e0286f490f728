package org.SEAR.physics;

import org.SEAR.physics.solid.Surface;

/**
 * The contact of two solids along one direction: up to four points that keep them apart, and at the middle of those the friction against sliding,
 * turning and rolling. Solved by sequential impulses with warm starting; penetration is taken back by a bounded speed that the relaxing pass takes
 * out of the velocities again (soft step: Catto, Solver2D 2024; small steps: Macklin 2019). Simulation thread.
 */
final class Manifold {
    static final int MOST_POINTS = 4;
    /** Share of a penetration that is taken back in a second, 1/s. */
    private static final double RECOVERY = 8;
    /** The speed at which a penetration is taken back at most, m/s. */
    private static final double MOST_RECOVERY = 1;
    /** The share of a penetration that a substep may take back. */
    private static final double MOST_SHARE = 0.2;
    static final double CLOSE = 1e-4;
    /** A point this near to one before is the same, metres. */
    private static final double NEAR = 0.02;
    /** Least cosine of the normals of a manifold and the one before it. */
    private static final double SIMILAR = 0.9;
    /** What turns by more than this in a substep spins, radians. */
    private static final double SPINNING = 0.02;
    /** What is deeper in another than this comes out slowly, metres. */
    private static final double DEEP = 0.005;
    /** How deep something may be in what is fixed, as a share of its own least half size. */
    private static final double DEEPEST_SHARE = 0.5;

    SolverBody a;
    SolverBody b;
    Body bodyA;
    Body bodyB;
    /** Which solids of the bodies. */
    int solidA;
    int solidB;
    /** From b to a, length 1, world frame. */
    double nx;
    double ny;
    double nz;
    int count;
    final ContactPoint[] points = {new ContactPoint(), new ContactPoint(), new ContactPoint(), new ContactPoint()};
    /** Coefficients of the pair. */
    double friction;
    double restitution;
    /** Coefficient of rolling friction, 0 where nothing rolls. */
    double rolling;
    /** Inverse masses, 1/kg; 0 of what does not move in this step. */
    double massA;
    double massB;
    /** Length of the substep that the impulses belong to, seconds. */
    private double seconds;
    /** For how long the bodies turn on before the point of contact is where the rows have it, seconds. */
    double leadA;
    double leadB;
    /** Room for the way from a centre of mass to a point. */
    final double[] arm = new double[3];
    private final FrictionPatch patch = new FrictionPatch();
    private final NormalBlock block = new NormalBlock();

    /** Adds the coefficients of both surfaces: friction the product, restitution the greater, rolling friction the sum. */
    void setSurfaces(Surface ofA, Surface ofB) {
        friction = ofA.friction(bodyA.isRobot()) * ofB.friction(bodyB.isRobot());
        restitution = Math.max(ofA.restitution(), ofB.restitution());
        rolling = bodyA.canRoll() || bodyB.canRoll() ? ofA.rollingFriction() + ofB.rollingFriction() : 0;
    }

    /**
     * Adds a point.
     *
     * @param x of the second body, metres, world frame, likewise y and z
     * @param gap to the first body, metres
     */
    void add(double x, double y, double z, double gap) {
        ContactPoint point = points[count++];
        point.x = x;
        point.y = y;
        point.z = z;
        point.found = gap;
        point.gap = gap;
        point.impulse = 0;
        point.thrown = 0;
        point.awaited = false;
        a.place.toFrame(x, y, z, point.inA);
        b.place.toFrame(x, y, z, point.inB);
    }

    /** Takes over what a manifold of the same solids pushed before: each point what the one next to it did. */
    void inherit(Manifold from) {
        if (nx * from.nx + ny * from.ny + nz * from.nz < SIMILAR) {
            return;
        }
        seconds = from.seconds;
        patch.inherit(from.patch);
        for (int i = 0; i < count; i++) {
            ContactPoint nearest = null;
            double least = NEAR * NEAR;
            for (int k = 0; k < from.count; k++) {
                double square = points[i].square(from.points[k]);
                if (square < least) {
                    least = square;
                    nearest = from.points[k];
                }
            }
            if (nearest != null) {
                points[i].impulse = nearest.impulse;
            }
        }
        share(from);
    }

    /** What the manifold before pushed where it now has no point is shared by the points that it has. */
    private void share(Manifold from) {
        double lost = 0;
        for (int i = 0; i < from.count; i++) {
            lost += from.points[i].impulse;
        }
        for (int i = 0; i < count; i++) {
            lost -= points[i].impulse;
        }
        for (int i = 0; i < count && lost > 0; i++) {
            points[i].impulse += lost / count;
        }
    }

    /** What the distances are now counts as found, for a step in which contacts are not found anew. */
    void settle() {
        for (int i = 0; i < count; i++) {
            points[i].found = points[i].gap;
        }
    }

    /** Forgets what it pushed. */
    void fresh() {
        seconds = 0;
        patch.fresh();
        for (ContactPoint point : points) {
            point.impulse = 0;
            point.thrown = 0;
        }
    }

    /**
     * Makes the rows.
     *
     * @param ahead length of the next substep, seconds
     */
    void prepare(double ahead) {
        massA = bodyA.isSolved() ? a.inverseMass : 0;
        massB = bodyB.isSolved() ? b.inverseMass : 0;
        leadA = lead(bodyA, a, solidA, count > 0 ? points[0].inA : null, ahead);
        leadB = lead(bodyB, b, solidB, count > 0 ? points[0].inB : null, ahead);
        for (int i = 0; i < count; i++) {
            points[i].prepare(this);
        }
        patch.prepare(this);
        if (count > 1 && massA + massB > 0) {
            block.prepare(this);
        }
    }

    /**
     * A corner of a body that spins fast goes on a bow: its speed in the middle of the substep counts, when it has turned by half of it. Where
     * something round rolls, the point of contact stays where it is.
     */
    private static double lead(Body body, SolverBody solver, int solid, double[] point, double ahead) {
        return point != null && solver.turning() * ahead > SPINNING && body.isCorner(solid, point) ? ahead / 2 : 0;
    }

    /** A substep begins: what pushed in the last one pushes on. */
    void begin(double newSeconds) {
        measure();
        double scale = seconds > 0 ? newSeconds / seconds : 0;
        seconds = newSeconds;
        for (int i = 0; i < count; i++) {
            ContactPoint point = points[i];
            point.impulse *= scale;
            point.push(this, point.impulse);
        }
        patch.warmStart(this, scale);
    }

    private void measure() {
        for (int i = 0; i < count; i++) {
            points[i].measure(this);
        }
    }

    /**
     * A pass that takes penetrations back.
     *
     * @param last whether it is the last one before the bodies move
     */
    void press(boolean last) {
        solve(true);
        if (last) {
            mark();
        }
    }

    /**
     * A pass that doesn't.
     *
     * @param first whether the bodies have moved since the last pass
     * @param last whether the substep ends
     */
    void relax(boolean first, boolean last) {
        if (first) {
            measure();
            stayOut();
        }
        solve(false);
        if (last) {
            patch.keep();
        }
    }

    private void solve(boolean recovers) {
        double pressing = 0;
        double turning = 0;
        for (int i = 0; i < count; i++) {
            double both = points[i].impulse + points[i].thrown;
            pressing += both;
            turning += both * points[i].aside;
        }
        if (pressing > 0 || patch.holds()) {
            patch.solve(this, friction * pressing, friction * turning, rolling * pressing);
        }
        double[] wanted = block.wanted();
        boolean all = count > 1;
        for (int i = 0; i < count; i++) {
            all &= !points[i].awaited;
            double gap = points[i].gap;
            wanted[i] = (gap > CLOSE ? -(gap - CLOSE) / seconds : 0) + (recovers ? recovery(Math.min(gap, CLOSE)) : 0);
        }
        if (!all || !block.solve(this)) {
            for (int i = 0; i < count; i++) {
                if (!points[i].awaited) {
                    points[i].part(this, wanted[i]);
                }
            }
        }
    }

    private double recovery(double gap) {
        return Math.min(MOST_RECOVERY, -gap * Math.min(RECOVERY, MOST_SHARE / seconds));
    }

    /** Nothing gets deeper into what is fixed than half of its own half size, whatever pushes it: beyond its middle it would come out behind. */
    private void stayOut() {
        if (!bodyA.isFixed() && !bodyB.isFixed()) {
            return;
        }
        Body body = bodyB.isFixed() ? bodyA : bodyB;
        double sign = bodyB.isFixed() ? 1 : -1;
        double deepest = gap() + DEEPEST_SHARE * body.getLeast();
        if (deepest < 0 && body.isSolved()) {
            body.getSolver().lift(sign * nx, sign * ny, sign * nz, -deepest);
            measure();
        }
    }

    /** Whether its bodies are far in each other. */
    private boolean isDeep() {
        for (int i = 0; i < count; i++) {
            if (points[i].gap < -DEEP) {
                return true;
            }
        }
        return false;
    }

    /** Notes which bodies it pushes. */
    private void mark() {
        boolean pushes = false;
        for (int i = 0; i < count; i++) {
            pushes |= points[i].impulse > 0 || points[i].thrown > 0;
        }
        if (isDeep()) {
            a.setDeep();
            b.setDeep();
        }
        if (pushes) {
            a.press(nx, ny, nz);
            b.press(nx, ny, nz);
        } else if (patch.holds()) {
            // what does not press does not rub; else friction would be left without the push that it came from
            patch.solve(this, 0, 0, 0);
        }
    }

    /** Forgets what threw them apart in the last substep. */
    void clearThrown() {
        for (int i = 0; i < count; i++) {
            points[i].thrown = 0;
            points[i].awaited = false;
        }
    }

    /**
     * Speed at which those of its points come together that touch, at most, m/s.
     *
     * @param touch how near they are then, metres
     * @param ahead those that will be so near within this time count, too, seconds
     */
    double approach(double touch, double ahead) {
        double most = 0;
        for (int i = 0; i < count; i++) {
            double speed = -points[i].parting(this);
            if (speed > most && points[i].gap <= touch + speed * ahead) {
                most = speed;
            }
        }
        return most;
    }

    /** The least distance of its points, metres. */
    double gap() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, points[i].gap);
        }
        return least;
    }

    /** Which of a robot's solids of the first body it is; 0 in all other bodies. */
    int numberA() {
        return bodyA.isRobot() ? solidA : 0;
    }

    /** The same of the second body. */
    int numberB() {
        return bodyB.isRobot() ? solidB : 0;
    }
}
