package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import org.SEAR.physics.solid.Hinge;

/**
 * Moves the bodies of an island, which touch each other or may within the step, through a step. It goes in small substeps: gravity, what pushed
 * before, one pass over all contacts that also takes penetrations back, the way, and a pass that takes out of the velocities what taking back put in
 * (Macklin 2019, "Small steps in physics simulation"; Catto 2024, "Solver2D"). Impulses find their way through tall stacks and great ratios of
 * masses from substep to substep, because each begins with those of the last. Simulation thread.
 */
final class IslandSolver {
    /** Substeps of a step where things touch. */
    static final int SUBSTEPS = 8;
    /** Where nothing touches, the wheels of a robot are solved by so many passes. */
    private static final int PASSES_ALONE = 10;
    /** Passes over the wheels for each over the contacts. */
    private static final int WHEEL_PASSES = 3;
    /** Ratio of the masses of bodies that touch each other up to which the usual substeps do; beyond it they grow with its root. */
    private static final double RATIO = 12;
    private static final int MAX_SUBSTEPS = 128;
    /** What turns faster than by this in a substep gets more of them, radians. */
    private static final double MAX_TURN = 0.015;
    /** What is alone on what is fixed goes so far in a substep, metres, where the usual substeps are not needed. */
    private static final double WAY_ALONE = 4e-3;
    /** And has no fewer substeps than these. */
    private static final int MIN_ALONE = 2;
    /** And turns by no more than this in one, radians. */
    private static final double MAX_TURN_ALONE = 0.03;
    /** Bodies of an island for which that is paid. */
    private static final int FEW = 4;
    /** Points, and what searches take, times substeps of a step, beyond which there are fewer substeps, but no fewer than {@link #MIN_SUBSTEPS}. */
    private static final int MAX_WORK = 24_000;
    /** What finding the contacts of a pair anew takes, in points. */
    private static final int SEARCH = 6;
    /** Passes in a substep for each body of the highest stack: what carries must hear of what is on top of it. */
    private static final double PASSES_EACH = 0.3;
    /** Passes in a substep for a ratio of masses of 1: what is heavy on what is light is stopped by little and little. */
    private static final double PASSES_RATIO = 0.1;
    /** Passes at least where something is on top of another thing: a heap of which each hears too late of the others sways on. */
    private static final int MIN_PASSES_ON_OTHERS = 2;
    /** Points, and what wheels take, times substeps times passes, beyond which there are fewer passes. */
    private static final int MAX_PASSES_WORK = 60_000;
    /** What a robot's wheels take in a pass, in points. */
    private static final int WHEELS = 6;
    private static final int MIN_SUBSTEPS = 4;
    /** What is left of a step, as a share of a substep, that is no substep of its own. */
    private static final double REST = 1e-6;

    private List<Body> bodies;
    private List<PairContacts> pairs;
    private final List<PairContacts> ofMeshes = new ArrayList<>();
    private List<WheelDrive> drives;
    /** Those about which solids of the bodies turn in this step. */
    private final List<Hinge> hinges = new ArrayList<>();
    private final ContactRows rows = new ContactRows();
    private final StackOrder stackOrder = new StackOrder();
    private final Impacts impacts = new Impacts();
    private final double gravity;
    /** Whether it is one thing without wheels that does not roll, on or before what is fixed: no impulse has to find its way. */
    private boolean alone;
    /** Inverse masses of what pushes each other, 1/kg. */
    private double lightest;
    private double heaviest;
    private long passes;
    private int rounds;

    /** The wheels of a robot. */
    static final class WheelDrive {
        final Body body;
        final PhysicsWorld.Drive drive;

        WheelDrive(Body body, PhysicsWorld.Drive drive) {
            this.body = body;
            this.drive = drive;
        }
    }

    /** @param gravity m/s^2 downwards */
    IslandSolver(double gravity) {
        this.gravity = gravity;
    }

    /** Passes over contacts and wheels so far. */
    long getPasses() {
        return passes;
    }

    /** Moves an island through a step. */
    void step(Islands.Island island, double seconds) {
        bodies = island.bodies;
        pairs = island.pairs;
        drives = island.drives;
        if (pairs.isEmpty() && !isCarriedByHinge()) {
            stepAlone(seconds);
            return;
        }
        alone = bodies.size() == 1 && drives.isEmpty() && !bodies.get(0).canRoll();
        double substep = seconds / substeps(seconds);
        prepareHinges(substep);
        stackOrder.sort(pairs);
        rows.clear();
        ofMeshes.clear();
        for (int i = 0; i < pairs.size(); i++) {
            pairs.get(i).enter(rows, substep);
            if (pairs.get(i).isOfMesh()) {
                ofMeshes.add(pairs.get(i));
            }
        }
        double left = seconds;
        impacts.begin();
        boolean first = true;
        while (left > REST * substep) {
            double next = Math.min(substep, left);
            for (int i = 0; i < pairs.size() && !first; i++) {
                pairs.get(i).refresh(rows, next);
            }
            first = false;
            left -= substep(next);
        }
        settle();
    }

    /** Whether wheels stand on a robot that a servo turns parts of. */
    private boolean isCarriedByHinge() {
        for (int i = 0; i < drives.size(); i++) {
            List<Body> under = drives.get(i).drive.loaded();
            for (int k = 0; k < under.size(); k++) {
                if (!under.get(k).inner().hinges().isEmpty()) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Nothing touches: there is nothing to solve but wheels. */
    private void stepAlone(double seconds) {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().fall(seconds, gravity);
            if (!drives.isEmpty()) {
                bodies.get(i).getSolver().gyrate();
            }
        }
        for (int i = 0; i < drives.size(); i++) {
            prepare(drives.get(i));
        }
        for (int pass = 0; pass < PASSES_ALONE && !drives.isEmpty(); pass++) {
            passes++;
            for (int i = 0; i < drives.size(); i++) {
                drives.get(i).drive.solve(drives.get(i).body.getSolver());
            }
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().advance(gravity);
        }
    }

    private static void prepare(WheelDrive wheels) {
        wheels.body.getSolver().pressed |= wheels.body.isCarried();
        wheels.drive.prepare(wheels.body.getSolver());
    }

    private void prepareHinges(double substep) {
        hinges.clear();
        for (int i = 0; i < bodies.size(); i++) {
            List<Hinge> more = bodies.get(i).inner().hinges();
            for (int k = 0; k < more.size(); k++) {
                more.get(k).prepare(substep);
                hinges.add(more.get(k));
            }
        }
    }

    private int substeps(double seconds) {
        lightest = 0;
        heaviest = Double.POSITIVE_INFINITY;
        int points = 0;
        int searches = 0;
        for (int i = 0; i < pairs.size(); i++) {
            PairContacts pair = pairs.get(i);
            points += pair.points();
            searches += pair.isSoonStale(seconds / SUBSTEPS) ? 1 : 0;
            if (pair.points() > 0) {
                weigh(pair.getA(), pair.getB());
            }
        }
        for (int i = 0; i < drives.size(); i++) {
            List<Body> pushed = drives.get(i).drive.loaded();
            for (int k = 0; k < pushed.size(); k++) {
                weigh(drives.get(i).body, pushed.get(k));
            }
        }
        double ratio = lightest > 0 ? lightest / heaviest : 1;
        double turning = bodies.size() > FEW ? 0 : fastest() * seconds / (alone ? MAX_TURN_ALONE : MAX_TURN);
        double wanted = Math.max((alone ? substepsAlone(seconds) : SUBSTEPS) * Math.sqrt(Math.max(1, ratio / RATIO)), turning);
        double paid = Math.max(MIN_SUBSTEPS, MAX_WORK / Math.max(1, points + SEARCH * searches));
        int substeps = (int) Math.ceil(Math.min(Math.min(wanted, MAX_SUBSTEPS), paid));
        int height = stackOrder.measure(bodies, pairs);
        int least = height > 1 ? MIN_PASSES_ON_OTHERS : 1;
        double needed = Math.max(least, Math.max(PASSES_EACH * height, PASSES_RATIO * ratio));
        int work = (points + WHEELS * drives.size()) * substeps;
        rounds = (int) Math.max(1, Math.min(needed, (double) MAX_PASSES_WORK / Math.max(1, work)));
        return substeps;
    }

    private void weigh(Body a, Body b) {
        if (a.isSolved() && b.isSolved()) {
            double one = a.getSolver().inverseMass;
            double other = b.getSolver().inverseMass;
            lightest = Math.max(lightest, Math.max(one, other));
            heaviest = Math.min(heaviest, Math.min(one, other));
        }
    }

    /** Substeps for what is alone: the slower it comes, the fewer. */
    private double substepsAlone(double seconds) {
        double fast = 0;
        for (int i = 0; i < pairs.size(); i++) {
            fast = Math.max(fast, pairs.get(i).getFast());
        }
        return Math.max(MIN_ALONE, Math.min(SUBSTEPS, (fast + gravity * seconds) * seconds / WAY_ALONE));
    }

    /** How fast what is no ball turns, rad/s. */
    private double fastest() {
        double most = 0;
        for (int i = 0; i < bodies.size(); i++) {
            double[] v = bodies.get(i).getSolver().v;
            if (!bodies.get(i).isBall()) {
                most = Math.max(most, v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
            }
        }
        return Math.sqrt(most);
    }

    /**
     * @param seconds that it may take
     * @return how many it took: it ends where something bounces
     */
    private double substep(double seconds) {
        double taken = impacts.next(rows, seconds, gravity);
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().fall(taken, gravity);
            bodies.get(i).getSolver().gyrate();
        }
        for (int i = 0; i < hinges.size(); i++) {
            hinges.get(i).begin(taken);
        }
        rows.begin(taken, alone);
        for (int i = 0; i < drives.size(); i++) {
            prepare(drives.get(i));
        }
        for (int i = 0; i < rounds; i++) {
            press(i == rounds - 1);
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().advance(gravity);
        }
        for (int i = 0; i < hinges.size(); i++) {
            hinges.get(i).advance();
        }
        stopBeforeMeshes(taken);
        int relaxing = Math.max(1, rounds - 1);     // one fewer will do: heaps come to rest as soon
        for (int i = 0; i < relaxing; i++) {
            relax(i == 0);
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().slow();
            if (!bodies.get(i).isCarried()) {
                bodies.get(i).getSolver().even();
            }
        }
        stopBeforeMeshes(taken);
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).noteTurningSpeed();
        }
        for (int i = 0; i < pairs.size(); i++) {
            pairs.get(i).moved(taken);
        }
        return taken;
    }

    private void stopBeforeMeshes(double seconds) {
        for (int i = 0; i < ofMeshes.size(); i++) {
            ofMeshes.get(i).stopBeforeMesh(seconds);
        }
    }

    /** A pass that takes penetrations back. */
    private void press(boolean last) {
        passes++;
        solveDrives();
        rows.solveBiased(last);
    }

    /** A pass that takes out of the velocities what the others put in to take penetrations back. */
    private void relax(boolean first) {
        passes++;
        solveDrives();
        rows.relax(first);
    }

    /** Wheels, and the motors of hinges. */
    private void solveDrives() {
        for (int i = 0; i < hinges.size(); i++) {
            hinges.get(i).solve();
        }
        for (int k = 0; k < WHEEL_PASSES && !drives.isEmpty(); k++) {
            for (int i = 0; i < drives.size(); i++) {
                drives.get(i).drive.solve(drives.get(i).body.getSolver());
            }
        }
    }

    private void settle() {
        for (int i = 0; i < pairs.size(); i++) {
            pairs.get(i).store(rows);
            pairs.get(i).settle();
        }
    }
}
