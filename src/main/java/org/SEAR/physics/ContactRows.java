package org.SEAR.physics;

import java.util.Arrays;
import org.SEAR.physics.solid.HingeLevers;

/**
 * The contacts of an island while a step is solved, manifold after manifold in one array of numbers, for a pile has more of them than a processor
 * keeps at hand. Each keeps up to four points apart and has friction at their middle. Solved by sequential impulses with warm starting; penetration
 * is taken back by a bounded speed that the relaxing pass takes out of the velocities again (soft step: Catto, Solver2D 2024; small steps: Macklin
 * 2019). Simulation thread.
 */
final class ContactRows {
    /** Share of a penetration that is taken back in a second, 1/s. */
    private static final double RECOVERY = 8;
    /** The speed at which a penetration is taken back at most, m/s. */
    private static final double MAX_RECOVERY = 1;
    /** The share of a penetration that a substep may take back. */
    private static final double MAX_SHARE = 0.2;
    /** Surfaces rest so far apart, metres. */
    static final double LINEAR_SLOP = 1e-4;
    /** What is deeper in another than this comes out slowly, metres. */
    private static final double DEEP = 0.005;
    /** And begins with this share of its push: what is in others from two sides would press ever harder, and be thrown when one of them lets go. */
    private static final double DEEP_SHARE = 0.5;
    /** How deep something may be in what is fixed, as a share of its own least half size. */
    private static final double DEEPEST_SHARE = 0.5;

    /** What comes faster than this when all pushes that are already push, m/s, hits: where it is alone, what stops it pushes no more. */
    private static final double IMPACT_SPEED = 0.3;

    private static final int MASS_A = 3;
    private static final int MASS_B = 4;
    /** Length of the substep that the impulses belong to, seconds. */
    private static final int SECONDS = 5;
    private static final int FRICTION = 6;
    private static final int RESTITUTION = 7;
    /** 1 if the block is made: it is when it is first needed. */
    private static final int READY = 8;
    /** 1 if something hit in this substep, -1 if in the last one. */
    private static final int IMPACT = 9;
    /** 1 if both are single solids that move. */
    private static final int LOOSE = 10;
    private static final int POINTS = 11;
    /** What the distance would be if neither had moved in this step, metres. */
    private static final int BASE = PairRow.SIZE;
    /** Present distance of both surfaces here, metres. */
    private static final int GAP = BASE + 1;
    /** What it took to throw them apart in this substep, Ns: friction counts it, too. */
    private static final int RESTITUTION_IMPULSE = BASE + 2;
    /** How far from the manifold's middle, metres. */
    private static final int LEVER = BASE + 3;
    /** 1 if it comes to throw both apart, at the end of this substep or later: until then nothing brakes them. */
    private static final int PENDING_RESTITUTION = BASE + 4;
    /** The speed at which solids that move in their bodies come together here, m/s; 0 where none does. */
    private static final int DRIVEN = BASE + 5;
    /** Numbers of a point. */
    static final int POINT = BASE + 6;
    private static final int PATCH = POINTS + Manifold.MAX_POINTS * POINT;
    private static final int BLOCK = PATCH + FrictionRows.SIZE;
    private static final int SIZE = BLOCK + NormalBlock.SIZE;
    /** Rows of a manifold for which hinges have levers: those of its points, and then those of friction. */
    private static final int HINGED = Manifold.MAX_POINTS + FrictionRows.HINGED;

    private double[] data = {};
    private double[][] speedsA = {};
    private double[][] speedsB = {};
    private double[][] movedA = {};
    private double[][] movedB = {};
    /** 1 or -1 if what moves comes out of what is fixed along the normal or against it, 0 if neither is fixed. */
    private byte[] out = {};
    private Manifold[] manifolds = {};
    /** Levers of the hinges of each manifold; null where there is none. Those of a place stay, to be used again. */
    private HingeLevers[] levers = {};
    private HingeLevers[] kept = {};
    /** Points of each manifold; 0 where there is none. */
    private int[] points = {};
    private int size;
    /** Whether anything of the island bounces. */
    private boolean bounces;
    /** How much of the step has gone, seconds: solids that move in their bodies have been under way so long, but are put there at its end. */
    private double gone;
    private final NormalBlock block = new NormalBlock();

    /** The step of an island begins. */
    void clear() {
        gone = 0;
        size = 0;
        bounces = false;
    }

    /** Whether there is anything with a restitution. */
    boolean hasBouncing() {
        return bounces;
    }

    /** How many there may be. */
    int size() {
        return size;
    }

    /** Room for a manifold. */
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

    /** Leaves a room empty. */
    void drop(int slot) {
        points[slot] = 0;
    }

    /**
     * Makes the rows of a manifold.
     *
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

    /** Tells a manifold what pushes now. */
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
     * A substep begins: what pushed in the last one pushes on; but where one thing is alone a blow does not, and no push grows with the substep. In
     * heaps a push that is missing would let all above it fall.
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

    /** Looks how far both are from each other now. */
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
     * A pass that takes penetrations back.
     *
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
     * A pass that doesn't.
     *
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

    /** Nothing gets deeper into what is fixed than half of its own half size, whatever pushes it: beyond its middle it would come out behind. */
    private void stayOut(int slot) {
        Manifold of = manifolds[slot];
        Body body = out[slot] > 0 ? of.bodyA : of.bodyB;
        double deepest = gap(slot) + DEEPEST_SHARE * body.getLeast();
        if (deepest < 0 && body.isSolved()) {
            body.getSolver().lift(out[slot] * of.nx, out[slot] * of.ny, out[slot] * of.nz, -deepest);
            measure(slot);
        }
    }

    /** The least distance of its points, metres. */
    private double gap(int slot) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < points[slot]; i++) {
            least = Math.min(least, data[slot * SIZE + POINTS + i * POINT + GAP]);
        }
        return least;
    }

    /** Notes which bodies it pushes, and whether they are far in each other. */
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
            // what does not press does not rub; else friction would be left without the push that it came from
            FrictionRows.solve(data, at + PATCH, this, slot, 0, 0, 0);
        }
    }

    /**
     * Changes the velocities of both bodies by an impulse along a row, Ns.
     *
     * @param number of the row among those of the manifold
     */
    void applyImpulse(int slot, int number, int row, double impulse) {
        if (levers[slot] != null) {
            levers[slot].push(number, impulse);
        }
        PairRow.applyImpulse(data, row, speedsA[slot], speedsB[slot], data[slot * SIZE + MASS_A], data[slot * SIZE + MASS_B], impulse);
    }

    /** Changes how both turn by an angular impulse, Nms. */
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

    /** Restitution of what touches there; 0 where nothing is. */
    double restitution(int slot) {
        return points[slot] > 0 ? data[slot * SIZE + RESTITUTION] : 0;
    }

    /** Points of a manifold; 0 where there is none. */
    int points(int slot) {
        return points[slot];
    }

    /** Present distance at a point, metres. */
    double gap(int slot, int i) {
        return data[slot * SIZE + POINTS + i * POINT + GAP];
    }

    /** Speed at which both part at a point, m/s. */
    double parting(int slot, int i) {
        int point = slot * SIZE + POINTS + i * POINT;
        return PairRow.along(data, point, speedsA[slot], speedsB[slot]) - data[point + DRIVEN] - yielding(slot, i);
    }

    /** Levers of the hinges of a manifold; null if there are none. */
    HingeLevers levers(int slot) {
        return levers[slot];
    }

    /** How much faster than planned hinges bring both together along a row, m/s. */
    private double yielding(int slot, int number) {
        return levers[slot] == null ? 0 : levers[slot].speed(number);
    }

    /** Nothing brakes what comes at a point until it is there. */
    void await(int slot, int i) {
        data[slot * SIZE + POINTS + i * POINT + PENDING_RESTITUTION] = 1;
    }

    /** Forgets what threw them apart in the last substep. */
    void clearRestitution(int slot) {
        for (int i = 0; i < points[slot]; i++) {
            int point = slot * SIZE + POINTS + i * POINT;
            data[point + RESTITUTION_IMPULSE] = 0;
            data[point + PENDING_RESTITUTION] = 0;
        }
    }

    /**
     * Adds to a blow so that both part at a point with a speed or faster.
     *
     * @param impact so far, Ns
     * @param speed m/s
     * @return the blow with what was added
     */
    double rebound(int slot, int i, double impact, double speed) {
        int point = slot * SIZE + POINTS + i * POINT;
        double sum = Math.max(0, impact + PairRow.missing(data, point, speedsA[slot], speedsB[slot], speed + data[point
            + DRIVEN] + yielding(slot, i)));
        applyImpulse(slot, i, point, sum - impact);
        return sum;
    }

    /** A blow has ended: friction counts it. */
    void endImpact(int slot, int i, double impact) {
        data[slot * SIZE + POINTS + i * POINT + RESTITUTION_IMPULSE] += impact;
    }

    /** How much of gravity's acceleration brings both together along the normal, from b to a; only what moves falls. */
    double falling(int slot, double gravity) {
        int at = slot * SIZE;
        return data[at + 1] * ((data[at + MASS_B] > 0 ? gravity : 0) - (data[at + MASS_A] > 0 ? gravity : 0));
    }

    /**
     * All points of a manifold solved at once where all of them push, which is how things rest: one after the other they would turn the bodies to and
     * fro. Where things lie loosely on each other and one did not push in the last pass, it nearly always would have to pull, so it is not tried.
     * The matrix of four points in a plane has rank three; a little softness shares what is left evenly. Its factor is in the array, too.
     */
    private static final class NormalBlock {
        private static final int MOST = Manifold.MAX_POINTS;
        static final int SIZE = MOST * MOST;
        /** Share of the diagonal that is added to it. */
        private static final double SOFT = 1e-3;

        /** The speed at which each point is to part, m/s. */
        final double[] wanted = new double[MOST];
        /** How fast the fastest point came, beyond that, when it was solved last, m/s. */
        double fastest;
        private final double[] work = new double[SIZE];
        private final double[] sum = new double[MOST];

        /**
         * Factors the matrix of a manifold's points.
         *
         * @param at where it goes in the array
         * @param points where the rows of the points begin, one each {@link ContactRows#POINT}
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

        /** Cholesky's factor, with the reciprocals of its diagonal: dividing takes longer than all else here. */
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
         *
         * @return false, and nothing is done, if a point would have to pull
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
