package org.SEAR.physics;

import java.util.Arrays;
import org.SEAR.physics.solid.HingeLevers;

/**
 * Contact constraints of an island during a step. All numbers are in one array, manifold after manifold, because the
 * rows of a large stack exceed the processor's cache. Each manifold has up to four normal constraints, and friction at
 * their centre. Solved by sequential impulses with warm starting. A bounded bias speed corrects penetrations; the
 * relaxing pass removes it from the velocities (soft step: Catto, Solver2D 2024; small steps: Macklin 2019). Simulation
 * thread.
 */
final class ContactRows {
    /** Rate of the position correction, 1/s. */
    private static final double RECOVERY = 8;
    /** Largest speed of the position correction, m/s. */
    private static final double MAX_RECOVERY = 1;
    /** Largest share of a penetration that one substep corrects. */
    private static final double MAX_SHARE = 0.2;
    /** Linear slop: gap between surfaces at rest, metres. */
    static final double LINEAR_SLOP = 1e-4;
    /** Penetration above which a contact is deep and is resolved slowly, metres. */
    private static final double DEEP = 0.005;
    /**
     * Share of the warm-start impulse of a deep contact. Bodies wedged from two sides would otherwise build up impulses
     * and be thrown out when one contact opens.
     */
    private static final double DEEP_SHARE = 0.5;
    /** Largest penetration into a fixed body, as a share of the body's smallest half extent. */
    private static final double DEEPEST_SHARE = 0.5;

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
    /** Present gap, metres. */
    private static final int GAP = BASE + 1;
    /** Restitution impulse of this substep, N s; part of the friction limit. */
    private static final int RESTITUTION_IMPULSE = BASE + 2;
    /** Distance from the manifold's centre, metres. */
    private static final int LEVER = BASE + 3;
    /** 1 if the point will bounce at the end of this substep or later; no impulse brakes it before. */
    private static final int PENDING_RESTITUTION = BASE + 4;
    /** Approach speed due to solids that move in their bodies, m/s; 0 without such motion. */
    private static final int DRIVEN = BASE + 5;
    /** Numbers per point. */
    static final int POINT = BASE + 6;
    private static final int PATCH = POINTS + Manifold.MAX_POINTS * POINT;
    private static final int BLOCK = PATCH + FrictionRows.SIZE;
    private static final int SIZE = BLOCK + NormalBlock.SIZE;
    /** Rows per manifold with hinge levers: those of the points, then those of friction. */
    private static final int HINGED = Manifold.MAX_POINTS + FrictionRows.HINGED;

    private double[] data = {};
    private double[][] speedsA = {};
    private double[][] speedsB = {};
    private double[][] movedA = {};
    private double[][] movedB = {};
    /** Direction out of a fixed body: 1 along the normal, -1 against it, 0 if neither body is fixed. */
    private byte[] out = {};
    private Manifold[] manifolds = {};
    /** Hinge levers of each manifold; null without hinges. The objects of a slot are reused. */
    private HingeLevers[] levers = {};
    private HingeLevers[] kept = {};
    /** Points of each manifold; 0 in an empty slot. */
    private int[] points = {};
    private int size;
    /** Whether a contact of the island has a restitution. */
    private boolean bounces;
    /** Elapsed time of the step, seconds: solids that move in their bodies take their new poses at its end. */
    private double gone;
    private final NormalBlock block = new NormalBlock();

    /** Begins the step of an island. */
    void clear() {
        gone = 0;
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
            levers = Arrays.copyOf(levers, more);
            kept = Arrays.copyOf(kept, more);
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
        data[at + LOOSE] = of.massA > 0 && of.massB > 0 && of.bodyA.solids.size() == 1 && of.bodyB.solids.size() == 1 ? 1 : 0;
        data[at + SECONDS] = of.seconds;
        data[at + FRICTION] = of.friction;
        data[at + RESTITUTION] = of.restitution;
        double mx = 0;
        double my = 0;
        double mz = 0;
        for (int i = 0; i < of.count; i++) {
            mx += of.points[i].x / of.count;
            my += of.points[i].y / of.count;
            mz += of.points[i].z / of.count;
        }
        boolean driven = of.isDriven();
        levers[slot] = driven ? levers(slot, of) : null;
        for (int i = 0; i < of.count; i++) {
            fill(at + POINTS + i * POINT, of, of.points[i], driven, mx, my, mz);
            if (levers[slot] != null) {
                giveWay(levers[slot], i, at + POINTS + i * POINT, of);
            }
        }
        FrictionRows.prepare(data, at + PATCH, of, mx, my, mz, gone, levers[slot]);
        data[at + READY] = 0;
        data[at + IMPACT] = of.impact ? 1 : 0;
    }

    private void fill(int at, Manifold of, Manifold.Point point, boolean driven, double mx, double my, double mz) {
        double half = point.found / 2;
        PairRow.prepare(data, at, of, of.nx, of.ny, of.nz, point.x + half * of.nx, point.y + half * of.ny, point.z + half * of.nz);
        data[at + PairRow.IMPULSE] = point.impulse;
        data[at + BASE] = point.found - PairRow.along(data, at, of.a.moved, of.b.moved);
        data[at + DRIVEN] = driven ? of.driven(data, at, point.x, point.y, point.z, gone) : 0;
        data[at + GAP] = point.found - data[at + DRIVEN] * gone;
        data[at + RESTITUTION_IMPULSE] = 0;
        double dx = point.x - mx;
        double dy = point.y - my;
        double dz = point.z - mz;
        data[at + LEVER] = Math.sqrt(dx * dx + dy * dy + dz * dz);
        data[at + PENDING_RESTITUTION] = 0;
    }

    private HingeLevers levers(int slot, Manifold of) {
        if (kept[slot] == null) {
            kept[slot] = new HingeLevers(HINGED);
        }
        return of.yields(kept[slot]) ? kept[slot] : null;
    }

    private void giveWay(HingeLevers by, int row, int point, Manifold of) {
        of.setLevers(by, row, data, point, of.points[row].x, of.points[row].y, of.points[row].z, gone);
        data[point + PairRow.MASS] = by.mass(row, data[point + PairRow.MASS]);
        data[point + GAP] -= by.way(row);
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
                        applyImpulse(slot, i, point, data[point + PairRow.IMPULSE]);
                    }
                }
                if (FrictionRows.holds(data, at + PATCH)) {
                    FrictionRows.warmStart(data, at + PATCH, this, slot, scale);
                }
            }
        }
        gone += seconds;
    }

    /** Updates the gaps. */
    private void measure(int slot) {
        double[] p = movedA[slot];
        double[] q = movedB[slot];
        for (int i = 0; i < points[slot]; i++) {
            int point = slot * SIZE + POINTS + i * POINT;
            data[point + GAP] = data[point + BASE] + PairRow.along(data, point, p, q) - data[point + DRIVEN] * gone
                - (levers[slot] == null ? 0 : levers[slot].way(i));
        }
    }

    /**
     * Solves one pass with position correction.
     * @param last whether it is the last one before the bodies move
     */
    void solveBiased(boolean last) {
        for (int slot = 0; slot < size; slot++) {
            if (points[slot] > 0) {
                solve(slot, true);
                if (last) {
                    mark(slot);
                }
            }
        }
    }

    /**
     * Solves one pass without position correction.
     * @param first whether the bodies have moved since the last pass
     */
    void relax(boolean first) {
        for (int slot = 0; slot < size; slot++) {
            if (points[slot] > 0) {
                if (first) {
                    measure(slot);
                    if (out[slot] != 0) {
                        stayOut(slot);
                    }
                }
                solve(slot, false);
            }
        }
    }

    private void solve(int slot, boolean recovers) {
        int at = slot * SIZE;
        int count = points[slot];
        double pressing = 0;
        double turning = 0;
        HingeLevers by = levers[slot];
        boolean all = count > 1 && by == null;
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
            block.wanted[i] = (gap > LINEAR_SLOP ? -(gap - LINEAR_SLOP) / seconds : 0) + (recovers
                ? recovery(Math.min(gap, LINEAR_SLOP), seconds) : 0)
                + data[point + DRIVEN];
            parting = parting && PairRow.along(data, point, p, q) >= block.wanted[i] + (by == null ? 0 : by.speed(i));
        }
        if (parting || all && solveAll(at, count, p, q, recovers)) {
            return;
        }
        for (int i = 0; i < count; i++) {
            int point = at + POINTS + i * POINT;
            if (data[point + PENDING_RESTITUTION] == 0) {
                double missing = PairRow.missing(data, point, p, q, block.wanted[i] + (by == null ? 0 : by.speed(i)));
                if (recovers) {
                    notice(at, missing / data[point + PairRow.MASS]);
                }
                double sum = Math.max(0, data[point + PairRow.IMPULSE] + missing);
                applyImpulse(slot, i, point, sum - data[point + PairRow.IMPULSE]);
                data[point + PairRow.IMPULSE] = sum;
            }
        }
    }

    private void notice(int at, double speed) {
        if (speed > IMPACT_SPEED && data[at + IMPACT] == 0) {
            data[at + IMPACT] = 1;
        }
    }

    private boolean solveAll(int at, int count, double[] p, double[] q, boolean recovers) {
        if (data[at + READY] == 0) {
            data[at + READY] = 1;
            block.prepare(data, at + BLOCK, at + POINTS, count, data[at + MASS_A], data[at + MASS_B]);
        }
        if (!block.solve(data, at + BLOCK, at + POINTS, count, p, q, data[at + MASS_A], data[at + MASS_B])) {
            return false;
        }
        if (recovers) {
            notice(at, block.fastest);
        }
        return true;
    }

    private static double recovery(double gap, double seconds) {
        return Math.min(MAX_RECOVERY, -gap * Math.min(RECOVERY, MAX_SHARE / seconds));
    }

    /**
     * Limits the penetration into a fixed body to half of the smallest half extent; beyond its centre the body would
     * come out on the far side.
     */
    private void stayOut(int slot) {
        Manifold of = manifolds[slot];
        Body body = out[slot] > 0 ? of.bodyA : of.bodyB;
        double deepest = gap(slot) + DEEPEST_SHARE * body.getLeast();
        if (deepest < 0 && body.isSolved()) {
            body.getSolver().lift(out[slot] * of.nx, out[slot] * of.ny, out[slot] * of.nz, -deepest);
            measure(slot);
        }
    }

    /** Returns the smallest gap of its points, metres. */
    private double gap(int slot) {
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
        boolean driven = false;
        for (int i = 0; i < points[slot]; i++) {
            int point = at + POINTS + i * POINT;
            pushes |= data[point + PairRow.IMPULSE] > 0 || data[point + RESTITUTION_IMPULSE] > 0;
            driven |= data[point + DRIVEN] > 0;
        }
        if (!driven && gap(slot) < -DEEP) {
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

    /**
     * Applies an impulse along a row to both bodies, N s.
     * @param number index of the row in its manifold
     */
    void applyImpulse(int slot, int number, int row, double impulse) {
        if (levers[slot] != null) {
            levers[slot].push(number, impulse);
        }
        PairRow.applyImpulse(data, row, speedsA[slot], speedsB[slot], data[slot * SIZE + MASS_A], data[slot * SIZE + MASS_B], impulse);
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

    /** Present gap at a point, metres. */
    double gap(int slot, int i) {
        return data[slot * SIZE + POINTS + i * POINT + GAP];
    }

    /** Returns the separating speed at a point, m/s. */
    double parting(int slot, int i) {
        int point = slot * SIZE + POINTS + i * POINT;
        return PairRow.along(data, point, speedsA[slot], speedsB[slot]) - data[point + DRIVEN] - yielding(slot, i);
    }

    /** Hinge levers of a slot; null without hinges. */
    HingeLevers levers(int slot) {
        return levers[slot];
    }

    /** Returns the approach speed along a row due to deviations of hinges from their plan, m/s. */
    private double yielding(int slot, int number) {
        return levers[slot] == null ? 0 : levers[slot].speed(number);
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
        double sum = Math.max(0, impact + PairRow.missing(data, point, speedsA[slot], speedsB[slot], speed + data[point
            + DRIVEN] + yielding(slot, i)));
        applyImpulse(slot, i, point, sum - impact);
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

    /**
     * Block solver for all normal constraints of a manifold, used while all points push, as they do at rest: sequential
     * solving would rock the bodies. Loose solids with a point that did not push in the last pass skip it, since that
     * point would nearly always have to pull. The matrix of four coplanar points has rank three; a small softness
     * distributes the rest evenly. The array also holds the factor.
     */
    private static final class NormalBlock {
        private static final int MOST = Manifold.MAX_POINTS;
        static final int SIZE = MOST * MOST;
        /** Softness: relative increase of the diagonal. */
        private static final double SOFT = 1e-3;

        /** Required separating speed of each point, m/s. */
        final double[] wanted = new double[MOST];
        /** Largest missing separating speed of a point in the last solve, m/s. */
        double fastest;
        private final double[] work = new double[SIZE];
        private final double[] sum = new double[MOST];

        /**
         * Factors the matrix of a manifold's points.
         * @param at start of the factor in the array
         * @param points start of the points' rows, one per {@link ContactRows#POINT}
         */
        void prepare(double[] r, int at, int points, int n, double massA, double massB) {
            for (int i = 0; i < n; i++) {
                for (int k = 0; k <= i; k++) {
                    double yields = PairRow.yields(r, points + i * POINT, points + k * POINT, massA, massB);
                    work[i * MOST + k] = i == k ? yields * (1 + SOFT) : yields;
                }
            }
            factor(r, at, n);
        }

        /** Computes the Cholesky factor with reciprocals of the diagonal, because divisions dominate the cost. */
        private void factor(double[] r, int at, int n) {
            for (int i = 0; i < n; i++) {
                for (int k = 0; k <= i; k++) {
                    double rest = work[i * MOST + k];
                    for (int j = 0; j < k; j++) {
                        rest -= r[at + i * MOST + j] * r[at + k * MOST + j];
                    }
                    r[at + i * MOST + k] = i == k ? 1 / Math.sqrt(rest) : rest * r[at + k * MOST + k];
                }
            }
        }

        /**
         * Solves for the speeds in {@link #wanted}.
         * @return false, and changes nothing, if a point would have to pull
         */
        boolean solve(double[] r, int at, int points, int n, double[] p, double[] q, double massA, double massB) {
            fastest = 0;
            for (int i = 0; i < n; i++) {
                sum[i] = wanted[i] - PairRow.along(r, points + i * POINT, p, q);
                fastest = Math.max(fastest, sum[i]);
            }
            for (int i = 0; i < n; i++) {
                double rest = sum[i];
                for (int k = 0; k < i; k++) {
                    rest -= r[at + i * MOST + k] * sum[k];
                }
                sum[i] = rest * r[at + i * MOST + i];
            }
            for (int i = n - 1; i >= 0; i--) {
                double rest = sum[i];
                for (int k = i + 1; k < n; k++) {
                    rest -= r[at + k * MOST + i] * sum[k];
                }
                sum[i] = rest * r[at + i * MOST + i];
                work[i] = r[points + i * POINT + PairRow.IMPULSE] + sum[i];
                if (work[i] < 0) {
                    return false;
                }
            }
            for (int i = 0; i < n; i++) {
                int point = points + i * POINT;
                PairRow.applyImpulse(r, point, p, q, massA, massB, work[i] - r[point + PairRow.IMPULSE]);
                r[point + PairRow.IMPULSE] = work[i];
            }
            return true;
        }
    }
}
