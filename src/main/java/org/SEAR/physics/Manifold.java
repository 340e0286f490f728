// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.Arrays;
import org.SEAR.physics.solid.Surface;

/**
 * Contact manifold of two solids: one normal, up to four points, and the impulses kept from step to step.
 * {@link ContactRows} holds its numbers during a step. Simulation thread.
 */
final class Manifold {
    static final int MAX_POINTS = 4;
    private static final int OWN = 6;
    /** Distance below which a point matches a former one, metres. */
    private static final double NEAR = 0.02;
    /**
     * Weight of 1 - cosine of the angle between two normals against the squared distance of their points, m^2. A ball
     * touches several faces of a mesh in nearly the same point; the impulse of a face stays with that face.
     */
    private static final double OTHER_NORMAL = 1;
    /** Smallest cosine between the normals of a manifold and its former one. */
    private static final double SIMILAR = 0.9;
    /** Rotation per substep above which a body spins fast, radians. */
    private static final double SPINNING = 0.02;
    /** Distance of the centre of pressure from the middle of the points at which its direction counts, as a share. */
    private static final double EDGE = 0.6;
    /** Cosine between directions of the load within which the points stay (3 degrees). */
    private static final double SAME_LOAD = 0.9986;

    /** Contact point, or one that may become one within the step. Simulation thread. */
    static final class Point {
        /** Position on the second body when found, world frame, metres. */
        double x;
        double y;
        double z;
        /** Gap when found, metres; negative: penetration. */
        double found;
        /** Normal impulse of the last substep, N s. */
        double impulse;
        /** Gap at the end of the last step, metres. */
        double gap;
    }

    SolverBody a;
    SolverBody b;
    Body bodyA;
    Body bodyB;
    /** Indices of the colliding parts in {@link Body#place}. */
    int partA;
    int partB;
    /** Indices of their solids in their bodies. */
    int solidA;
    int solidB;
    /** Normal from b to a, length 1, world frame. */
    double nx;
    double ny;
    double nz;
    int count;
    final Point[] points = {new Point(), new Point(), new Point(), new Point()};
    /**
     * Local coordinates that match points between steps: {x, y, z} of each in the first body's frame, then in the
     * second's.
     */
    private final double[] own = new double[MAX_POINTS * OWN];
    /** Coefficients of the pair. */
    double friction;
    double restitution;
    /** Coefficient of rolling friction; 0 if no body rolls. */
    double rolling;
    /** Whether neither body is round or a robot: then they can rock on edges and corners. */
    boolean rocks;
    /** Inverse masses, 1/kg; 0 for a body that does not move in this step. */
    double massA;
    double massB;
    /** Length of the substep of the impulses, seconds. */
    double seconds;
    /** Whether the impulses are those of an impact, which is not warm started. */
    boolean impact;
    /** Time by which each body's lever arm is rotated ahead, seconds. */
    double leadA;
    double leadB;
    /** Direction of the load for which the points were chosen, world frame, length 1; zeros if that does not matter. */
    private final double[] load = new double[3];
    /** Middle of a base with more than four corners, otherwise of the points, world frame, metres. */
    final double[] middle = new double[3];
    /** Whether the base has more than four corners. */
    private boolean manyCorners;
    /** From the middle of the points to the centre of pressure, metres. */
    private final double[] pressed = new double[3];
    /** Buffer for a lever arm. */
    final double[] arm = new double[3];
    /** Friction impulse against sliding, N s, world frame. */
    double fx;
    double fy;
    double fz;
    /** Friction impulse against spinning about the normal, N m s. */
    double turned;
    /** Friction impulse against rolling, N m s, world frame. */
    double rollX;
    double rollY;
    double rollZ;

    /**
     * Combines the coefficients of both surfaces: friction by product, restitution by maximum, rolling friction by sum.
     */
    void setSurfaces(Surface ofA, Surface ofB) {
        friction = ofA.friction(bodyA.isRobot()) * ofB.friction(bodyB.isRobot());
        restitution = Math.max(ofA.restitution(), ofB.restitution());
        boolean rolls = bodyA.canRoll() || bodyB.canRoll();
        rolling = rolls ? ofA.rollingFriction() + ofB.rollingFriction() : 0;
        rocks = !rolls && !bodyA.isRobot() && !bodyB.isRobot();
    }

    /**
     * Sets the direction of the load for which its points are chosen; null if that does not matter.
     * @param ofBase middle of a base with more than four corners, world frame, metres; null for other bases
     */
    void setLoad(double[] direction, double[] ofBase) {
        for (int i = 0; i < 3; i++) {
            load[i] = direction == null ? 0 : direction[i];
        }
        manyCorners = ofBase != null;
        if (manyCorners) {
            System.arraycopy(ofBase, 0, middle, 0, middle.length);
        }
    }

    /** Finds the middle of the points, unless the base has more than four corners: only some of them are points. */
    void findMiddle() {
        if (manyCorners) {
            return;
        }
        Arrays.fill(middle, 0);
        for (int i = 0; i < count; i++) {
            middle[0] += points[i].x / count;
            middle[1] += points[i].y / count;
            middle[2] += points[i].z / count;
        }
    }

    /**
     * Sets the direction of the load for the next choice of points. While the centre of pressure is far from the edge,
     * the points stay.
     * @return false if the load does not matter
     */
    boolean load(double[] into) {
        boolean edge = isAtEdge();
        double[] from = edge ? pressed : load;
        double length = Math.sqrt(from[0] * from[0] + from[1] * from[1] + from[2] * from[2]);
        for (int i = 0; i < 3 && length > 0; i++) {
            into[i] = from[i] / length;
        }
        return length > 0;
    }

    /** Whether the load tips the body in a direction other than that for which the points were chosen. */
    boolean isLoadedElsewhere() {
        if (load[0] == 0 && load[1] == 0 && load[2] == 0 || !isAtEdge()) {
            return false;
        }
        double along = load[0] * nx + load[1] * ny + load[2] * nz;
        double length = Math.sqrt(pressed[0] * pressed[0] + pressed[1] * pressed[1] + pressed[2] * pressed[2])
            * Math.sqrt(Math.max(0, 1 - along * along));
        return load[0] * pressed[0] + load[1] * pressed[1] + load[2] * pressed[2] <= SAME_LOAD * length;
    }

    /** Finds the centre of pressure; returns whether it is near the edge. */
    private boolean isAtEdge() {
        double total = 0;
        double furthest = 0;
        for (int i = 0; i < count; i++) {
            total += points[i].impulse;
        }
        for (int axis = 0; axis < 3; axis++) {
            pressed[axis] = 0;
        }
        if (total <= 0 || load[0] == 0 && load[1] == 0 && load[2] == 0) {
            return false;
        }
        findMiddle();
        for (int i = 0; i < count; i++) {
            double x = points[i].x - middle[0];
            double y = points[i].y - middle[1];
            double z = points[i].z - middle[2];
            furthest = Math.max(furthest, x * x + y * y + z * z);
            pressed[0] += points[i].impulse / total * x;
            pressed[1] += points[i].impulse / total * y;
            pressed[2] += points[i].impulse / total * z;
        }
        double square = pressed[0] * pressed[0] + pressed[1] * pressed[1] + pressed[2] * pressed[2];
        return manyCorners ? square > EDGE * extent() : square > EDGE * EDGE * furthest;
    }

    /** Returns how far the points reach from the middle towards the centre of pressure, times its distance, m^2. */
    private double extent() {
        double extent = 0;
        for (int i = 0; i < count; i++) {
            extent = Math.max(extent, pressed[0] * (points[i].x - middle[0]) + pressed[1] * (points[i].y - middle[1])
                + pressed[2] * (points[i].z - middle[2]));
        }
        return extent;
    }

    /**
     * Adds a point.
     * @param x on the second body, metres, world frame, likewise y and z
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

    /**
     * Passes its impulses on to the new manifolds of the same solids (warm starting). Each point's impulse goes to the
     * nearest new point with a similar normal, or is distributed evenly if none is near. No impulse goes to two points:
     * together they would throw the bodies apart.
     * @param to manifolds, of which those from {@code first} to before {@code end} are the new ones
     */
    void passOn(Manifold[] to, int first, int end) {
        Manifold similar = null;
        double most = SIMILAR;
        for (int k = first; k < end; k++) {
            double cosine = cosine(to[k]);
            if (cosine >= most) {
                most = cosine;
                similar = to[k];
            }
        }
        if (similar == null) {
            return;
        }
        Manifold main = similar;
        double largest = 0;
        double lost = 0;
        for (int i = 0; i < count; i++) {
            double impulse = points[i].impulse;
            Manifold taker = impulse > 0 ? passOn(i, to, first, end) : null;
            if (taker == null) {
                lost += impulse;
            } else if (impulse > largest) {
                largest = impulse;
                main = taker;
            }
        }
        for (int i = 0; i < similar.count && lost > 0; i++) {
            similar.points[i].impulse += lost / similar.count;
        }
        similar.take(this);
        main.takeFriction(this);
    }

    /** Passes on a point's impulse to the nearest new point; returns its manifold, or null if no point is near. */
    private Manifold passOn(int point, Manifold[] to, int first, int end) {
        Manifold taker = null;
        Point nearest = null;
        double least = Double.POSITIVE_INFINITY;
        for (int k = first; k < end; k++) {
            Manifold next = to[k];
            for (int i = 0; i < next.count && cosine(next) >= SIMILAR; i++) {
                double square = Math.min(next.square(i, this, point, 0), next.square(i, this, point, 3));
                double score = square + OTHER_NORMAL * (1 - cosine(next));
                if (square < NEAR * NEAR && score < least) {
                    least = score;
                    nearest = next.points[i];
                    taker = next;
                }
            }
        }
        if (taker != null) {
            nearest.impulse += points[point].impulse;
            taker.take(this);
        }
        return taker;
    }

    private double cosine(Manifold other) {
        return nx * other.nx + ny * other.ny + nz * other.nz;
    }

    private void take(Manifold from) {
        seconds = Math.max(seconds, from.seconds);
        impact |= from.impact;
    }

    private void takeFriction(Manifold from) {
        take(from);
        fx += from.fx;
        fy += from.fy;
        fz += from.fz;
        turned += from.turned;
        rollX += from.rollX;
        rollY += from.rollY;
        rollZ += from.rollZ;
    }

    /**
     * Returns the squared distance to a point of another manifold, m^2, in the frame of the first body (0) or the
     * second (3).
     */
    private double square(int i, Manifold from, int k, int frame) {
        int at = i * OWN + frame;
        int other = k * OWN + frame;
        double x = own[at] - from.own[other];
        double y = own[at + 1] - from.own[other + 1];
        double z = own[at + 2] - from.own[other + 2];
        return x * x + y * y + z * z;
    }

    /** Makes the present gaps the found ones, for a step without a new search. */
    void settle() {
        for (int i = 0; i < count; i++) {
            points[i].found = points[i].gap;
        }
    }

    /** Clears the impulses. */
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
     * Updates the inverse masses and the lead times.
     * @param ahead length of the next substep, seconds
     */
    void lookAhead(double ahead) {
        massA = bodyA.isSolved() ? a.inverseMass : 0;
        massB = bodyB.isSolved() ? b.inverseMass : 0;
        leadA = lead(bodyA, a, solidA, 0, ahead);
        leadB = lead(bodyB, b, solidB, 3, ahead);
    }

    /**
     * Returns the lead time: a corner of a fast spinning body moves on an arc, so its velocity at half of the substep
     * counts. The contact point of a rolling body stays.
     */
    private double lead(Body body, SolverBody solver, int solid, int frame, double ahead) {
        return solver.turning() * ahead > SPINNING && body.isCorner(solid, own[frame], own[frame + 1], own[frame + 2])
            ? ahead / 2 : 0;
    }

    /** Returns the smallest gap of its points, metres. */
    double gap() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, points[i].gap);
        }
        return least;
    }

    /** Index of the touching solid if the first body is a robot, else 0. */
    int numberA() {
        return bodyA.isRobot() ? solidA : 0;
    }

    /** Index of the touching solid if the second body is a robot, else 0. */
    int numberB() {
        return bodyB.isRobot() ? solidB : 0;
    }
}
