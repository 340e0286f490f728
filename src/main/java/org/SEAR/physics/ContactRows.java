// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.Arrays;

/**
 * Contact constraints of an island during a step. All numbers are in one array, manifold after manifold, because the
 * rows of a large stack exceed the processor's cache. Each manifold has up to four normal constraints, and friction at
 * their centre. Solved by sequential impulses with warm starting in small substeps (Macklin 2019, "Small steps in
 * physics simulation"). Velocities contain no position correction; {@link PositionCorrection} resolves penetrations
 * after the bodies have moved. Simulation thread.
 */
final class ContactRows {
    /** Linear slop: gap between surfaces at rest, metres. */
    static final double LINEAR_SLOP = 1e-4;
    /** Penetration above which a contact is deep and is resolved slowly, metres. */
    private static final double DEEP = 0.005;
    /**
     * Share of the warm-start impulse of a deep contact. Bodies wedged from two sides would otherwise build up impulses
     * and be thrown out when one contact opens.
     */
    private static final double DEEP_SHARE = 0.5;
    /**
     * Approach speed, beyond what warm starting stops, m/s, above which a contact is an impact; an isolated body then
     * drops its warm-start impulse.
     */
    private static final double IMPACT_SPEED = 0.3;

    private static final int MASS_A = 3;
    private static final int MASS_B = 4;
    /** Length of the substep of the impulses, seconds. */
    private static final int SECONDS = 5;
    private static final int FRICTION = 6;
    private static final int RESTITUTION = 7;
    /** 1 if the block is factored; done at its first use. */
    private static final int READY = 8;
    /** 1 after an impact in this substep, -1 after one in the last substep. */
    private static final int IMPACT = 9;
    /** 1 if both bodies are movable single solids. */
    private static final int LOOSE = 10;
    private static final int POINTS = 11;
    /** Gap for zero displacement of both bodies in this step, metres. */
    private static final int BASE = PairRow.SIZE;
    /** Current gap, metres. */
    private static final int GAP = BASE + 1;
    /** Restitution impulse of this substep, N s; part of the friction limit. */
    private static final int RESTITUTION_IMPULSE = BASE + 2;
    /** Distance from the manifold's centre, metres. */
    private static final int LEVER = BASE + 3;
    /** 1 if the point will bounce at the end of this substep or later; no impulse brakes it before. */
    private static final int PENDING_RESTITUTION = BASE + 4;
    /** Numbers per point. */
    static final int POINT = BASE + 5;
    private static final int PATCH = POINTS + Manifold.MAX_POINTS * POINT;
    private static final int BLOCK = PATCH + FrictionRows.SIZE;
    private static final int SIZE = BLOCK + NormalBlock.SIZE;

    /** Impulses per manifold that the conjugate directions cover: points, two of friction, one against turning. */
    static final int IMPULSES = Manifold.MAX_POINTS + 3;

    private double[] data = {};
    private double[][] speedsA = {};
    private double[][] speedsB = {};
    private double[][] movedA = {};
    private double[][] movedB = {};
    /** Direction out of a fixed body: 1 along the normal, -1 against it, 0 if neither body is fixed. */
    private byte[] out = {};
    private Manifold[] manifolds = {};
    /** Points of each manifold; 0 in an empty slot. */
    private int[] points = {};
    private int size;
    /** Whether a contact of the island has a restitution. */
    private boolean bounces;
    /** Largest velocity change at a contact in the last pass, m/s. */
    private double residual;
    private final NormalBlock block = new NormalBlock();

    /** Begins the step of an island. */
    void clear() {
        size = 0;
        bounces = false;
    }

    boolean hasBouncing() {
        return bounces;
    }

    /** Number of slots, including empty ones. */
    int size() {
        return size;
    }

    /** Adds an empty slot and returns its number. */
    int add() {
        if (size == points.length) {
            int more = 2 * size + 16;
            data = Arrays.copyOf(data, more * SIZE);
            speedsA = Arrays.copyOf(speedsA, more);
            speedsB = Arrays.copyOf(speedsB, more);
            movedA = Arrays.copyOf(movedA, more);
            movedB = Arrays.copyOf(movedB, more);
            out = Arrays.copyOf(out, more);
            manifolds = Arrays.copyOf(manifolds, more);
            points = Arrays.copyOf(points, more);
        }
        points[size] = 0;
        return size++;
    }

    /** Empties a slot. */
    void drop(int slot) {
        points[slot] = 0;
    }

    /**
     * Sets up the rows of a manifold.
     * @param ahead length of the next substep, seconds
     */
    void fill(int slot, Manifold of, double ahead) {
        int at = slot * SIZE;
        of.lookAhead(ahead);
        manifolds[slot] = of;
        speedsA[slot] = of.a.v;
        speedsB[slot] = of.b.v;
        movedA[slot] = of.a.moved;
        movedB[slot] = of.b.moved;
        out[slot] = (byte) (of.bodyB.isFixed() ? 1 : of.bodyA.isFixed() ? -1 : 0);
        bounces |= of.restitution > 0;
        points[slot] = of.count;
        data[at] = of.nx;
        data[at + 1] = of.ny;
        data[at + 2] = of.nz;
        data[at + MASS_A] = of.massA;
        data[at + MASS_B] = of.massB;
        data[at + LOOSE] = of.massA > 0 && of.massB > 0 && of.bodyA.isSingle() && of.bodyB.isSingle() ? 1 : 0;
        data[at + SECONDS] = of.seconds;
        data[at + FRICTION] = of.friction;
        data[at + RESTITUTION] = of.restitution;
        of.findMiddle();
        for (int i = 0; i < of.count; i++) {
            fill(at + POINTS + i * POINT, of, of.points[i]);
        }
        FrictionRows.prepare(data, at + PATCH, of, of.middle[0], of.middle[1], of.middle[2]);
        data[at + READY] = 0;
        data[at + IMPACT] = of.impact ? 1 : 0;
    }

    private void fill(int at, Manifold of, Manifold.Point point) {
        double half = point.found / 2;
        PairRow.prepare(data, at, of, of.nx, of.ny, of.nz, point.x + half * of.nx, point.y + half * of.ny,
            point.z + half * of.nz);
        data[at + PairRow.IMPULSE] = point.impulse;
        data[at + BASE] = point.found - PairRow.along(data, at, of.a.moved, of.b.moved);
        data[at + GAP] = point.found;
        data[at + RESTITUTION_IMPULSE] = 0;
        double dx = point.x - of.middle[0];
        double dy = point.y - of.middle[1];
        double dz = point.z - of.middle[2];
        data[at + LEVER] = Math.sqrt(dx * dx + dy * dy + dz * dz);
        data[at + PENDING_RESTITUTION] = 0;
    }

    /** Copies the impulses and gaps of a slot to its manifold. */
    void store(int slot) {
        int at = slot * SIZE;
        Manifold into = manifolds[slot];
        for (int i = 0; i < points[slot]; i++) {
            into.points[i].impulse = data[at + POINTS + i * POINT + PairRow.IMPULSE];
            into.points[i].gap = data[at + POINTS + i * POINT + GAP];
        }
        if (points[slot] > 0) {
            into.seconds = data[at + SECONDS];
            into.impact = data[at + IMPACT] > 0;
            FrictionRows.store(data, at + PATCH, into);
        }
    }

    /** Returns the normal impulse of all points of a slot in this substep, N s. */
    double pressing(int slot) {
        double sum = 0;
        for (int i = 0; i < points[slot]; i++) {
            int point = slot * SIZE + POINTS + i * POINT;
            sum += data[point + PairRow.IMPULSE] + data[point + RESTITUTION_IMPULSE];
        }
        return sum;
    }

    /**
     * Begins a substep and applies the impulses of the last one (warm starting). For an isolated body the impulse of an
     * impact is dropped, and no impulse grows with the length of the substep. In stacks a missing impulse would let all
     * bodies above fall.
     */
    void begin(double seconds, boolean alone) {
        for (int slot = 0; slot < size; slot++) {
            if (points[slot] > 0) {
                int at = slot * SIZE;
                measure(slot);
                boolean struck = alone && data[at + IMPACT] > 0;
                double scale = data[at + SECONDS] > 0 && !struck ? seconds / data[at + SECONDS] : 0;
                scale = alone ? Math.min(1, scale) : scale;
                scale = gap(slot) < -DEEP ? DEEP_SHARE * scale : scale;
                data[at + SECONDS] = seconds;
                data[at + IMPACT] = struck ? -1 : 0;
                for (int i = 0; i < points[slot]; i++) {
                    int point = at + POINTS + i * POINT;
                    if (data[point + PairRow.IMPULSE] != 0) {
                        data[point + PairRow.IMPULSE] *= scale;
                        applyImpulse(slot, point, data[point + PairRow.IMPULSE]);
                    }
                }
                if (FrictionRows.holds(data, at + PATCH)) {
                    FrictionRows.warmStart(data, at + PATCH, this, slot, scale);
                }
            }
        }
    }

    /** Passes the impulses of a slot with one point on to another one. */
    void passOn(int from, int to) {
        data[to * SIZE + SECONDS] = data[from * SIZE + SECONDS];
        data[impulseAt(to, 0)] += data[impulseAt(from, 0)];
        data[impulseAt(from, 0)] = 0;
        FrictionRows.passOn(data, from * SIZE + PATCH, to * SIZE + PATCH);
    }

    /** Updates the gaps of a slot. */
    void measure(int slot) {
        double[] p = movedA[slot];
        double[] q = movedB[slot];
        for (int i = 0; i < points[slot]; i++) {
            int point = slot * SIZE + POINTS + i * POINT;
            data[point + GAP] = data[point + BASE] + PairRow.along(data, point, p, q);
        }
    }

    /**
     * Solves one pass over all contacts.
     *
     * @param first whether it is the first pass of the substep, which meets approach speeds as they are
     */
    void solve(boolean first) {
        residual = 0;
        for (int slot = 0; slot < size; slot++) {
            if (points[slot] > 0) {
                solve(slot, first);
            }
        }
    }

    /** Ends the passes of a substep, before the bodies move. */
    void finish() {
        for (int slot = 0; slot < size; slot++) {
            if (points[slot] > 0) {
                mark(slot);
            }
        }
    }

    /** Returns the largest velocity change at a contact in the last pass, m/s. */
    double getResidual() {
        return residual;
    }

    /** Counts a velocity change at a contact, m/s. */
    void note(double change) {
        residual = Math.max(residual, Math.abs(change));
    }

    private void solve(int slot, boolean first) {
        int at = slot * SIZE;
        int count = points[slot];
        double pressing = 0;
        double turning = 0;
        boolean all = count > 1;
        boolean loose = data[at + LOOSE] > 0;
        for (int i = 0; i < count; i++) {
            int point = at + POINTS + i * POINT;
            double impulse = data[point + PairRow.IMPULSE] + data[point + RESTITUTION_IMPULSE];
            all &= (data[point + PairRow.IMPULSE] > 0 || !loose) && data[point + PENDING_RESTITUTION] == 0;
            pressing += impulse;
            turning += impulse * data[point + LEVER];
        }
        if (pressing > 0 || FrictionRows.holds(data, at + PATCH)) {
            double friction = data[at + FRICTION];
            FrictionRows.solve(data, at + PATCH, this, slot, friction * pressing, friction * turning, pressing);
        }
        double[] p = speedsA[slot];
        double[] q = speedsB[slot];
        boolean parting = pressing == 0;
        for (int i = 0; i < count; i++) {
            int point = at + POINTS + i * POINT;
            double gap = data[point + GAP];
            double seconds = data[at + SECONDS];
            block.wanted[i] = gap > LINEAR_SLOP ? -(gap - LINEAR_SLOP) / seconds : 0;
            parting = parting && PairRow.along(data, point, p, q) >= block.wanted[i];
        }
        if (parting || all && solveAll(at, count, p, q, first)) {
            return;
        }
        for (int i = 0; i < count; i++) {
            int point = at + POINTS + i * POINT;
            if (data[point + PENDING_RESTITUTION] == 0) {
                double missing = PairRow.missing(data, point, p, q, block.wanted[i]);
                if (first) {
                    notice(at, missing / data[point + PairRow.MASS]);
                }
                double sum = Math.max(0, data[point + PairRow.IMPULSE] + missing);
                note((sum - data[point + PairRow.IMPULSE]) / data[point + PairRow.MASS]);
                applyImpulse(slot, point, sum - data[point + PairRow.IMPULSE]);
                data[point + PairRow.IMPULSE] = sum;
            }
        }
    }

    private void notice(int at, double speed) {
        if (speed > IMPACT_SPEED && data[at + IMPACT] == 0) {
            data[at + IMPACT] = 1;
        }
    }

    private boolean solveAll(int at, int count, double[] p, double[] q, boolean first) {
        if (data[at + READY] == 0) {
            data[at + READY] = 1;
            block.prepare(data, at + BLOCK, at + POINTS, count, data[at + MASS_A], data[at + MASS_B]);
        }
        if (!block.solve(data, at + BLOCK, at + POINTS, count, p, q, data[at + MASS_A], data[at + MASS_B])) {
            return false;
        }
        note(block.change);
        if (first) {
            notice(at, block.fastest);
        }
        return true;
    }

    /** Returns the manifold of a slot. */
    Manifold manifold(int slot) {
        return manifolds[slot];
    }

    /** Returns 1 or -1 if the movable body leaves a fixed one along the normal or against it, otherwise 0. */
    int out(int slot) {
        return out[slot];
    }

    /**
     * Moves both bodies apart at a point by pseudo-velocities, without a change of their velocities.
     *
     * @param distance increase of the gap together with what they have moved apart so far, metres
     * @param impulse so far, kg m
     * @return impulse after the change, kg m, at least 0
     */
    double separate(int slot, int i, double distance, double impulse) {
        int at = slot * SIZE;
        int point = at + POINTS + i * POINT;
        double[] p = manifolds[slot].a.correction;
        double[] q = manifolds[slot].b.correction;
        double sum = Math.max(0, impulse + PairRow.missing(data, point, p, q, distance));
        PairRow.applyImpulse(data, point, p, q, data[at + MASS_A], data[at + MASS_B], sum - impulse);
        return sum;
    }

    /**
     * Returns where in the array an impulse of a slot is: those of the points, then two of friction, then the turning
     * one.
     */
    private int impulseAt(int slot, int i) {
        int at = slot * SIZE;
        return i < Manifold.MAX_POINTS ? at + POINTS + i * POINT + PairRow.IMPULSE
            : FrictionRows.impulseAt(at + PATCH, i - Manifold.MAX_POINTS);
    }

    /** Returns an impulse of a slot, N s or N m s: of its points, then two of friction, then that against turning. */
    double impulse(int slot, int i) {
        return data[impulseAt(slot, i)];
    }

    /** Adds to an impulse of a slot and applies the change to both bodies. */
    void addImpulse(int slot, int i, double more) {
        data[impulseAt(slot, i)] += more;
        if (i == IMPULSES - 1) {
            FrictionRows.twist(data, slot * SIZE + PATCH, this, slot, more);
        } else {
            applyImpulse(slot, impulseAt(slot, i) - PairRow.IMPULSE, more);
        }
    }

    /** Returns the smallest gap of its points, metres. */
    double gap(int slot) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < points[slot]; i++) {
            least = Math.min(least, data[slot * SIZE + POINTS + i * POINT + GAP]);
        }
        return least;
    }

    /** Marks bodies that a contact pushes, and bodies that penetrate each other deeply. */
    private void mark(int slot) {
        int at = slot * SIZE;
        Manifold of = manifolds[slot];
        boolean pushes = false;
        for (int i = 0; i < points[slot]; i++) {
            int point = at + POINTS + i * POINT;
            pushes |= data[point + PairRow.IMPULSE] > 0 || data[point + RESTITUTION_IMPULSE] > 0;
        }
        if (gap(slot) < -DEEP) {
            of.a.setDeep();
            of.b.setDeep();
        }
        if (pushes) {
            of.a.press(of.nx, of.ny, of.nz);
            of.b.press(of.nx, of.ny, of.nz);
        } else if (FrictionRows.holds(data, at + PATCH)) {
            // without normal impulse no friction: releases what a former normal impulse allowed
            FrictionRows.solve(data, at + PATCH, this, slot, 0, 0, 0);
        }
    }

    /** Applies an impulse along a row to both bodies, N s. */
    void applyImpulse(int slot, int row, double impulse) {
        PairRow.applyImpulse(data, row, speedsA[slot], speedsB[slot], data[slot * SIZE + MASS_A],
            data[slot * SIZE + MASS_B], impulse);
    }

    /** Applies an angular impulse to both bodies, N m s. */
    void twist(int slot, double x, double y, double z) {
        if (data[slot * SIZE + MASS_A] > 0) {
            manifolds[slot].a.twist(x, y, z);
        }
        if (data[slot * SIZE + MASS_B] > 0) {
            manifolds[slot].b.twist(-x, -y, -z);
        }
    }

    double[] speedsA(int slot) {
        return speedsA[slot];
    }

    double[] speedsB(int slot) {
        return speedsB[slot];
    }

    /** Restitution of a slot; 0 if it is empty. */
    double restitution(int slot) {
        return points[slot] > 0 ? data[slot * SIZE + RESTITUTION] : 0;
    }

    /** Points of a slot; 0 if it is empty. */
    int points(int slot) {
        return points[slot];
    }

    /** Current gap at a point, metres. */
    double gap(int slot, int i) {
        return data[slot * SIZE + POINTS + i * POINT + GAP];
    }

    /** Returns the separating speed at a point, m/s. */
    double parting(int slot, int i) {
        int point = slot * SIZE + POINTS + i * POINT;
        return PairRow.along(data, point, speedsA[slot], speedsB[slot]);
    }

    /** Defers a point until it bounces: no impulse brakes it before. */
    void await(int slot, int i) {
        data[slot * SIZE + POINTS + i * POINT + PENDING_RESTITUTION] = 1;
    }

    /** Clears the restitution impulses of the last substep. */
    void clearRestitution(int slot) {
        for (int i = 0; i < points[slot]; i++) {
            int point = slot * SIZE + POINTS + i * POINT;
            data[point + RESTITUTION_IMPULSE] = 0;
            data[point + PENDING_RESTITUTION] = 0;
        }
    }

    /**
     * Adds to an impact impulse until the separating speed at a point is at least {@code speed}.
     * @param impact impulse so far, N s
     * @param speed m/s
     * @return the new impulse, N s
     */
    double rebound(int slot, int i, double impact, double speed) {
        int point = slot * SIZE + POINTS + i * POINT;
        double sum = Math.max(0, impact + PairRow.missing(data, point, speedsA[slot], speedsB[slot], speed));
        applyImpulse(slot, point, sum - impact);
        return sum;
    }

    /** Adds a finished impact impulse to the restitution impulse, which counts for friction. */
    void endImpact(int slot, int i, double impact) {
        data[slot * SIZE + POINTS + i * POINT + RESTITUTION_IMPULSE] += impact;
    }

    /** Returns the normal acceleration due to gravity, from b to a, m/s^2; fixed bodies do not fall. */
    double falling(int slot, double gravity) {
        int at = slot * SIZE;
        return data[at + 1] * ((data[at + MASS_B] > 0 ? gravity : 0) - (data[at + MASS_A] > 0 ? gravity : 0));
    }
}
