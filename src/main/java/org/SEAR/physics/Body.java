package org.SEAR.physics;

import java.util.List;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.TimeStep;
import org.SEAR.physics.solid.Hinge;
import org.SEAR.physics.solid.InnerMotion;
import org.SEAR.physics.solid.Solid;

/**
 * One thing that can be touched: an environment object or a robot's body. Its frame is that of the object; what the solver moves has its origin in
 * the centre of mass, (cx, cy, cz) of that frame. Simulation thread.
 */
public final class Body {
    /** Smallest moment of inertia, as a share of mass times square metre, that a thin body is given so that it can be solved. */
    private static final double MIN_INERTIA = 1e-4;

    public final String name;
    public final double mass;
    /** Its place in the order of the world. */
    int number;
    /** Over how many bodies it stands on something fixed, as the solver counts. */
    int level;
    public final List<Solid> solids;
    /** Where each solid stands in the body's frame. */
    public final Pose[] places;
    private int[] shapes = {};
    private final double cx;
    private final double cy;
    private final double cz;
    private final PlacedSolid[] placed;
    private final InnerMotion inner;
    private long placedAt = -1;
    private int shapeVersion;
    private double leastReach;
    private double reach;
    private double leastHalf;
    private boolean robot;
    private boolean driven;
    private boolean carried;
    private boolean touching;
    private int group;
    private int contacts;
    private double turned;
    private double turningSpeed;
    private boolean rolls;
    private Symmetry symmetry = Symmetry.NONE;
    /** Where it starts. */
    private Pose start;
    private Pose pose;
    private final Aabb near = new Aabb();
    private State state = State.ASLEEP;
    private final SolverBody solver = new SolverBody();
    private final SleepTimer rest = new SleepTimer();
    private final Frame frame = new Frame();

    /** What is fixed is always asleep. */
    private enum State {
        AWAKE, ASLEEP, STOPPED
    }

    /** About which axes it looks the same however it is turned. */
    private enum Symmetry {
        NONE, ABOUT_Y, BALL
    }

    /**
     * @param mass kg, 0 = fixed
     * @param centre of mass in the body's frame
     */
    public Body(String name, double mass, List<Solid> solids, Pose[] places, double[] centre, Pose start) {
        this.name = name;
        this.mass = mass;
        this.solids = solids;
        this.places = places;
        this.cx = centre[0];
        this.cy = centre[1];
        this.cz = centre[2];
        this.start = start;
        this.pose = start;
        inner = new InnerMotion(solids, places, centre);
        placed = new PlacedSolid[places.length];
        for (int i = 0; i < placed.length; i++) {
            placed[i] = new PlacedSolid(solids.get(i), mass > 0);
        }
        if (solids.size() == 1 && mass > 0 && places[0].qw == 1) {
            ConvexShape shape = solids.get(0).convex();
            symmetry = shape.isBall() ? Symmetry.BALL : shape.isTurned() ? Symmetry.ABOUT_Y : Symmetry.NONE;
        }
    }

    /**
     * Puts its first solids into the scenes; the others only collide.
     *
     * @param visible whether beams see each
     */
    public void addTo(RaycastScenes scenes, List<Boolean> visible, int owner, int count) {
        shapes = new int[count];
        for (int i = 0; i < count; i++) {
            shapes[i] = scenes.add(this, solids.get(i), visible.get(i), owner);
        }
    }

    /** The number of its solid that is a shape of the scenes; -1 if none is. */
    public int solidOf(int shape) {
        for (int i = 0; i < shapes.length; i++) {
            if (shapes[i] == shape) {
                return i;
            }
        }
        return -1;
    }

    /** Moves its solids in the scenes to where it is. */
    public void mirror(RaycastScenes scenes) {
        for (int i = 0; i < shapes.length; i++) {
            frame.set(pose);
            if (places[i] != Pose.IDENTITY) {
                frame.times(places[i]);
            }
            scenes.setPose(shapes[i], frame);
        }
    }

    /** Back to the start pose, at rest. */
    void restart() {
        pose = start;
        reach = reach();
        leastHalf = mass > 0 ? solids.stream().mapToDouble(solid -> solid.convex().least()).min().orElse(0) : 0;
        rolls = !robot && mass > 0 && solids.stream().anyMatch(solid -> solid.convex().isRound());
        double[] moments = mass > 0 ? moments() : new double[3];
        double least = mass * MIN_INERTIA;
        solver.setMass(mass, Math.max(moments[0], least), Math.max(moments[1], least), Math.max(moments[2], least));
        put(start);
        carried = false;
        group = 0;
        state = mass > 0 ? State.AWAKE : State.ASLEEP;
    }

    private void put(Pose at) {
        double[] centre = at.transform(cx, cy, cz);
        solver.put(centre[0], centre[1], centre[2], at);
        rest.begin(solver);
        inner.forget();
        placedAt = -1;
        turningSpeed = 0;
        touching = false;
        shapeVersion++;    // contacts that were known are elsewhere
    }

    /** About the axes through its centre of mass, kg m^2: of one solid its own, of several those of the box around them. */
    private double[] moments() {
        if (solids.size() == 1 && places[0].qw == 1) {
            double[] each = solids.get(0).convex().inertia();
            return new double[] {mass * each[0], mass * each[1], mass * each[2]};
        }
        Aabb all = new Aabb();
        for (int i = 0; i < placed.length; i++) {
            set(places[i], placed[i].place);
            placed[i].bound();
            all.add(placed[i].box);
        }
        placedAt = -1;
        double halfX = (all.maxX - all.minX) / 2;
        double halfY = (all.maxY - all.minY) / 2;
        double halfZ = (all.maxZ - all.minZ) / 2;
        return new double[] {mass / 3 * (halfY * halfY + halfZ * halfZ), mass / 3 * (halfX * halfX + halfZ * halfZ),
            mass / 3 * (halfX * halfX + halfY * halfY)};
    }

    private static void set(Pose pose, Placement into) {
        into.setRotation(pose.qx, pose.qy, pose.qz, pose.qw);
        into.x = pose.x;
        into.y = pose.y;
        into.z = pose.z;
    }

    /** Puts it elsewhere at once, at rest, and says where the next start of the world finds it. */
    void moveTo(Pose newStart, Pose to) {
        start = newStart;
        pose = to;
        put(to);
        state = mass > 0 ? State.AWAKE : State.ASLEEP;
    }

    /** Says how far from its centre of mass solids come that are going to move in it, metres. Before the world starts. */
    public void setLeastReach(double metres) {
        leastReach = metres;
    }

    /**
     * Moves one of its solids in its own frame, in the step that comes: it pushes and takes along what touches it.
     *
     * @param solid its number
     * @param hinge which yields to what it meets; null if it does not
     */
    public void move(int solid, Pose to, Hinge hinge) {
        inner.move(solid, to, hinge);
    }

    /** How its solids move in it in this step. */
    public InnerMotion inner() {
        return inner;
    }

    /**
     * Puts one of its solids elsewhere in its own frame, before the world starts.
     *
     * @param solid its number
     */
    public void setPlace(int solid, Pose place) {
        places[solid] = place;
        shapeVersion++;
        placedAt = -1;
    }

    /** Grows when its solids move in it. */
    int getShapeVersion() {
        return shapeVersion;
    }

    /** Its solids where they stand now. */
    PlacedSolid[] place() {
        if (placedAt == solver.getMoves()) {
            return placed;
        }
        placedAt = solver.getMoves();
        Placement at = solver.place;
        for (int i = 0; i < placed.length; i++) {
            Placement into = placed[i].place;
            set(places[i], into);
            into.x -= cx;
            into.y -= cy;
            into.z -= cz;
            into.within(at);
            placed[i].bound();
        }
        return placed;
    }

    /** Distance of its farthest point from its centre of mass, metres, or more. */
    private double reach() {
        double farthest = leastReach;
        for (int i = 0; i < places.length && mass > 0; i++) {
            double off = Math.sqrt((places[i].x - cx) * (places[i].x - cx) + (places[i].y - cy) * (places[i].y - cy)
                + (places[i].z - cz) * (places[i].z - cz));
            farthest = Math.max(farthest, off + solids.get(i).convex().radius());
        }
        return farthest;
    }

    /** Distance of its farthest point from its centre of mass, metres. */
    double getReach() {
        return reach;
    }

    /** Half of the least size of its solids, metres. */
    double getLeast() {
        return leastHalf;
    }

    /** Whether rolling friction brakes it: robots roll on wheels. */
    boolean canRoll() {
        return rolls;
    }

    /** A step begins. */
    void begin() {
        solver.begin();
        noteTurningSpeed();
    }

    /** How fast the surface of it moved by turning when it was looked at last, at most, m/s. */
    double getTurningSpeed() {
        return turningSpeed;
    }

    /** Looks how fast its surface moves by turning. */
    void noteTurningSpeed() {
        turningSpeed = turningSpeed();
    }

    /** What turns about the axis of its own symmetry does not move its surface. */
    private double turningSpeed() {
        double[] v = solver.v;
        double square = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
        if (square == 0 || symmetry == Symmetry.BALL) {
            return inner.fastest();
        }
        if (symmetry == Symmetry.ABOUT_Y) {
            Placement at = solver.place;
            double about = v[3] * at.m01 + v[4] * at.m11 + v[5] * at.m21;
            square = Math.max(0, square - about * about);
        }
        return Math.sqrt(square) * reach + inner.fastest();
    }

    /** How far its surface has moved by turning so far, at most, metres. */
    double getTurned() {
        return turned;
    }

    /**
     * Whether a point of its surface is a corner, which turns with it.
     *
     * @param x in the frame of its centre of mass, metres, likewise y and z
     */
    boolean isCorner(int solid, double x, double y, double z) {
        Pose place = places[solid];
        double[] own = place.rotateBack(x + cx - place.x, y + cy - place.y, z + cz - place.z);
        return solids.get(solid).convex().isCorner(own[0], own[1], own[2]);
    }

    /** A new search for contacts begins. */
    void clearContacts() {
        contacts = 0;
    }

    /**
     * Counts one that it may touch.
     *
     * @return how many there are; 0 for what is fixed
     */
    int countContact() {
        return mass > 0 ? ++contacts : 0;
    }

    /** Whether it rolls about its y axis alone: over its rims it tips. */
    boolean isRoundAboutAxis() {
        return symmetry == Symmetry.ABOUT_Y && solids.get(0).convex().isRimmed();
    }

    /** Whether it looks the same however it is turned. */
    boolean isBall() {
        return symmetry == Symmetry.BALL;
    }

    /** Whether it collides by triangles. */
    boolean isMesh() {
        return placed[0].isMesh();
    }

    /** How it moves. */
    SolverBody getSolver() {
        return solver;
    }

    /** Takes over where the solver has moved it in a step. */
    void follow() {
        turned += inner.fastest() * TimeStep.SECONDS;
        if (inner.end()) {
            shapeVersion++;
            placedAt = -1;
        }
        double[] moved = solver.moved;
        turned += symmetry == Symmetry.BALL ? 0 : Math.sqrt(moved[3] * moved[3] + moved[4] * moved[4] + moved[5] * moved[5]) * reach;
        AngularState spin = solver.spin();
        double qx = spin.qx();
        double qy = spin.qy();
        double qz = spin.qz();
        double qw = spin.qw();
        double tx = 2 * (qy * cz - qz * cy);
        double ty = 2 * (qz * cx - qx * cz);
        double tz = 2 * (qx * cy - qy * cx);
        pose = new Pose(solver.place.x - (cx + qw * tx + qy * tz - qz * ty), solver.place.y - (cy + qw * ty + qz * tx - qx * tz),
            solver.place.z - (cz + qw * tz + qx * ty - qy * tx), qx, qy, qz, qw);
    }

    /** Whether it may sleep, see {@link SleepTimer}. */
    SleepTimer getSleepTimer() {
        return rest;
    }

    /** The box around it in the world. */
    void bounds(Aabb into) {
        place();
        into.set(placed[0].box);
        for (int i = 1; i < placed.length; i++) {
            into.add(placed[i].box);
        }
    }

    /** Where the broad phase expects it within the step; its own. */
    Aabb getNear() {
        return near;
    }

    /** Widens a box around it by where it may go in a while. */
    void widen(Aabb box, double seconds) {
        if (isFixed() || !isActive()) {
            return;
        }
        box.sweep(solver.v[0] * seconds, solver.v[1] * seconds, solver.v[2] * seconds).grow(turningSpeed * seconds);
    }

    /**
     * Velocity of a point of the body, m/s, everything in the world frame.
     *
     * @param into takes {x, y, z}
     */
    public void velocityAt(double x, double y, double z, double[] into) {
        double[] v = solver.v;
        double rx = x - solver.place.x;
        double ry = y - solver.place.y;
        double rz = z - solver.place.z;
        into[0] = v[0] + v[4] * rz - v[5] * ry;
        into[1] = v[1] + v[5] * rx - v[3] * rz;
        into[2] = v[2] + v[3] * ry - v[4] * rx;
    }

    /**
     * Angular velocity in the world frame, rad/s.
     *
     * @param into takes {x, y, z}
     */
    public void angularVelocity(double[] into) {
        System.arraycopy(solver.v, 3, into, 0, 3);
    }

    /** Says that it is a robot's body: nothing brakes it but its wheels. */
    public void setRobot() {
        robot = true;
    }

    /** Gives it these velocities at once and wakes it: of its centre of mass, m/s, and of its turning, rad/s, world frame. */
    public void setVelocities(double vx, double vy, double vz, double wx, double wy, double wz) {
        double[] v = solver.v;
        v[0] = vx;
        v[1] = vy;
        v[2] = vz;
        v[3] = wx;
        v[4] = wy;
        v[5] = wz;
        wake();
    }

    /** A force in its centre of mass for the next step, N, world frame; it adds to others of the step. */
    public void pull(double x, double y, double z) {
        solver.pull(x, y, z);
    }

    /**
     * Velocities of its centre of mass, world frame.
     *
     * @param v takes {vx, vy, vz, wx, wy, wz}, m/s and rad/s
     */
    public void velocities(double[] v) {
        System.arraycopy(solver.v, 0, v, 0, v.length);
    }

    /** Whether it touched nothing, and came near nothing, in the last step. */
    public boolean isFree() {
        return !touching;
    }

    void setTouching(boolean on) {
        touching = on;
    }

    /** Says whether wheels on the ground carry it. */
    public void setCarried(boolean on) {
        carried = on;
    }

    boolean isCarried() {
        return carried;
    }

    /** Whether it does not sleep. */
    public boolean isActive() {
        return state == State.AWAKE;
    }

    /** What constraints change, if they do in this step; else null. */
    public SolverBody solver() {
        return isSolved() ? solver : null;
    }

    /** Whether it is far in another thing, or was just now. */
    public boolean isDeep() {
        return solver.isDeep();
    }

    /** Whether contacts and gravity move it in this step. */
    boolean isSolved() {
        return mass > 0 && state == State.AWAKE;
    }

    /** Takes it out of the physics until the world starts anew; it stays where it is. */
    public void stop() {
        state = State.STOPPED;
    }

    /** The height of its lowest point, world frame, metres. */
    public double lowest() {
        double least = Double.POSITIVE_INFINITY;
        for (PlacedSolid one : place()) {
            least = Math.min(least, one.box.minY);
        }
        return least;
    }

    /** Ends its sleep. */
    public void wake() {
        if (canWake()) {
            state = State.AWAKE;
            rest.begin(solver);
        }
    }

    /** Whether it can move but sleeps. */
    boolean canWake() {
        return mass > 0 && state == State.ASLEEP;
    }

    /** Who fell asleep together has the same number; 0 before the first time. */
    int getGroup() {
        return group;
    }

    /** Puts it to sleep, with others. */
    void sleep(int newGroup) {
        group = newGroup;
        solver.halt();
        turningSpeed = 0;
        state = State.ASLEEP;
    }

    /** Whether the robot's motors turn: then it does not sleep. */
    public void setDriven(boolean on) {
        driven = on;
    }

    /** Whether it is that of a robot. */
    public boolean isRobot() {
        return robot;
    }

    boolean isDriven() {
        return driven;
    }

    /** Whether it never moves. */
    public boolean isFixed() {
        return mass == 0;
    }

    public Pose getPose() {
        return pose;
    }

    public Pose getStart() {
        return start;
    }

    /** Says where it starts. Before the world starts. */
    public void setStart(Pose newStart) {
        start = newStart;
        pose = newStart;
    }

    /** Centre of mass in the body's frame: {x, y, z}. */
    public double[] getCentre() {
        return new double[] {cx, cy, cz};
    }
}
