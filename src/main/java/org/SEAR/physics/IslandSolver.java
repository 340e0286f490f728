// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;

/**
 * Moves the bodies of an island through a step, in small substeps (Macklin 2019, "Small steps in physics simulation").
 * A substep applies gravity and the warm-start impulses, solves passes over all contacts, moves the bodies, and
 * corrects penetrations. Warm starting spreads impulses through tall stacks and large mass ratios from substep to
 * substep. An island whose bodies are slow against each other gets passes until its contacts have converged: at rest
 * that takes one to three passes, and some hundred in the first substeps of a wall. Simulation thread.
 */
final class IslandSolver {
    /** Substeps of a step with contacts. */
    static final int SUBSTEPS = 8;
    /**
     * Substeps of a ball or log that touches only meshes. At a convex edge it leaves the surface by what it rolls in
     * half a substep, which costs energy: with 16 at most 0.3 % on 20 degrees of a dome, with 8 up to 0.53 %.
     */
    private static final int SUBSTEPS_ON_MESH = 16;
    /** Smallest and largest number of passes over a robot's wheels without contacts. */
    private static final int PASSES_ALONE = 10;
    private static final int MAX_PASSES_ALONE = 40;
    /** Velocity change of the body in a pass with which its wheels count as converged, m/s and rad/s. */
    private static final double WHEELS_CONVERGED = 1e-6;
    /** Passes over the wheels per pass over the contacts. */
    private static final int WHEEL_PASSES = 3;
    /**
     * Mass ratio of touching bodies up to which {@link #SUBSTEPS} suffice; above it the number grows with its square
     * root.
     */
    private static final double RATIO = 12;
    private static final int MAX_SUBSTEPS = 128;
    /** Rotation per substep above which there are more substeps, radians. */
    private static final double MAX_TURN = 0.015;
    /** Largest movement of an isolated body per substep, metres, where fewer substeps suffice. */
    private static final double WAY_ALONE = 4e-3;
    /** Smallest number of substeps of an isolated body. */
    private static final int MIN_ALONE = 2;
    /** Largest rotation of an isolated body per substep, radians. */
    private static final double MAX_TURN_ALONE = 0.03;
    /** Largest rotation of a body with a joint per substep, radians. */
    private static final double MAX_TURN_JOINTED = 0.05;
    /** Largest island, in bodies, with extra substeps for rotation and edges of meshes, and with a small residual. */
    private static final int FEW = 4;
    /**
     * Limit of points, and of the cost of searches, times substeps. Above it there are fewer substeps, but at least
     * {@link #MIN_SUBSTEPS}.
     */
    private static final int MAX_WORK = 24_000;
    /** Cost of a new contact search for a pair, in points. */
    private static final int SEARCH = 6;
    /** Passes per substep for each level of the highest stack, so that the supporting bodies feel the load above. */
    private static final double PASSES_EACH = 0.3;
    /** Passes per substep for each unit of the mass ratio: heavy bodies on light ones converge slowly. */
    private static final double PASSES_RATIO = 0.1;
    /** Smallest number of passes where bodies rest on each other; stacks would sway with fewer. */
    private static final int MIN_PASSES_ON_OTHERS = 2;
    /** Limit of points, and of the cost of wheels, times substeps times passes. Above it there are fewer passes. */
    private static final int MAX_PASSES_WORK = 60_000;
    /** Cost of a robot's wheels in a pass, in points. */
    private static final int WHEELS = 6;
    private static final int MIN_SUBSTEPS = 4;
    /**
     * Largest velocity change in a pass with which the contacts of a stack count as converged, as a share of what
     * gravity adds in a substep, divided by the number of levels: errors add up from level to level.
     */
    private static final double RESIDUAL = 0.01;
    /** Gravity from which on the residual does not fall with it, m/s^2: without gravity no passes would reach it. */
    private static final double WEAK = 0.1;
    /** Levels above which the residual falls with the square of their number: a pass carries errors by one level. */
    private static final double HIGH = 8;
    /**
     * The same in a calm island of at most {@link #FEW} bodies. Friction is bounded by the normal impulse of the pass
     * before, so the residual is speed that a body gains as it breaks away.
     */
    private static final double RESIDUAL_OF_FEW = 1e-3;
    /** Approach speed up to which an island is calm, m/s: passes go on until its contacts have converged. */
    private static final double CALM = 0.05;
    /** Limit of passes per substep of a calm island; reached for some substeps after the start of a high wall. */
    private static final int MAX_PASSES = 500;
    /** Limit of points, and of the cost of wheels, times substeps times passes of a calm island. */
    private static final int MAX_CALM_WORK = 10_000_000;
    /**
     * The same limits of an island that is not calm. With two passes, the friction of a spinning cube that lands would
     * add energy, since it would not feel the change of the normal impulse that it causes. Friction of a single ball
     * causes no such change.
     */
    private static final int MAX_IMPACT_PASSES = 6;
    private static final int MAX_IMPACT_WORK = 3000;
    /** A remainder of the step below this fraction of a substep is dropped. */
    private static final double REST = 1e-6;

    private List<Body> bodies;
    private List<PairContacts> pairs;
    private final List<PairContacts> ofMeshes = new ArrayList<>();
    private List<WheelDrive> drives;
    private List<JointedBodies> mechanisms;
    private final ContactRows rows = new ContactRows();
    private final PositionCorrection correction = new PositionCorrection();
    private final ConjugateDirection directions = new ConjugateDirection();
    private final StackOrder stackOrder = new StackOrder();
    private final Impacts impacts = new Impacts();
    private final SmoothEdges edges = new SmoothEdges();
    private double gravity;
    /** Whether the island is one body without wheels that does not roll: impulses need not spread. */
    private boolean alone;
    /** Extreme inverse masses of touching bodies, 1/kg. */
    private double lightest;
    private double heaviest;
    private final double[] before = new double[6];
    private long passes;
    /** Whether all touching bodies are slow against each other: passes go on until their contacts have converged. */
    private boolean calm;
    /** Levels of the highest stack. */
    private int height;
    private int leastPasses;
    private int mostPasses;

    /** Wheels of a robot. */
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

    /** @param newGravity m/s^2 downwards, 0 or more */
    void setGravity(double newGravity) {
        gravity = newGravity;
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
        mechanisms = island.mechanisms;
        for (int i = 0; i < mechanisms.size(); i++) {
            mechanisms.get(i).begin();
        }
        if (pairs.isEmpty() && mechanisms.isEmpty()) {
            stepAlone(seconds);
            return;
        }
        alone = bodies.size() == 1 && drives.isEmpty() && mechanisms.isEmpty() && !bodies.get(0).canRoll();
        double substep = seconds / substeps(seconds);
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
        edges.begin();
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
        for (int i = 0; i < mechanisms.size(); i++) {
            mechanisms.get(i).mechanism.endStep(seconds);
        }
    }

    /** Moves bodies without contacts; only wheels are solved. */
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
        double change = drives.isEmpty() ? 0 : Double.POSITIVE_INFINITY;
        int least = drives.isEmpty() ? 0 : PASSES_ALONE;
        for (int pass = 0; pass < least || pass < MAX_PASSES_ALONE && change > WHEELS_CONVERGED; pass++) {
            passes++;
            change = 0;
            for (int i = 0; i < drives.size(); i++) {
                change = Math.max(change, solveWheels(drives.get(i)));
            }
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().advance(gravity);
        }
    }

    /** Solves one pass over a robot's wheels; returns the largest change of its velocities, m/s and rad/s. */
    private double solveWheels(WheelDrive wheels) {
        double[] v = wheels.body.getSolver().v;
        System.arraycopy(v, 0, before, 0, before.length);
        wheels.drive.solve(wheels.body.getSolver());
        double change = 0;
        for (int i = 0; i < before.length; i++) {
            change = Math.max(change, Math.abs(v[i] - before[i]));
        }
        return change;
    }

    private static void prepare(WheelDrive wheels) {
        wheels.body.getSolver().pressed |= wheels.body.isCarried();
        wheels.drive.prepare(wheels.body.getSolver());
    }

    private int substeps(double seconds) {
        lightest = 0;
        heaviest = Double.POSITIVE_INFINITY;
        int points = 0;
        int searches = 0;
        double fast = 0;
        boolean rolling = bodies.size() == 1 && bodies.get(0).canRoll();
        boolean onMesh = rolling && !pairs.isEmpty();
        for (int i = 0; i < pairs.size(); i++) {
            PairContacts pair = pairs.get(i);
            onMesh &= pair.isOfMesh();
            points += pair.points();
            searches += pair.isSoonStale(seconds / SUBSTEPS) ? 1 : 0;
            if (pair.points() > 0) {
                fast = Math.max(fast, pair.getFast());
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
        boolean swinging = pairs.isEmpty() && !mechanisms.isEmpty();
        double turning = bodies.size() > FEW || swinging ? 0
            : fastest() * seconds / (alone ? MAX_TURN_ALONE : MAX_TURN);
        for (int i = 0; i < mechanisms.size(); i++) {
            turning = Math.max(turning, mechanisms.get(i).mechanism.fastest() * seconds / MAX_TURN_JOINTED);
        }
        double wanted = Math.max((alone ? substepsAlone(seconds) : onMesh ? SUBSTEPS_ON_MESH : SUBSTEPS) * Math.sqrt(
            Math.max(1, ratio / RATIO)), turning);
        double paid = Math.max(MIN_SUBSTEPS, MAX_WORK / Math.max(1, points + SEARCH * searches));
        int substeps = (int) Math.ceil(Math.min(Math.min(wanted, MAX_SUBSTEPS), paid));
        height = stackOrder.measure(bodies, pairs);
        int least = height > 1 ? MIN_PASSES_ON_OTHERS : 1;
        double needed = Math.max(least, Math.max(PASSES_EACH * height, PASSES_RATIO * ratio));
        int work = (points + WHEELS * drives.size()) * substeps;
        int rounds = (int) Math.max(1, Math.min(needed, (double) MAX_PASSES_WORK / Math.max(1, work)));
        boolean driven = !drives.isEmpty() || !mechanisms.isEmpty() && !pairs.isEmpty();
        int usual = Math.max(2, driven ? 2 * rounds - 1 : 2 * rounds - 2);
        leastPasses = driven ? usual : 1;
        calm = fast <= CALM && !isDeep();
        int limit = calm ? MAX_PASSES : rolling ? usual : MAX_IMPACT_PASSES;
        mostPasses = (int) Math.max(usual,
            Math.min(limit, (calm ? MAX_CALM_WORK : MAX_IMPACT_WORK) / Math.max(1.0, work)));
        return substeps;
    }

    private boolean isDeep() {
        for (int i = 0; i < bodies.size(); i++) {
            if (bodies.get(i).isDeep()) {
                return true;
            }
        }
        return false;
    }

    private void weigh(Body a, Body b) {
        if (a.isSolved() && b.isSolved()) {
            double one = a.getSolver().inverseMass;
            double other = b.getSolver().inverseMass;
            lightest = Math.max(lightest, Math.max(one, other));
            heaviest = Math.min(heaviest, Math.min(one, other));
        }
    }

    /** Returns the substeps of an isolated body: fewer at low speed. */
    private double substepsAlone(double seconds) {
        double fast = 0;
        for (int i = 0; i < pairs.size(); i++) {
            fast = Math.max(fast, pairs.get(i).getFast());
        }
        return Math.max(MIN_ALONE, Math.min(SUBSTEPS, (fast + gravity * seconds) * seconds / WAY_ALONE));
    }

    /** Returns the largest angular velocity of bodies that are not balls, rad/s. */
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
     * @param seconds longest length
     * @return actual length, seconds: the substep ends at an impact with restitution and at an edge of a mesh
     */
    private double substep(double seconds) {
        double untilEdge = edges.next(ofMeshes, rows, seconds, bodies.size() <= FEW);
        double taken = impacts.next(rows, untilEdge, gravity);
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().fall(taken, gravity);
            bodies.get(i).getSolver().gyrate();
        }
        for (int i = 0; i < mechanisms.size(); i++) {
            mechanisms.get(i).mechanism.prepare(taken, gravity);
        }
        rows.begin(taken, alone);
        for (int i = 0; i < drives.size(); i++) {
            prepare(drives.get(i));
        }
        solve(taken);
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).getSolver().advance(gravity);
        }
        for (int i = 0; i < mechanisms.size(); i++) {
            mechanisms.get(i).mechanism.keepPositions();
        }
        stopBeforeMeshes(taken);
        correction.run(rows, bodies, taken);
        for (int i = 0; i < mechanisms.size() && !pairs.isEmpty(); i++) {
            mechanisms.get(i).mechanism.returnToJoints();
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
            pairs.get(i).moved(rows, taken);
        }
        return taken;
    }

    private void stopBeforeMeshes(double seconds) {
        for (int i = 0; i < ofMeshes.size(); i++) {
            ofMeshes.get(i).stopBeforeMesh(seconds);
        }
    }

    /** Solves passes until the contacts have converged or the limit of passes is reached. */
    private void solve(double seconds) {
        double converged = (calm && bodies.size() <= FEW ? RESIDUAL_OF_FEW : RESIDUAL) / Math.max(1, height)
            * Math.min(1, HIGH / Math.max(1, height)) * Math.max(gravity, WEAK) * seconds;
        directions.begin();
        boolean last = false;
        for (int pass = 1; !last; pass++) {
            last = pass >= mostPasses;
            boolean accelerated = calm && pass > 1 && !last;
            if (accelerated) {
                directions.store(rows);
            }
            passes++;
            solveDrives();
            double jointChange = solveJoints();
            rows.solve(pass == 1);
            last |= pass >= leastPasses && rows.getResidual() <= converged && (pass == 1 || jointChange <= converged);
            if (accelerated && !last) {
                directions.advance(rows);
            }
        }
        if (!pairs.isEmpty() || !drives.isEmpty()) {
            solveJoints();
        }
        rows.finish();
    }

    /** Solves the joints; returns the largest change of speed, m/s or rad/s. */
    private double solveJoints() {
        double change = 0;
        for (int i = 0; i < mechanisms.size(); i++) {
            change = Math.max(change, mechanisms.get(i).mechanism.solve());
        }
        return change;
    }

    /** Solves wheels. */
    private void solveDrives() {
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
