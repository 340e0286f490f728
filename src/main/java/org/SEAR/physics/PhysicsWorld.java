package org.SEAR.physics;

import com.bulletphysics.collision.dispatch.CollisionDispatcher;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.narrowphase.ManifoldPoint;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import com.bulletphysics.dynamics.RigidBody;
import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ManifoldClipper;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;

/**
 * jbullet's world, in which only those bodies are that can touch something awake. A body that is awake has a zone, a box that reaches beyond it;
 * while it stays inside, nothing changes; when it leaves its zone, wakes or falls asleep, the zones are drawn anew and bodies enter and leave in
 * the order of their numbers. Simulation thread.
 */
public final class PhysicsWorld {
    /** Gravity, m/s^2. */
    public static final double GRAVITY = 9.81;
    /** How far a zone reaches beyond a body at rest, metres. */
    private static final double REACH = 0.5;
    /** For how long a moving body stays in its zone, seconds. */
    private static final double AHEAD = 0.25;
    /** A body closer than this to the end of its zone gets a new one, metres. */
    private static final double EDGE = 0.1;
    /** Where a body is this much later it must still be in its zone, seconds: the way of a step and of the time that a bounce owes. */
    private static final float SOON = (float) (3 * TimeStep.SECONDS);
    private static final int NO_ISLAND = -1;
    /** Sleeping bodies this close to each other wake together, metres. */
    private static final double NEIGHBOUR = 0.05;
    /** An object that stays within this distance for a second falls asleep, metres. */
    private static final double OBJECT_REST = 6e-3;
    /** The same for a robot whose motors stand. */
    private static final double ROBOT_REST = 1e-4;
    /** Surfaces closer than this touch, metres. */
    private static final float TOUCH = 0.002f;

    /** Takes the contacts of a step. */
    public interface Touches {
        /**
         * @param solidOfA number of the solid in its body that touches, likewise {@code solidOfB}; 0 in what is no robot
         * @param at the contact in the world
         * @param normal of the surface of {@code b}, towards {@code a}
         */
        void touch(Body a, int solidOfA, Body b, int solidOfB, Vector3f at, Vector3f normal);
    }

    /** Constraints that a robot's wheels put on its body; jbullet solves them together with the contacts. */
    public interface Drive {
        /** Makes the rows of a step; what is known of their impulses may already act (warm starting). */
        void prepare(SolverBody body);

        /** One iteration: brings the velocities of the body nearer to what the wheels allow. */
        void solve(SolverBody body);
    }

    private final List<Body> bodies = new ArrayList<>();
    private final List<Body> movable = new ArrayList<>();
    private SweptWorld world;
    private CollisionDispatcher dispatcher;
    private IslandSolver solver;
    private double[][] bounds;
    private double[][] zones;
    private boolean[] inside;
    private boolean[] awake;
    private boolean[] wanted;
    private int[] queue;
    private boolean redraw;
    private final Vector3f velocity = new Vector3f();
    private final double[] beside = new double[6];

    /** Adds a body; then {@link #restart}. */
    public void add(Body body) {
        body.number = bodies.size();
        bodies.add(body);
        if (!body.isFixed()) {
            movable.add(body);
        }
    }

    public List<Body> getBodies() {
        return bodies;
    }

    /** Everything back to its start, in a new world. */
    public void restart() {
        ContactConfiguration configuration = new ContactConfiguration();
        dispatcher = new CollisionDispatcher(configuration);
        solver = new IslandSolver();
        world = new SweptWorld(dispatcher, new PairSearch(), solver, configuration, (float) TimeStep.SECONDS, (float) GRAVITY);
        world.getSolverInfo().splitImpulse = true;
        world.getSolverInfo().linearSlop = ManifoldClipper.SKIN;
        int count = bodies.size();
        bounds = new double[count][6];
        zones = new double[count][6];
        inside = new boolean[count];
        awake = new boolean[count];
        wanted = new boolean[count];
        queue = new int[count];
        for (Body body : bodies) {
            body.restart();
            body.bounds(bounds[body.number]);
            if (body.getRolling() != null) {
                world.addConstraint(body.getRolling());
            }
            awake[body.number] = !body.isFixed();
        }
        redraw = true;
    }

    /** Joins the drive of a robot's body to the new world. */
    public void add(Body body, Drive drive) {
        world.addConstraint(new DriveConstraint(body, drive));
    }

    /**
     * Puts a body elsewhere at once, at rest; what slept beside it or sleeps where it comes wakes.
     *
     * @param start where the next start finds it
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
        System.arraycopy(bounds[moved.number], 0, beside, 0, beside.length);
        for (int i = 0; i < 3; i++) {
            beside[i] -= NEIGHBOUR;
            beside[i + 3] += NEIGHBOUR;
        }
        for (Body body : movable) {
            if (overlap(beside, bounds[body.number])) {
                body.wake();
            }
        }
    }

    private void leave(Body body) {
        RigidBody rigid = body.getRigid();
        inside[body.number] = false;
        world.removeRigidBody(rigid);
        rigid.setIslandTag(NO_ISLAND);
        rigid.setCompanionId(NO_ISLAND);
    }

    /** One step of the world; costs nothing while everything sleeps. */
    public void step() {
        noticeWaking();
        boolean busy = false;
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            if (awake[body.number]) {
                busy = true;
                redraw |= leavesZone(body.number);
            }
        }
        if (redraw) {
            drawZones();
        }
        if (busy) {
            world.stepSimulation((float) TimeStep.SECONDS, 0, (float) TimeStep.SECONDS);
        }
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            if (awake[body.number]) {
                body.follow();
                body.bounds(bounds[body.number]);
                body.rest(body.isRobot() ? ROBOT_REST : OBJECT_REST, !body.isDriven());
            }
        }
        noticeWaking();
    }

    /** Bodies that fell asleep or woke since last time. */
    private void noticeWaking() {
        for (int i = 0; i < movable.size(); i++) {
            Body body = movable.get(i);
            boolean active = body.getRigid().isActive();
            if (active != awake[body.number]) {
                awake[body.number] = active;
                redraw = true;
                if (!active) {
                    stop(body.getRigid());
                }
            }
        }
    }

    private void stop(RigidBody rigid) {
        velocity.set(0, 0, 0);
        rigid.setLinearVelocity(velocity);
        rigid.setAngularVelocity(velocity);
    }

    private boolean leavesZone(int number) {
        double[] box = bounds[number];
        double[] zone = zones[number];
        bodies.get(number).getRigid().getLinearVelocity(velocity);
        velocity.scale(SOON);
        return box[0] - EDGE + Math.min(0, velocity.x) < zone[0] || box[3] + EDGE + Math.max(0, velocity.x) > zone[3]
            || box[1] - EDGE + Math.min(0, velocity.y) < zone[1] || box[4] + EDGE + Math.max(0, velocity.y) > zone[4]
            || box[2] - EDGE + Math.min(0, velocity.z) < zone[2] || box[5] + EDGE + Math.max(0, velocity.z) > zone[5];
    }

    private void drawZones() {
        redraw = false;
        int last = 0;
        for (int i = 0; i < wanted.length; i++) {
            wanted[i] = awake[i];
            if (awake[i]) {
                queue[last++] = i;
            }
        }
        for (int next = 0; next < last; next++) {
            int number = queue[next];
            drawZone(number);
            for (int i = 0; i < wanted.length; i++) {
                if (!wanted[i] && overlap(zones[number], bounds[i])) {
                    wanted[i] = true;
                    if (!bodies.get(i).isFixed()) {
                        queue[last++] = i;
                    }
                }
            }
        }
        for (int i = 0; i < wanted.length; i++) {
            if (wanted[i] != inside[i]) {
                if (wanted[i]) {
                    inside[i] = true;
                    world.addRigidBody(bodies.get(i).getRigid());
                } else {
                    leave(bodies.get(i));
                }
            }
        }
    }

    private void drawZone(int number) {
        double reach = awake[number] ? REACH : NEIGHBOUR;
        bodies.get(number).getRigid().getLinearVelocity(velocity);
        double[] box = bounds[number];
        double[] zone = zones[number];
        zone[0] = box[0] - reach + Math.min(0, velocity.x * AHEAD);
        zone[1] = box[1] - reach + Math.min(0, velocity.y * AHEAD);
        zone[2] = box[2] - reach + Math.min(0, velocity.z * AHEAD);
        zone[3] = box[3] + reach + Math.max(0, velocity.x * AHEAD);
        zone[4] = box[4] + reach + Math.max(0, velocity.y * AHEAD);
        zone[5] = box[5] + reach + Math.max(0, velocity.z * AHEAD);
    }

    private static boolean overlap(double[] a, double[] b) {
        return a[0] <= b[3] && b[0] <= a[3] && a[1] <= b[4] && b[1] <= a[4] && a[2] <= b[5] && b[2] <= a[5];
    }

    /** Whether a body moved in the last step, or may have. */
    public boolean isAwake(Body body) {
        return awake[body.number];
    }

    /** Tells of everything that touches now. */
    public void touches(Touches touches) {
        int count = dispatcher.getNumManifolds();
        for (int i = 0; i < count; i++) {
            PersistentManifold manifold = dispatcher.getManifoldByIndexInternal(i);
            for (int k = 0; k < manifold.getNumContacts(); k++) {
                ManifoldPoint point = manifold.getContactPoint(k);
                if (point.distance1 < TOUCH) {
                    touches.touch((Body) ((CollisionObject) manifold.getBody0()).getUserPointer(), point.index0,
                        (Body) ((CollisionObject) manifold.getBody1()).getUserPointer(), point.index1, point.positionWorldOnB, point.normalWorldOnB);
                }
            }
        }
    }

    /** How many bodies jbullet looks at now. */
    public int getBusyBodies() {
        int count = 0;
        for (boolean one : inside) {
            count += one ? 1 : 0;
        }
        return count;
    }

    /** Iterations of the contact solver since {@link #restart}. */
    public long getSolverIterations() {
        return solver.getIterations();
    }
}
