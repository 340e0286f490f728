package org.SEAR.physics;

import java.util.Arrays;

/**
 * The contacts of two bodies from step to step, while the broad phase finds that their boxes overlap. They are found anew when the bodies
 * may have moved against each other by more than a tolerance, in a step several times if need be; what pushed at a point pushes on. Simulation
 * thread.
 */
final class PairContacts {
    /** Contacts are looked for so far ahead, metres, besides what the bodies may move until they are found anew. */
    private static final double MARGIN = 2e-3;
    /** What is flat may move so far against the other before contacts are found anew, metres. */
    private static final double TOLERANCE = 6e-3;
    /** The same where something rolls: the point of contact is another after a turn. */
    private static final double TOLERANCE_ROUND = 1e-3;
    /** Bodies that have moved less than this against each other since their contacts were found have the same still, metres. */
    private static final double STILL = 2e-4;

    /** How wrong the speed of a point may become by turning while the bodies go on, m/s. */
    private static final double SLIP = 0.02;
    /** What moves more than this share of its least half size in a substep could pass through something. */
    private static final double PASSING = 0.25;
    /** No step has fewer substeps. */
    private static final int MIN_SUBSTEPS = 4;

    /** In the order of their numbers. */
    Body first;
    Body second;
    /** Another pair in the same bucket of the broad phase, and in which sweep it met last. */
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
    /** How far both may have moved against each other since the contacts were found, metres. */
    private double travelled;
    /** How fast any points of both may come together since the last substep, m/s. */
    private double fast;
    private double margin;
    /** Up to how far apart they were looked for, metres. */
    private double reach;
    private boolean known;
    /** Whether contacts are found anew within a step. */
    private boolean within;
    /** Whether they may touch within the step. */
    private boolean near;
    /** How far apart they were when contacts were found, metres, and along which direction, from b to a. */
    private double apart;
    private double nx = 1;
    private double ny;
    private double nz;
    /** How far apart they were at least when they did not come near, metres. */
    private double clear;
    /** Where the one stood from the other then, world frame, and how far both had turned, metres. */
    private double fromX;
    private double fromY;
    private double fromZ;
    private double turned;
    /** Where its manifolds are among the rows of its island, at least one. */
    private int[] slots = new int[1];
    private int slotCount;

    PairContacts(NarrowPhase finder) {
        this.finder = finder;
    }

    /** Their boxes begin to overlap. */
    void begin(Body ofFirst, Body ofSecond) {
        first = ofFirst;
        second = ofSecond;
        a = first.isMesh() ? second : first;
        b = first.isMesh() ? first : second;
        boolean rolls = a.canRoll() || b.canRoll();
        tolerance = rolls ? TOLERANCE_ROUND : TOLERANCE;
        still = rolls ? 0 : STILL;
        single = a.solids.size() == 1 && b.solids.size() == 1 && !b.isMesh();
        flat = single && !rolls;
        count = 0;
        near = false;
        known = false;
        parted(1, 0, 0);
    }

    boolean isOf(Body one, Body other) {
        return first == one && second == other;
    }

    /** A step begins: finds their contacts if one of them is awake. */
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
        boolean stale = isListed() ? travelled + fast * ahead > still : clear - went() < MARGIN + speed * (ahead + next);
        if (!same || stale) {
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

    /** How far both have moved against each other at most since they were looked at, metres. */
    private double went() {
        double x = a.getSolver().place.x - b.getSolver().place.x - fromX;
        double y = a.getSolver().place.y - b.getSolver().place.y - fromY;
        double z = a.getSolver().place.z - b.getSolver().place.z - fromZ;
        return Math.sqrt(x * x + y * y + z * z) + a.getTurned() + b.getTurned() - turned;
    }

    /** How fast any points of both may come together since the last substep, m/s. */
    double getFast() {
        return fast;
    }

    /** How fast any points of both may come together, m/s. */
    private double speed() {
        double[] p = a.getSolver().v;
        double[] q = b.getSolver().v;
        double dx = p[0] - q[0];
        double dy = p[1] - q[1];
        double dz = p[2] - q[2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz) + a.getTurningSpeed() + b.getTurningSpeed();
    }

    /**
     * @param speed how fast they may come together, m/s
     * @param ahead how long it is interesting who may come, seconds
     * @param next after what time they may be found anew, seconds
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
        clear = finder.getClear();
        fromX = a.getSolver().place.x - b.getSolver().place.x;
        fromY = a.getSolver().place.y - b.getSolver().place.y;
        fromZ = a.getSolver().place.z - b.getSolver().place.z;
        turned = a.getTurned() + b.getTurned();
        travelled = 0;
        known = true;
    }

    /** A step is to be solved: makes the rows of its manifolds. */
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

    /** Takes over what pushes in its manifolds. */
    void store(ContactRows rows) {
        for (int i = 0; i < count; i++) {
            rows.store(slots[i]);
        }
    }

    /**
     * Finds the contacts anew within a step, if the bodies have moved too far since.
     *
     * @param seconds that the substep will take
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

    /** Whether its contacts have to be found anew after a time, as both move now. */
    boolean isSoonStale(double seconds) {
        return (fast + finder.stepGain()) * seconds > mostTravel();
    }

    /** How far both may move against each other until contacts have to be found anew: what is apart, until it could touch, metres. */
    private double mostTravel() {
        double free = Math.min(apart, reach) - MARGIN;
        if (count == 0) {
            return free;
        }
        double slip = SLIP / Math.max(a.getSolver().turning(), b.getSolver().turning());
        return Math.max(free, Math.min(Math.min(tolerance, slip), margin - MARGIN / 2));
    }

    /** Whether the second body is one. */
    boolean isOfMesh() {
        return b.isMesh();
    }

    /** What went through a mesh in the substep goes back. */
    void stopBeforeMesh(double seconds) {
        a.noteTurningSpeed();
        if (a.isSolved() && travelled + speed() * seconds > PASSING * a.getLeast()) {
            finder.stopBefore(a, b);
        }
    }

    /** A substep has passed. */
    void moved(double seconds) {
        fast = speed();
        travelled += fast * seconds;
    }

    /** A manifold to be filled; its points are told by {@link #inherit} what they pushed before. */
    Manifold add(int solidA, int solidB) {
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
        manifold.solidA = solidA;
        manifold.solidB = solidB;
        manifold.count = 0;
        manifold.fresh();
        return manifold;
    }

    /**
     * The direction in which they touched last, or else were parted.
     *
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

    /** Whether each is of one solid, and none a mesh. */
    boolean isSingle() {
        return single;
    }

    /** Whether neither of them is round, and each is of one solid. */
    boolean isFlat() {
        return flat;
    }

    /**
     * Whether the face that parted them last is asked first whether it does so still, as its search costs little. Not from step to step where both
     * move: in heaps a direction that stays lets them come to rest sooner. Within a step things are too fast for that.
     */
    boolean testsFaceFirst() {
        return flat && (within || !a.isSolved() || !b.isSolved());
    }

    /** Gives the points of a new manifold what pushed there before. */
    void inherit(Manifold manifold) {
        for (int i = 0; i < countBefore; i++) {
            Manifold old = before[i];
            if (old.solidA == manifold.solidA && old.solidB == manifold.solidB) {
                manifold.inherit(old);
            }
        }
    }

    int size() {
        return count;
    }

    Manifold get(int i) {
        return now[i];
    }

    /** Points of all its manifolds. */
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

    /** The least distance of the points of contact, metres. */
    double gap() {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            least = Math.min(least, now[i].gap());
        }
        return least;
    }

    /** How near they come within a while, as they move now, metres. */
    double soon(double seconds) {
        double[] p = a.getSolver().v;
        double[] q = b.getSolver().v;
        double closing = nx * (q[0] - p[0]) + ny * (q[1] - p[1]) + nz * (q[2] - p[2]) + a.getTurningSpeed() + b.getTurningSpeed();
        return apart - Math.max(0, closing) * seconds;
    }

    /**
     * Says how far apart two of their solids are, metres, and along which direction, from b to a.
     */
    void approached(double distance, double dx, double dy, double dz) {
        if (distance < apart) {
            apart = distance;
            parted(dx, dy, dz);
        }
    }

    /** Says which direction parts them, from b to a. */
    void parted(double dx, double dy, double dz) {
        nx = dx;
        ny = dy;
        nz = dz;
    }

    /** Where nothing moves any more the distances are those now. */
    void settle() {
        for (int i = 0; i < count; i++) {
            now[i].settle();
        }
    }

}
