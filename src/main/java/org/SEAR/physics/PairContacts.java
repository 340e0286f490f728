// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.Arrays;

/**
 * Contacts of two bodies from step to step while their boxes overlap in the broad phase. A new search runs when the
 * bodies may have moved against each other by more than a tolerance, if necessary several times in a step. Impulses of
 * persistent points are kept (warm starting). Simulation thread.
 */
final class PairContacts {
    /** Contact margin, metres, in addition to the possible motion until the next search. */
    private static final double MARGIN = 2e-3;
    /** Relative motion of flat bodies after which a new search is due, metres. */
    private static final double TOLERANCE = 6e-3;
    /**
     * Relative motion of rolling bodies after which a new search is due, metres: their contact point moves with the
     * rotation.
     */
    private static final double TOLERANCE_ROUND = 1e-3;
    /** Relative motion below which contacts stay the same, metres. */
    private static final double STILL = 2e-4;

    /** Largest error of a contact point's velocity by rotation between searches, m/s. */
    private static final double SLIP = 0.02;
    /** Motion per substep above which a body could tunnel, as a share of its smallest half extent. */
    private static final double PASSING = 0.25;
    /** Smallest number of substeps of a step. */
    private static final int MIN_SUBSTEPS = 4;

    /** In the order of their numbers. */
    Body first;
    Body second;
    /** Next pair in the same bucket of the broad phase, and the last sweep in which the boxes overlapped. */
    PairContacts next;
    int hit;
    private final NarrowPhase finder;
    private Body a;
    private Body b;
    private Manifold[] now = new Manifold[1];
    private Manifold[] before = new Manifold[1];
    private int count;
    private int countBefore;
    private int version;
    private double tolerance;
    private double still;
    private boolean single;
    private boolean flat;
    /** Upper bound of the relative motion since the last search, metres. */
    private double travelled;
    /** Upper bound of the approach speed since the last substep, m/s. */
    private double fast;
    private double margin;
    /** Largest distance of interest in the last search, metres. */
    private double reach;
    private boolean known;
    /** Whether the last search ran within a step. */
    private boolean within;
    /** Whether they may touch within the step. */
    private boolean near;
    /** Distance at the last search, metres, and its direction from b to a. */
    private double apart;
    private double nx = 1;
    private double ny;
    private double nz;
    /** Lower bound of the distance of solids outside the reach, metres. */
    private double clear;
    /** Relative position at the last search, world frame, and the total surface motion by rotation, metres. */
    private double fromX;
    private double fromY;
    private double fromZ;
    private double turned;
    /** Slots of its manifolds in the rows of the island, at least one. */
    private int[] slots = new int[1];
    private int slotCount;

    PairContacts(NarrowPhase finder) {
        this.finder = finder;
    }

    /** Begins a pair whose boxes overlap. */
    void begin(Body ofFirst, Body ofSecond) {
        first = ofFirst;
        second = ofSecond;
        a = first.isMesh() ? second : first;
        b = first.isMesh() ? first : second;
        boolean rolls = a.canRoll() || b.canRoll();
        tolerance = rolls ? TOLERANCE_ROUND : TOLERANCE;
        still = rolls ? 0 : STILL;
        single = a.isSingle() && b.isSingle() && !b.isMesh();
        flat = single && !rolls;
        count = 0;
        near = false;
        known = false;
        parted(1, 0, 0);
    }

    boolean isOf(Body one, Body other) {
        return first == one && second == other;
    }

    /** Begins a step: finds the contacts if one of the bodies is awake. */
    void find() {
        if (!a.isSolved() && !b.isSolved()) {
            return;
        }
        if (finder.isCrowded(a, b)) {
            count = 0;
            known = false;
            return;
        }
        double ahead = finder.stepSeconds();
        fast = speed();
        double speed = fast + finder.stepGain();
        double next = ahead / MIN_SUBSTEPS;
        boolean same = known && a.getShapeVersion() + b.getShapeVersion() == version;
        boolean stale = isListed() ? travelled + fast * ahead > still : clear - went() < MARGIN
            + speed * (ahead + next);
        if (!same || stale || count == 1 && now[0].isLoadedElsewhere()) {
            version = a.getShapeVersion() + b.getShapeVersion();
            within = false;
            find(speed, ahead, next);
        }
        if (isListed()) {
            finder.list(this);
        }
    }

    private boolean isListed() {
        return count > 0 || near;
    }

    /** Returns an upper bound of the relative motion since the last search, metres. */
    private double went() {
        double x = a.getSolver().place.x - b.getSolver().place.x - fromX;
        double y = a.getSolver().place.y - b.getSolver().place.y - fromY;
        double z = a.getSolver().place.z - b.getSolver().place.z - fromZ;
        return Math.sqrt(x * x + y * y + z * z) + a.getTurned() + b.getTurned() - turned;
    }

    /** Upper bound of the approach speed since the last substep, m/s. */
    double getFast() {
        return fast;
    }

    /** Returns an upper bound of the present approach speed, m/s. */
    private double speed() {
        double[] p = a.getSolver().v;
        double[] q = b.getSolver().v;
        double dx = p[0] - q[0];
        double dy = p[1] - q[1];
        double dz = p[2] - q[2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz) + a.getTurningSpeed() + b.getTurningSpeed();
    }

    /**
     * @param speed upper bound of the approach speed, m/s
     * @param ahead time for which contacts are of interest, seconds
     * @param next time until the next search may run, seconds
     */
    private void find(double speed, double ahead, double next) {
        margin = MARGIN + Math.min(speed * ahead, tolerance) + speed * next;
        Manifold[] swap = before;
        before = now;
        now = swap;
        countBefore = count;
        count = 0;
        apart = Double.POSITIVE_INFINITY;
        reach = Math.max(margin, MARGIN + speed * (ahead + next));
        near = finder.find(this, a, b, margin, reach);
        if (a.isBall() && b.isMesh() && count > 0 && countBefore > 0) {
            SmoothEdges.follow(before, countBefore, now, count, finder.stepGain() / finder.stepSeconds());
        }
        clear = finder.getClear();
        fromX = a.getSolver().place.x - b.getSolver().place.x;
        fromY = a.getSolver().place.y - b.getSolver().place.y;
        fromZ = a.getSolver().place.z - b.getSolver().place.z;
        turned = a.getTurned() + b.getTurned();
        travelled = 0;
        known = true;
    }

    /** Sets up the rows of its manifolds for a step. */
    void enter(ContactRows rows, double substep) {
        slotCount = 0;
        fill(rows, substep);
    }

    private void fill(ContactRows rows, double substep) {
        while (slotCount < Math.max(1, count)) {
            if (slotCount == slots.length) {
                slots = Arrays.copyOf(slots, 2 * slotCount);
            }
            slots[slotCount++] = rows.add();
        }
        for (int i = 0; i < slotCount; i++) {
            if (i < count) {
                rows.fill(slots[i], now[i], substep);
            } else {
                rows.drop(slots[i]);
            }
        }
    }

    /** Turns the velocities of a ball at edges of a mesh; see {@link SmoothEdges#turn}. */
    double turnAtEdges(ContactRows rows, double seconds, boolean exact) {
        return a.isBall() && a.isSolved() ? SmoothEdges.turn(rows, slots, count, seconds, exact) : seconds;
    }

    /** Takes over the impulses from the rows. */
    void store(ContactRows rows) {
        for (int i = 0; i < count; i++) {
            rows.store(slots[i]);
        }
    }

    /**
     * Searches contacts again within a step if the bodies have moved too far.
     * @param seconds length of the next substep
     */
    void refresh(ContactRows rows, double seconds) {
        double next = (fast + finder.stepGain()) * seconds;
        if (travelled + next > mostTravel()) {
            store(rows);
            within = true;
            find(next / seconds, seconds, seconds);
            fill(rows, seconds);
        }
    }

    /** Whether a new search is due after a time at the current speed. */
    boolean isSoonStale(double seconds) {
        return (fast + finder.stepGain()) * seconds > mostTravel();
    }

    /**
     * Returns the relative motion after which a new search is due, metres; separate bodies may move until they could
     * touch.
     */
    private double mostTravel() {
        double free = Math.min(apart, reach) - MARGIN;
        if (count == 0) {
            return free;
        }
        double slip = SLIP / Math.max(a.getSolver().turning(), b.getSolver().turning());
        return Math.max(free, Math.min(Math.min(tolerance, slip), margin - MARGIN / 2));
    }

    /** Whether the second body is a mesh. */
    boolean isOfMesh() {
        return b.isMesh();
    }

    /** Undoes tunnelling through a mesh in the substep. */
    void stopBeforeMesh(double seconds) {
        a.noteTurningSpeed();
        if (a.isSolved() && travelled + speed() * seconds > PASSING * a.getLeast()) {
            finder.stopBefore(a, b);
        }
    }

    /** Ends a substep. */
    void moved(ContactRows rows, double seconds) {
        fast = speed();
        travelled += fast * seconds;
        for (int i = 0; i < count && (a.isRobot() || b.isRobot()); i++) {
            double impulse = rows.pressing(slots[i]);
            RobotBodies.press(a, now[i].solidA, impulse);
            RobotBodies.press(b, now[i].solidB, impulse);
        }
    }

    /** Adds an empty manifold; {@link #inherit} sets the impulses. */
    Manifold add(int partA, int partB) {
        if (count == now.length) {
            now = Arrays.copyOf(now, 2 * count);
            before = Arrays.copyOf(before, 2 * count);
        }
        if (now[count] == null) {
            now[count] = new Manifold();
        }
        Manifold manifold = now[count++];
        manifold.bodyA = a;
        manifold.bodyB = b;
        manifold.a = a.getSolver();
        manifold.b = b.getSolver();
        manifold.partA = partA;
        manifold.partB = partB;
        manifold.solidA = a.place()[partA].number;
        manifold.solidB = b.place()[partB].number;
        manifold.count = 0;
        manifold.fresh();
        return manifold;
    }

    /**
     * Returns the last contact normal, or else the last separating direction.
     * @param into takes it, from b to a, world frame, length 1
     * @return whether they have touched
     */
    boolean guess(double[] into) {
        boolean touched = countBefore > 0;
        into[0] = touched ? before[0].nx : nx;
        into[1] = touched ? before[0].ny : ny;
        into[2] = touched ? before[0].nz : nz;
        return touched;
    }

    /** Sets the direction in which the load tips a body over: that of the centre of pressure, or else downhill. */
    void load(double[] into) {
        if (countBefore != 1 || !before[0].load(into)) {
            into[0] = 0;
            into[1] = -1;
            into[2] = 0;
        }
    }

    /** Whether both bodies are single convex shapes. */
    boolean isSingle() {
        return single;
    }

    /** Whether both bodies are single convex shapes and neither is round. */
    boolean isFlat() {
        return flat;
    }

    /**
     * Whether the search tests the last separating face first, which is cheap. Not between two moving bodies at the
     * start of a step: stacks come to rest sooner with a stable direction. Within a step bodies are too fast for that.
     */
    boolean testsFaceFirst() {
        return flat && (within || !a.isSolved() || !b.isSolved());
    }

    /**
     * Copies former impulses to the manifolds of two colliding parts.
     * @param from index of the first of them; they are the last ones
     */
    void inherit(int from) {
        for (int i = 0; i < countBefore && from < count; i++) {
            if (before[i].partA == now[from].partA && before[i].partB == now[from].partB) {
                before[i].passOn(now, from, count);
            }
        }
    }

    int size() {
        return count;
    }

    Manifold get(int i) {
        return now[i];
    }

    /** Number of points of all its manifolds. */
    int points() {
        int points = 0;
        for (int i = 0; i < count; i++) {
            points += now[i].count;
        }
        return points;
    }

    Body getA() {
        return a;
    }

    Body getB() {
        return b;
    }

    /** Returns the smallest gap of the contact points, metres. */
    double gap() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, now[i].gap());
        }
        return least;
    }

    /** Returns the distance after a time at the present velocities, metres. */
    double soon(double seconds) {
        double[] p = a.getSolver().v;
        double[] q = b.getSolver().v;
        double closing = nx * (q[0] - p[0]) + ny * (q[1] - p[1]) + nz * (q[2] - p[2]) + a.getTurningSpeed()
            + b.getTurningSpeed();
        return apart - Math.max(0, closing) * seconds;
    }

    /** Notes the distance of two of their solids, metres, and its direction from b to a. */
    void approached(double distance, double dx, double dy, double dz) {
        if (distance < apart) {
            apart = distance;
            parted(dx, dy, dz);
        }
    }

    /** Notes the separating direction, from b to a. */
    void parted(double dx, double dy, double dz) {
        nx = dx;
        ny = dy;
        nz = dz;
    }

    /** Makes the present gaps the found ones. */
    void settle() {
        for (int i = 0; i < count; i++) {
            now[i].settle();
        }
    }
}
