package org.SEAR.physics;

import org.SEAR.physics.solid.HingeLevers;
import org.SEAR.physics.solid.Surface;

/**
 * The contact of two solids along one direction: up to four points that keep them apart, and what pushes and holds there from step to step. While a
 * step is solved, {@link ContactRows} has its numbers. Simulation thread.
 */
final class Manifold {
    static final int MAX_POINTS = 4;
    private static final int OWN = 6;
    /** A point this near to one before is the same, metres. */
    private static final double NEAR = 0.02;
    /** Least cosine of the normals of a manifold and the one before it. */
    private static final double SIMILAR = 0.9;
    /** What turns by more than this in a substep spins, radians. */
    private static final double SPINNING = 0.02;

    /** One point at which two bodies touch or may touch within the step; the direction is the manifold's. Simulation thread. */
    static final class Point {
        /** On the second body, world frame, when it was found, metres. */
        double x;
        double y;
        double z;
        /** Of both bodies when it was found, metres; negative: so deep they are in each other. */
        double found;
        /** Push of the last substep, Ns. */
        double impulse;
        /** Distance of both surfaces here at the end of the last step, metres. */
        double gap;
    }

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
    final Point[] points = {new Point(), new Point(), new Point(), new Point()};
    /** The same points in the frames of both bodies, by which they are known again: {x, y, z} of each in the first, then in the second. */
    private final double[] own = new double[MAX_POINTS * OWN];
    /** Coefficients of the pair. */
    double friction;
    double restitution;
    /** Coefficient of rolling friction, 0 where nothing rolls. */
    double rolling;
    /** Whether nothing round and no robot touches: what rocks on edges and corners. */
    boolean rocks;
    /** Inverse masses, 1/kg; 0 of what does not move in this step. */
    double massA;
    double massB;
    /** Length of the substep that the impulses belong to, seconds. */
    double seconds;
    /** Whether they are those of a blow, which does not push on. */
    boolean impact;
    /** For how long the bodies turn on before the point of contact is where the rows have it, seconds. */
    double leadA;
    double leadB;
    /** Room for the way from a centre of mass to a point. */
    final double[] arm = new double[3];
    /** Friction that holds against sliding, Ns, world frame. */
    double fx;
    double fy;
    double fz;
    /** And against turning about the normal, Nms. */
    double turned;
    /** And against rolling, Nms, world frame. */
    double rollX;
    double rollY;
    double rollZ;

    /** Adds the coefficients of both surfaces: friction the product, restitution the greater, rolling friction the sum. */
    void setSurfaces(Surface ofA, Surface ofB) {
        friction = ofA.friction(bodyA.isRobot()) * ofB.friction(bodyB.isRobot());
        restitution = Math.max(ofA.restitution(), ofB.restitution());
        boolean rolls = bodyA.canRoll() || bodyB.canRoll();
        rolling = rolls ? ofA.rollingFriction() + ofB.rollingFriction() : 0;
        rocks = !rolls && !bodyA.isRobot() && !bodyB.isRobot();
    }

    /**
     * Adds a point.
     *
     * @param x of the second body, metres, world frame, likewise y and z
     * @param gap to the first body, metres
     */
    void add(double x, double y, double z, double gap) {
        Point point = points[count];
        point.x = x;
        point.y = y;
        point.z = z;
        point.found = gap;
        point.gap = gap;
        point.impulse = 0;
        a.place.toFrame(x, y, z, own, count * OWN);
        b.place.toFrame(x, y, z, own, count * OWN + 3);
        count++;
    }

    /** Takes over what a manifold of the same solids pushed before: each point what the one next to it did. */
    void inherit(Manifold from) {
        if (nx * from.nx + ny * from.ny + nz * from.nz < SIMILAR) {
            return;
        }
        seconds = from.seconds;
        impact = from.impact;
        fx = from.fx;
        fy = from.fy;
        fz = from.fz;
        turned = from.turned;
        rollX = from.rollX;
        rollY = from.rollY;
        rollZ = from.rollZ;
        for (int i = 0; i < count; i++) {
            Point nearest = null;
            double least = NEAR * NEAR;
            for (int k = 0; k < from.count; k++) {
                double square = Math.min(square(i, from, k, 0), square(i, from, k, 3));
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

    /** The square of the distance of a point from one of another manifold in the frame of a body, 0 for the first or 3, m^2. */
    private double square(int i, Manifold from, int k, int frame) {
        int at = i * OWN + frame;
        int other = k * OWN + frame;
        double x = own[at] - from.own[other];
        double y = own[at + 1] - from.own[other + 1];
        double z = own[at + 2] - from.own[other + 2];
        return x * x + y * y + z * z;
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
        impact = false;
        fx = 0;
        fy = 0;
        fz = 0;
        turned = 0;
        rollX = 0;
        rollY = 0;
        rollZ = 0;
    }

    /**
     * What of its bodies counts in a step, or in what is left of it.
     *
     * @param ahead length of the next substep, seconds
     */
    void lookAhead(double ahead) {
        massA = bodyA.isSolved() ? a.inverseMass : 0;
        massB = bodyB.isSolved() ? b.inverseMass : 0;
        leadA = lead(bodyA, a, solidA, 0, ahead);
        leadB = lead(bodyB, b, solidB, 3, ahead);
    }

    /**
     * A corner of a body that spins fast goes on a bow: its speed in the middle of the substep counts, when it has turned by half of it. Where
     * something round rolls, the point of contact stays where it is.
     */
    private double lead(Body body, SolverBody solver, int solid, int frame, double ahead) {
        return solver.turning() * ahead > SPINNING && body.isCorner(solid, own[frame], own[frame + 1], own[frame + 2]) ? ahead / 2 : 0;
    }

    /** Whether one of both solids moves in its body. */
    boolean isDriven() {
        return bodyA.inner().moves(solidA) || bodyB.inner().moves(solidB);
    }

    /**
     * How fast solids that move in their bodies come together at a point, m/s: at this speed the bodies have to part there.
     *
     * @param d has a unit direction, world frame, three numbers from {@code i} on: from the second to the first where they come together
     * @param gone how much of the step is over, seconds
     */
    double driven(double[] d, int i, double x, double y, double z, double gone) {
        double ofA = bodyA.inner().moves(solidA) ? bodyA.inner().speed(solidA, a.place, d, i, x, y, z, gone) : 0;
        double ofB = bodyB.inner().moves(solidB) ? bodyB.inner().speed(solidB, b.place, d, i, x, y, z, gone) : 0;
        return ofB - ofA;
    }

    /** Whether one of both solids yields on a hinge; if so, {@code levers} are theirs. */
    boolean yields(HingeLevers levers) {
        levers.set(bodyA.inner().hinge(solidA), bodyB.inner().hinge(solidB));
        return levers.any();
    }

    /** Sets by which levers their hinges bring them together at a point along a direction, as {@link #driven}. */
    void setLevers(HingeLevers levers, int row, double[] d, int i, double x, double y, double z, double gone) {
        levers.setRow(row, -bodyA.inner().lever(solidA, a.place, d, i, x, y, z, gone),
            bodyB.inner().lever(solidB, b.place, d, i, x, y, z, gone));
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
