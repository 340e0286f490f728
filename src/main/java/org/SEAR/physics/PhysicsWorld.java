// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.vecmath.Vector3f;
import org.SEAR.POJOs.Gravity;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.joint.Joint;
import org.SEAR.physics.joint.Mechanism;

/**
 * World of rigid bodies; searches only pairs that can touch an awake body. Each awake body has a zone, a box that
 * extends beyond it. When a body leaves its zone, wakes or falls asleep, the zones are redrawn; bodies then enter and
 * leave in the order of their numbers. Simulation thread.
 */
public final class PhysicsWorld {
    /** Extent of a zone beyond a body at rest, metres. */
    private static final double REACH = 0.5;
    /** Time for which a moving body stays in its zone, seconds. */
    private static final double AHEAD = 0.25;
    /** Distance from the end of its zone at which a body gets a new one, metres. */
    private static final double EDGE = 0.1;
    /** Look-ahead within which a body must stay in its zone, seconds. */
    private static final double SOON = 3 * TimeStep.SECONDS;
    /** Distance below which sleeping bodies wake together, metres. */
    private static final double NEIGHBOUR = 0.05;
    /** Gap below which surfaces touch, metres. */
    private static final double TOUCH = 0.002;
    /** Distance within the step at which a sleeping body wakes, metres. */
    private static final double WAKING = 5e-4;

    /** Listener for the contacts of a step. */
    public interface Touches {
        /**
         * @param solidOfA index of the touching solid in its body, likewise {@code solidOfB}; 0 unless the body is a
         *     robot
         * @param at the contact in the world
         * @param normal of the surface of {@code b}, towards {@code a}
         */
        void touch(Body a, int solidOfA, Body b, int solidOfB, Vector3f at, Vector3f normal);
    }

    /** Constraints of a robot's wheels on its body, solved together with the contacts. */
    public interface Drive {
        /** Movable bodies that the wheels stand on or press against. */
        List<Body> loaded();

        /** Sets up the rows of a substep; may apply known impulses (warm starting). */
        void prepare(SolverBody body);

        /** Solves one pass: brings the body's velocities closer to the constraints of the wheels. */
        void solve(SolverBody body);
    }

    private final List<Body> bodies = new ArrayList<>();
    private final List<Body> movable = new ArrayList<>();
    private final List<IslandSolver.WheelDrive> drives = new ArrayList<>();
    private final List<JointedBodies.Link> links = new ArrayList<>();
    private List<JointedBodies> mechanisms = List.of();
    private final Islands islands = new Islands();
    private NarrowPhase finder;
    private BroadPhase broadPhase;
    private IslandSolver solver;
    private double gravity = Gravity.EARTH;
    private int sleepers;
    private Aabb[] bounds;
    private Aabb[] zones;
    private boolean[] inside;
    private boolean[] awake;
    private boolean[] wanted;
    private int[] queue;
    private int[] unwanted;
    private boolean redraw;
    private final Vector3f at = new Vector3f();
    private final Vector3f normal = new Vector3f();
    private final Aabb beside = new Aabb();
    private final Aabb soon = new Aabb();

    /** Adds a body; call {@link #restart} afterwards. */
    public void add(Body body) {
        body.number = bodies.size();
        bodies.add(body);
        if (!body.isFixed()) {
            movable.add(body);
        }
    }

    /**
     * Adds a joint; call {@link #restart} afterwards, and attach the joint then.
     * @param collide whether its bodies collide with each other before it breaks
     * @param ends bodies on which it acts, null for the world; without collisions the first two of them
     */
    public void add(Joint joint, boolean collide, Body... ends) {
        JointedBodies.Link link = new JointedBodies.Link(joint, ends);
        links.add(link);
        for (Body one : link.ends) {
            if (one != null) {
                one.getSolver().setJointed(true);
                if (!collide) {
                    one.pass(link);
                }
            }
        }
    }

    /** Returns the largest number of couplings in a mechanism, see {@link Mechanism#getCouplings}. After a restart. */
    public int getCouplings() {
        return mechanisms.stream().mapToInt(one -> one.mechanism.getCouplings()).max().orElse(0);
    }

    /**
     * Changes gravity and wakes all bodies; before {@link #restart} that of the start.
     * @param newGravity m/s^2 downwards, 0 or more
     */
    public void setGravity(double newGravity) {
        gravity = newGravity;
        if (solver != null) {
            finder.setGravity(gravity);
            solver.setGravity(gravity);
            movable.forEach(Body::wake);
        }
    }

    /** Returns gravity, m/s^2 downwards. */
    public double getGravity() {
        return gravity;
    }

    public List<Body> getBodies() {
        return bodies;
    }

    /** Restarts the world with all bodies at their start poses. */
    public void restart() {
        finder = new NarrowPhase(TimeStep.SECONDS, gravity);
        broadPhase = new BroadPhase(finder);
        solver = new IslandSolver(gravity);
        drives.clear();
        sleepers = 0;
        int count = bodies.size();
        bounds = boxes(count);
        zones = boxes(count);
        inside = new boolean[count];
        awake = new boolean[count];
        wanted = new boolean[count];
        queue = new int[count];
        unwanted = new int[count];
        for (Body body : bodies) {
            body.restart();
            body.bounds(bounds[body.number]);
            awake[body.number] = !body.isFixed();
        }
        mechanisms = JointedBodies.of(links);
        redraw = true;
    }

    private static Aabb[] boxes(int count) {
        return Stream.generate(Aabb::new).limit(count).toArray(Aabb[]::new);
    }

    /** Adds the drive of a robot's body to the restarted world. */
    public void add(Body body, Drive drive) {
        drives.add(new IslandSolver.WheelDrive(body, drive));
    }

    /**
     * Teleports a body, at rest; wakes sleeping bodies beside its old and its new place.
     * @param start pose for the next start of the world
     */
    public void move(Body body, Pose start, Pose to) {
        wakeBeside(body);
        if (inside[body.number]) {
            leave(body);
        }
        body.moveTo(start, to);
        body.bounds(bounds[body.number]);
        wakeBeside(body);
        redraw = true;
    }

    private void wakeBeside(Body moved) {
        beside.set(bounds[moved.number]).grow(NEIGHBOUR);
        for (Body body : movable) {
            if (beside.overlaps(bounds[body.number])) {
                body.wake();
            }
        }
    }

    private void leave(Body body) {
        inside[body.number] = false;
        broadPhase.remove(body);
    }

    /** Advances the world by one step; costs nothing while all bodies sleep. */
    public void step() {
        noticeWaking();
        boolean busy = false;
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            if (awake[body.number]) {
                busy = true;
                body.begin();
                redraw |= leavesZone(body.number);
            }
        }
        if (redraw) {
            drawZones();
        }
        if (busy) {
            findContacts();
            solve();
        }
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            if (awake[body.number]) {
                body.getSolver().end();
                body.follow();
                body.bounds(bounds[body.number]);
            }
        }
        noticeWaking();
    }

    /**
     * Finds the contacts. Bodies about to be hit wake with their group; then the search is repeated to include their
     * contacts.
     */
    private void findContacts() {
        boolean complete = false;
        while (!complete) {
            finder.clear();
            for (int i = 0; i < movable.size(); i++) {
                movable.get(i).clearContacts();
            }
            broadPhase.find();
            complete = true;
            for (int i = 0; i < finder.getPairs().size(); i++) {
                PairContacts pair = finder.getPairs().get(i);
                Body sleeper = sleeper(pair);
                if (sleeper != null && pair.soon(TimeStep.SECONDS) < WAKING) {
                    wakeGroup(sleeper);
                    complete = false;
                }
            }
        }
    }

    /** Returns the sleeping body of a pair; null if there is none. */
    private static Body sleeper(PairContacts pair) {
        if (!pair.getA().isSolved() && pair.getA().canWake()) {
            return pair.getA();
        }
        return !pair.getB().isSolved() && pair.getB().canWake() ? pair.getB() : null;
    }

    private void wakeGroup(Body first) {
        int group = first.getGroup();
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            if (body == first || group > 0 && body.getGroup() == group) {
                body.wake();
                body.begin();
                awake[body.number] = true;
                redraw = true;
            }
        }
    }

    private void solve() {
        islands.build(movable, finder.getPairs(), drives, mechanisms, bodies.size());
        for (int i = 0; i < islands.size(); i++) {
            Islands.Island island = islands.get(i);
            solver.step(island, TimeStep.SECONDS);
            look(island);
        }
    }

    /** Notes which bodies touch something, and puts an island at rest to sleep. */
    private void look(Islands.Island island) {
        boolean rests = true;
        boolean stands = false;
        for (int i = 0; i < island.bodies.size(); i++) {
            Body body = island.bodies.get(i);
            body.setTouching(false);
            body.getSleepTimer().look(body, gravity);
            rests &= body.getSleepTimer().isOver();
            stands |= body.isCarried();
        }
        for (int i = 0; i < island.pairs.size(); i++) {
            PairContacts pair = island.pairs.get(i);
            pair.getA().setTouching(true);
            pair.getB().setTouching(true);
            stands |= !(pair.getA().isSolved() && pair.getB().isSolved()) && pair.gap() < TOUCH;
        }
        for (int i = 0; i < island.mechanisms.size(); i++) {
            stands |= island.mechanisms.get(i).held;
        }
        if (rests && stands) {
            sleepers++;
            for (int i = 0; i < island.bodies.size(); i++) {
                island.bodies.get(i).sleep(sleepers);
            }
        }
    }

    /** Notes bodies that fell asleep or woke since the last call. */
    private void noticeWaking() {
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            boolean active = body.isActive();
            if (active != awake[body.number]) {
                awake[body.number] = active;
                redraw = true;
                if (active) {
                    wakeGroup(body);
                }
            }
        }
    }

    private boolean leavesZone(int number) {
        double[] v = bodies.get(number).getSolver().v;
        return !zones[number].contains(soon.set(bounds[number]).grow(EDGE)
            .sweep(v[0] * SOON, v[1] * SOON, v[2] * SOON));
    }

    private void drawZones() {
        redraw = false;
        int last = 0;
        int others = 0;
        for (int i = 0; i < wanted.length; i++) {
            wanted[i] = awake[i];
            if (awake[i]) {
                queue[last++] = i;
            } else {
                unwanted[others++] = i;
            }
        }
        for (int next = 0; next < last; next++) {
            int number = queue[next];
            drawZone(number);
            int left = 0;
            for (int k = 0; k < others; k++) {
                int i = unwanted[k];
                wanted[i] = zones[number].overlaps(bounds[i]);
                if (!wanted[i]) {
                    unwanted[left++] = i;
                } else if (!bodies.get(i).isFixed()) {
                    queue[last++] = i;
                }
            }
            others = left;
        }
        for (int i = 0; i < wanted.length; i++) {
            if (wanted[i] != inside[i]) {
                if (wanted[i]) {
                    inside[i] = true;
                    broadPhase.add(bodies.get(i));
                } else {
                    leave(bodies.get(i));
                }
            }
        }
    }

    private void drawZone(int number) {
        double reach = awake[number] ? REACH : NEIGHBOUR;
        double[] v = bodies.get(number).getSolver().v;
        zones[number].set(bounds[number]).grow(reach).sweep(v[0] * AHEAD, v[1] * AHEAD, v[2] * AHEAD);
    }

    /** Whether a body moved in the last step, or may have. */
    public boolean isAwake(Body body) {
        return awake[body.number];
    }

    /** Reports all present contacts. */
    public void touches(Touches touches) {
        for (int i = 0; i < finder.getPairs().size(); i++) {
            PairContacts pair = finder.getPairs().get(i);
            for (int k = 0; k < pair.size(); k++) {
                touches(pair.get(k), touches);
            }
        }
    }

    private void touches(Manifold manifold, Touches touches) {
        for (int i = 0; i < manifold.count; i++) {
            Manifold.Point point = manifold.points[i];
            if (point.gap < TOUCH) {
                at.set((float) point.x, (float) point.y, (float) point.z);
                normal.set((float) manifold.nx, (float) manifold.ny, (float) manifold.nz);
                touches.touch(manifold.bodyA, manifold.numberA(), manifold.bodyB, manifold.numberB(), at, normal);
            }
        }
    }

    /** Returns the number of bodies near an awake one. */
    public int getBusyBodies() {
        int count = 0;
        for (boolean one : inside) {
            count += one ? 1 : 0;
        }
        return count;
    }

    /** Passes of the contact solver since {@link #restart}. */
    public long getSolverIterations() {
        return solver.getPasses();
    }
}
