// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Bodies connected by joints. All rows are solved together, directly, so that a long chain under a heavy load is as
 * stiff as a single joint (Baraff 1996, "Linear-time dynamics using Lagrange multipliers"). Friction, limits and motors
 * are at a limit of their impulse or free; which one is found by pivoting. Positions are kept on the level of
 * positions: the impulse that returns the bodies to their joints also changes their velocities, along the joints'
 * directions at the start of the substep, so that the energy of a pendulum stays (SHAKE: Ryckaert, Ciccotti, Berendsen
 * 1977). No allocation while the joints stay the same. Simulation thread.
 */
public final class Mechanism {
    /**
     * Share of a row's mobility added to it: redundant rows, as in a planar four-bar linkage, would make the matrix
     * singular.
     */
    private static final double REGULARIZATION = 1e-8;
    /** Largest number of changes of the active set in a pass. */
    private static final int MAX_PIVOTS = 12;
    /** Smallest speed error, m/s or rad/s, with which a row at its limit becomes free. */
    private static final double FREES = 1e-9;
    /** Largest number of corrections of the positions in a substep, and the error that needs none, metres. */
    private static final int MAX_CORRECTIONS = 3;
    private static final double EXACT = 1e-9;
    /**
     * Largest correction of an error that a substep finds at its start, metres or radians: bodies come back smoothly.
     */
    private static final double MAX_RETURN = 0.01;
    /**
     * Largest change of a velocity by the correction of positions in a substep, as a share of the largest velocity and
     * a small one, m/s and rad/s: where a linkage is stretched out, its matrix is singular.
     */
    private static final double MAX_TURN = 0.5;
    private static final double SMALL_SPEED = 0.5;

    private final List<Joint> joints;
    private final List<JointedBody> bodies = new ArrayList<>();
    private final SparseLdl matrix = new SparseLdl();
    private JointRows rows = new JointRows(0);
    private int[] firsts = {};
    private int[] starts = {};
    private int[] columns = {};
    /** Terms of each entry of the matrix, see {@link JointRows#couple}, and where those of an entry start. */
    private int[] pairs = {};
    private int[] pairStarts = {};
    private double[] diagonal = {};
    private double[] entries = {};
    private double[] change = {};
    private double[] errorBefore = {};
    /** Acceleration of each position error by the curvature of the bodies' paths, m/s^2 or rad/s^2. */
    private double[] curvature = {};
    /** Indices of the joints that are servos, and the states of their rows. */
    private int[] servos = {};
    private JointRows.State[] before = {};
    private final int couplings;
    private boolean factored;
    private double seconds;

    /** @param joints those of all connected bodies */
    public Mechanism(List<Joint> joints) {
        EliminationOrder order = new EliminationOrder(joints);
        this.joints = order.getJoints();
        couplings = order.getCouplings();
        for (Joint joint : joints) {
            for (JointedBody body : joint.ends()) {
                if (body.inverseMass > 0 && !bodies.contains(body)) {
                    bodies.add(body);
                }
            }
        }
    }

    /** Number of pairs of joints that share an entry of the factored matrix: memory and time grow with it. */
    public int getCouplings() {
        return couplings;
    }

    /** Begins a step. */
    public void beginStep() {
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).beginStep();
        }
    }

    /** Ends a step; joints with too large a force break. */
    public void endStep(double stepSeconds) {
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).endStep(stepSeconds);
            joints.get(i).breakIfOverloaded(stepSeconds);
        }
    }

    /**
     * Begins a substep: sets up the rows. Velocities are those of the middle of a substep; where its length changes,
     * gravity acts for the time between the middles.
     * @param newSeconds length of the substep
     * @param gravity m/s^2 downwards, which has acted for this time
     */
    public void prepare(double newSeconds, double gravity) {
        double late = gravity * (seconds - newSeconds) / 2;
        for (int i = 0; i < bodies.size() && late != 0; i++) {
            bodies.get(i).v[1] -= bodies.get(i).movable ? late : 0;
        }
        seconds = newSeconds;
        boolean stale = rows.size == 0;
        for (int i = 0; i < joints.size(); i++) {
            stale |= joints.get(i).isStale();
        }
        if (stale) {
            analyse();
        } else {
            fill();
        }
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).hold();
        }
        System.arraycopy(rows.error, 0, errorBefore, 0, rows.size);
        for (int k = 0; k < rows.size; k++) {
            if (isHeld(k)) {
                rows.target[k] = -curvature[k] * seconds;
            }
        }
        factored = false;
        measureServos();
    }

    /** Measures the inertia that each servo moves; all others hold meanwhile. */
    private void measureServos() {
        if (servos.length == 0) {
            return;
        }
        boolean held = true;
        for (int i = 0; i < servos.length; i++) {
            int row = servoRow(i);
            before[i] = rows.states[row];
            held &= before[i] == JointRows.State.FREE;
            rows.states[row] = JointRows.State.FREE;
        }
        factor();
        for (int i = 0; i < servos.length; i++) {
            Arrays.fill(change, 0);
            change[servoRow(i)] = 1;
            matrix.solve(change);
            joints.get(servos[i]).servo().setInertia(change[servoRow(i)]);
            rows.states[servoRow(i)] = before[i];
        }
        factored = held;
    }

    private int servoRow(int servo) {
        return firsts[servos[servo]] + joints.get(servos[servo]).servoRow();
    }

    /** Whether a row holds its position from both sides. */
    private boolean isHeld(int row) {
        return isKept(row) && rows.low[row] == Double.NEGATIVE_INFINITY;
    }

    private void fill() {
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).follow();
            joints.get(i).fill(rows, firsts[i], seconds);
        }
        for (int i = 0; i < joints.size(); i++) {
            if (joints.get(i).isBroken()) {
                for (int row = firsts[i]; row < firsts[i + 1]; row++) {
                    rows.push(row, -rows.impulse[row]);
                    rows.states[row] = JointRows.State.OFF;
                }
            }
        }
    }

    /** Creates the rows and finds the pattern of their matrix. */
    private void analyse() {
        firsts = new int[joints.size() + 1];
        for (int i = 0; i < joints.size(); i++) {
            firsts[i + 1] = firsts[i] + joints.get(i).rows();
        }
        int size = firsts[joints.size()];
        rows = new JointRows(size);
        fill();
        starts = new int[size + 1];
        List<Integer> found = new ArrayList<>();
        List<Integer> terms = new ArrayList<>();
        List<Integer> ends = new ArrayList<>(List.of(0));
        for (int k = 0; k < size; k++) {
            for (int i = 0; i < k; i++) {
                rows.couple(i, k, terms);
                if (terms.size() > ends.get(ends.size() - 1)) {
                    found.add(i);
                    ends.add(terms.size());
                }
            }
            starts[k + 1] = found.size();
        }
        columns = toArray(found);
        pairs = toArray(terms);
        pairStarts = toArray(ends);
        diagonal = new double[size];
        entries = new double[columns.length];
        change = new double[size];
        errorBefore = new double[size];
        curvature = new double[size];
        servos = IntStream.range(0, joints.size()).filter(i -> joints.get(i).servo() != null).toArray();
        before = new JointRows.State[servos.length];
        matrix.analyse(size, starts, columns);
    }

    private static int[] toArray(List<Integer> numbers) {
        return numbers.stream().mapToInt(Integer::intValue).toArray();
    }

    private void factor() {
        factored = true;
        for (int k = 0; k < rows.size; k++) {
            boolean free = rows.states[k] == JointRows.State.FREE;
            diagonal[k] = free ? (1 + REGULARIZATION) * rows.mobility(k) + rows.softness[k] : 1;
            diagonal[k] = diagonal[k] > 0 ? diagonal[k] : 1;
            for (int p = starts[k]; p < starts[k + 1]; p++) {
                entries[p] = free && rows.states[columns[p]] == JointRows.State.FREE
                    ? rows.mobility(pairs, pairStarts[p], pairStarts[p + 1]) : 0;
            }
        }
        matrix.factor(diagonal, entries);
    }

    /**
     * Solves all rows exactly for the present velocities. Returns the largest change of a row's speed, m/s or rad/s.
     */
    public double solve() {
        double most = 0;
        for (int pivot = 0; pivot < MAX_PIVOTS; pivot++) {
            if (!factored) {
                factor();
            }
            for (int k = 0; k < rows.size; k++) {
                change[k] = rows.states[k] == JointRows.State.FREE ? rows.missing(k) : 0;
                most = Math.max(most, Math.abs(change[k]));
            }
            matrix.solve(change);
            boolean last = pivot == MAX_PIVOTS - 1;
            if (!last && clamp()) {
                factored = false;
                continue;
            }
            for (int k = 0; k < rows.size; k++) {
                if (rows.states[k] == JointRows.State.FREE) {
                    double sum = Math.max(rows.low[k], Math.min(rows.high[k], rows.impulse[k] + change[k]));
                    rows.push(k, sum - rows.impulse[k]);
                }
            }
            if (last || !release()) {
                break;
            }
            factored = false;
        }
        return most;
    }

    /** Sets impulses that would exceed a limit to the limit. Returns whether there are any. */
    private boolean clamp() {
        boolean found = false;
        for (int k = 0; k < rows.size; k++) {
            if (rows.states[k] != JointRows.State.FREE) {
                continue;
            }
            double sum = rows.impulse[k] + change[k];
            if (sum < rows.low[k] || sum > rows.high[k]) {
                rows.states[k] = sum < rows.low[k] ? JointRows.State.LOW : JointRows.State.HIGH;
                rows.push(k, (sum < rows.low[k] ? rows.low[k] : rows.high[k]) - rows.impulse[k]);
                found = true;
            }
        }
        return found;
    }

    /** Frees rows at a limit that would leave it. Returns whether there are any. */
    private boolean release() {
        boolean found = false;
        for (int k = 0; k < rows.size; k++) {
            double missing = rows.states[k] == JointRows.State.LOW ? rows.missing(k)
                : rows.states[k] == JointRows.State.HIGH ? -rows.missing(k) : 0;
            if (missing > FREES) {
                rows.states[k] = JointRows.State.FREE;
                found = true;
            }
        }
        return found;
    }

    /** Brings the bodies back to their joints after they have moved; their velocities follow. */
    public void keepPositions() {
        measure();
        if (!factored) {
            factor();
        }
        boolean any = false;
        for (int k = 0; k < rows.size; k++) {
            change[k] = isKept(k) ? errorBefore[k] - rows.error[k] : 0;
            curvature[k] = isHeld(k) ? -(change[k] / seconds + rows.target[k]) / seconds : 0;
            any |= change[k] != 0;
        }
        if (any) {
            matrix.solve(change);
            double share = shift();
            for (int k = 0; k < rows.size; k++) {
                if (change[k] != 0) {
                    rows.push(k, share * change[k] / seconds);
                }
            }
            correctBodies();
        }
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).note(rows, firsts[i]);
        }
        returnToJoints();
    }

    /** Corrects what is left of the position errors; velocities stay. */
    public void returnToJoints() {
        for (int round = 0; round < MAX_CORRECTIONS; round++) {
            measure();
            double most = 0;
            for (int k = 0; k < rows.size; k++) {
                change[k] = isKept(k) ? -Math.max(-MAX_RETURN, Math.min(MAX_RETURN, rows.error[k])) : 0;
                most = Math.max(most, Math.abs(change[k]));
            }
            if (most < EXACT) {
                return;
            }
            matrix.solve(change);
            shift();
            correctBodies();
        }
        measure();
    }

    /** Sets the bodies' corrections; returns the share of them that is small enough. */
    private double shift() {
        for (int k = 0; k < rows.size; k++) {
            if (change[k] != 0) {
                rows.shift(k, change[k]);
            }
        }
        double fastest = SMALL_SPEED;
        double most = 0;
        for (int i = 0; i < bodies.size(); i++) {
            for (int k = 0; k < bodies.get(i).v.length; k++) {
                fastest = Math.max(fastest, Math.abs(bodies.get(i).v[k]));
                most = Math.max(most, Math.abs(bodies.get(i).correction[k]));
            }
        }
        double limit = MAX_TURN * fastest * seconds;
        if (most <= limit) {
            return 1;
        }
        for (int i = 0; i < bodies.size(); i++) {
            for (int k = 0; k < bodies.get(i).v.length; k++) {
                bodies.get(i).correction[k] *= limit / most;
            }
        }
        return limit / most;
    }

    private boolean isKept(int row) {
        return rows.kept[row] && rows.states[row] == JointRows.State.FREE;
    }

    private void measure() {
        for (int i = 0; i < joints.size(); i++) {
            joints.get(i).follow();
            joints.get(i).measure(rows, firsts[i]);
        }
    }

    private void correctBodies() {
        for (int i = 0; i < bodies.size(); i++) {
            bodies.get(i).correct();
        }
    }

    /** Returns the largest speed of a body's turning, rad/s. */
    public double fastest() {
        double most = 0;
        for (int i = 0; i < bodies.size(); i++) {
            double[] v = bodies.get(i).v;
            most = Math.max(most, v[3] * v[3] + v[4] * v[4] + v[5] * v[5]);
        }
        return Math.sqrt(most);
    }
}
