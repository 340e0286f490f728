// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.SEAR.collision.ConvexShape;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.geometry.PrincipalAxes;
import org.SEAR.physics.joint.JointedBody;
import org.SEAR.physics.solid.MassProperties;
import org.SEAR.physics.solid.Solid;

/**
 * Rigid body: an environment object or a robot's body. Its frame is the object's frame. The solver's frame has the same
 * axes and its origin in the centre of mass (cx, cy, cz). Simulation thread.
 */
public final class Body {
    /** Smallest principal moment of inertia as a share of mass times squared reach; thinner bodies can't be solved. */
    private static final double MIN_INERTIA = 1e-6;

    public final String name;
    public final double mass;
    /** Index in the world's list of bodies. */
    int number;
    /** Stack level: 1 on a fixed body, 2 on a body of level 1, and so on. */
    int level;
    public final List<Solid> solids;
    /** Pose of each solid in the body's frame. */
    public final Pose[] places;
    private int[] shapes = {};
    private final MassProperties properties;
    private final PrincipalAxes principal;
    private final double cx;
    private final double cy;
    private final double cz;
    private final PlacedSolid[] placed;
    private long placedAt = -1;
    private int shapeVersion;
    private double reach;
    private double leastHalf;
    /** Bodies of its robot; null if it belongs to none. */
    private RobotBodies robot;
    private boolean driven;
    private boolean carried;
    private boolean touching;
    private int group;
    private int contacts;
    private double turned;
    private double turningSpeed;
    private boolean rolls;
    private Symmetry symmetry = Symmetry.NONE;
    private Pose start;
    private Pose pose;
    /** Joints that connect it with bodies with which it does not collide meanwhile. */
    private final List<JointedBodies.Link> passing = new ArrayList<>();
    private final Aabb near = new Aabb();
    private State state = State.ASLEEP;
    private final SolverBody solver = new SolverBody();
    private final SleepTimer rest = new SleepTimer();
    private final Frame frame = new Frame();

    /** Fixed bodies are always asleep. */
    private enum State {
        AWAKE, ASLEEP, STOPPED
    }

    /** Axes of rotational symmetry. */
    private enum Symmetry {
        NONE, ABOUT_Y, BALL
    }

    /** @param properties in the body's frame; {@link MassProperties#FIXED} for a fixed body */
    public Body(String name, MassProperties properties, List<Solid> solids, Pose[] places, Pose start) {
        this.name = name;
        this.properties = properties;
        mass = properties.mass;
        principal = PrincipalAxes.of(properties.inertia);
        double[] centre = properties.centre();
        this.solids = solids;
        this.places = places;
        this.cx = centre[0];
        this.cy = centre[1];
        this.cz = centre[2];
        this.start = start;
        this.pose = start;
        placed = PlacedSolid.of(solids, mass > 0);
        if (placed.length == 1 && mass > 0 && places[0].qw == 1) {
            ConvexShape shape = solids.get(0).convex();
            symmetry = shape.isBall() ? Symmetry.BALL : shape.isTurned() ? Symmetry.ABOUT_Y : Symmetry.NONE;
        }
    }

    /**
     * Adds the first {@code count} solids to the scenes; the others only collide.
     * @param visible whether rays of sensors see each solid
     */
    public void addTo(RaycastScenes scenes, List<Boolean> visible, int owner, int count) {
        shapes = new int[count];
        for (int i = 0; i < count; i++) {
            shapes[i] = scenes.add(this, solids.get(i), visible.get(i), owner);
        }
    }

    /** Copies the poses of its solids to the scenes. */
    public void mirror(RaycastScenes scenes) {
        for (int i = 0; i < shapes.length; i++) {
            frame.set(pose);
            if (places[i] != Pose.IDENTITY) {
                frame.times(places[i]);
            }
            scenes.setPose(shapes[i], frame);
        }
    }

    /** Moves the body to its start pose, at rest. */
    void restart() {
        pose = start;
        reach = reach();
        leastHalf = mass > 0 ? Arrays.stream(placed).mapToDouble(part -> part.shape.least()).min().orElse(0) : 0;
        rolls = robot == null && mass > 0 && solids.stream().anyMatch(solid -> solid.convex().isRound());
        solver.setMass(mass, principal.atLeast(MIN_INERTIA * mass * reach * reach));
        put(start);
        carried = false;
        group = 0;
        state = mass > 0 ? State.AWAKE : State.ASLEEP;
    }

    private void put(Pose at) {
        double[] centre = at.transform(cx, cy, cz);
        solver.put(centre[0], centre[1], centre[2], at);
        rest.begin(solver);
        placedAt = -1;
        turningSpeed = 0;
        touching = false;
        shapeVersion++;    // known contacts are invalid
    }

    private static void set(Pose pose, Placement into) {
        into.setRotation(pose.qx, pose.qy, pose.qz, pose.qw);
        into.x = pose.x;
        into.y = pose.y;
        into.z = pose.z;
    }

    /** Teleports the body, at rest, and sets its start pose. */
    void moveTo(Pose newStart, Pose to) {
        start = newStart;
        pose = to;
        put(to);
        state = mass > 0 ? State.AWAKE : State.ASLEEP;
    }

    /** Increases when the body is teleported. */
    int getShapeVersion() {
        return shapeVersion;
    }

    /** Whether it collides as one shape. */
    boolean isSingle() {
        return placed.length == 1;
    }

    /** Returns the colliding parts of its solids at their current world poses. */
    PlacedSolid[] place() {
        if (placedAt == solver.getMoves()) {
            return placed;
        }
        placedAt = solver.getMoves();
        Placement at = solver.place;
        for (int i = 0; i < placed.length; i++) {
            Placement into = placed[i].place;
            set(places[placed[i].number], into);
            into.x -= cx;
            into.y -= cy;
            into.z -= cz;
            into.within(at);
            placed[i].bound();
        }
        return placed;
    }

    private double reach() {
        double farthest = 0;
        for (int i = 0; i < places.length && mass > 0; i++) {
            double off = Math.sqrt((places[i].x - cx) * (places[i].x - cx) + (places[i].y - cy) * (places[i].y - cy)
                + (places[i].z - cz) * (places[i].z - cz));
            farthest = Math.max(farthest, off + solids.get(i).convex().radius());
        }
        return farthest;
    }

    /** Upper bound of the distance of its furthest point from the centre of mass, metres. */
    double getReach() {
        return reach;
    }

    /** Half of the smallest extent of its solids, metres. */
    double getLeast() {
        return leastHalf;
    }

    /** Whether rolling friction acts on it; robots roll on wheels. */
    boolean canRoll() {
        return rolls;
    }

    /** Lets it pass through the other end of a joint until the joint breaks. */
    void pass(JointedBodies.Link link) {
        passing.add(link);
    }

    /** Whether both bodies pass through each other. */
    public boolean ignores(Body other) {
        if (robot != null && robot.isOneWith(other.robot) || placed.length == 0 || other.placed.length == 0) {
            return true;
        }
        List<JointedBodies.Link> through = RobotBodies.base(this).passing;
        for (int i = 0; i < through.size(); i++) {
            if (through.get(i).holds(RobotBodies.base(other))) {
                return true;
            }
        }
        return false;
    }

    /** Begins a step. */
    void begin() {
        solver.begin();
        RobotBodies.release(this);
        noteTurningSpeed();
    }

    /** Upper bound of the surface speed due to rotation when last noted, m/s. */
    double getTurningSpeed() {
        return turningSpeed;
    }

    /** Notes the surface speed due to rotation. */
    void noteTurningSpeed() {
        turningSpeed = turningSpeed();
    }

    /** Rotation about an axis of symmetry does not move the surface. */
    private double turningSpeed() {
        double[] v = solver.v;
        double square = v[3] * v[3] + v[4] * v[4] + v[5] * v[5];
        if (square == 0 || symmetry == Symmetry.BALL) {
            return 0;
        }
        if (symmetry == Symmetry.ABOUT_Y) {
            Placement at = solver.place;
            double about = v[3] * at.m01 + v[4] * at.m11 + v[5] * at.m21;
            square = Math.max(0, square - about * about);
        }
        return Math.sqrt(square) * reach;
    }

    /** Upper bound of the distance that its surface has moved by rotation so far, metres. */
    double getTurned() {
        return turned;
    }

    /**
     * Whether a surface point is a corner, which rotates with the body.
     * @param x in the frame of its centre of mass, metres, likewise y and z
     */
    boolean isCorner(int solid, double x, double y, double z) {
        Pose place = places[solid];
        double[] own = place.rotateBack(x + cx - place.x, y + cy - place.y, z + cz - place.z);
        return solids.get(solid).convex().isCorner(own[0], own[1], own[2]);
    }

    /** Begins a new search for contacts. */
    void clearContacts() {
        contacts = 0;
    }

    /**
     * Counts a possible contact.
     * @return number of contacts so far; 0 for a fixed body
     */
    int countContact() {
        return mass > 0 ? ++contacts : 0;
    }

    /** Whether it rolls about its y axis only: over its rims it tips. */
    boolean isRoundAboutAxis() {
        return symmetry == Symmetry.ABOUT_Y && solids.get(0).convex().isRimmed();
    }

    boolean isBall() {
        return symmetry == Symmetry.BALL;
    }

    /** Whether it collides by triangles. */
    boolean isMesh() {
        return placed.length > 0 && placed[0].isMesh();
    }

    /** Returns its motion, mass and inertia, for joints. */
    public JointedBody forJoints() {
        return solver;
    }

    SolverBody getSolver() {
        return solver;
    }

    /** Takes over the pose from the solver after a step. */
    void follow() {
        double[] moved = solver.moved;
        turned += symmetry == Symmetry.BALL ? 0
            : Math.sqrt(moved[3] * moved[3] + moved[4] * moved[4] + moved[5] * moved[5]) * reach;
        AngularState spin = solver.spin();
        double qx = spin.qx();
        double qy = spin.qy();
        double qz = spin.qz();
        double qw = spin.qw();
        double tx = 2 * (qy * cz - qz * cy);
        double ty = 2 * (qz * cx - qx * cz);
        double tz = 2 * (qx * cy - qy * cx);
        pose = new Pose(solver.place.x - (cx + qw * tx + qy * tz - qz * ty),
            solver.place.y - (cy + qw * ty + qz * tx - qx * tz),
            solver.place.z - (cz + qw * tz + qx * ty - qy * tx), qx, qy, qz, qw);
    }

    SleepTimer getSleepTimer() {
        return rest;
    }

    /** Sets a box to the body's bounds in the world frame. */
    void bounds(Aabb into) {
        if (placed.length == 0) {
            Placement at = solver.place;
            into.clear().add(at.x, at.y, at.z);
            return;
        }
        place();
        into.set(placed[0].box);
        for (int i = 1; i < placed.length; i++) {
            into.add(placed[i].box);
        }
    }

    /** Box of the broad phase: where the body may be within the step. Not a copy. */
    Aabb getNear() {
        return near;
    }

    /** Widens a box by the distance that the body may move within a time. */
    void widen(Aabb box, double seconds) {
        if (isFixed() || !isActive()) {
            return;
        }
        box.sweep(solver.v[0] * seconds, solver.v[1] * seconds, solver.v[2] * seconds).grow(turningSpeed * seconds);
    }

    /**
     * Computes the velocity of a point of the body, m/s; all in the world frame.
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
     * Copies the angular velocity in the world frame, rad/s.
     * @param into takes {x, y, z}
     */
    public void angularVelocity(double[] into) {
        System.arraycopy(solver.v, 3, into, 0, 3);
    }

    /**
     * Sets the velocity of the centre of mass, m/s, and the angular velocity, rad/s, both in the world frame; wakes the
     * body. The links of a robot follow.
     */
    public void setVelocities(double vx, double vy, double vz, double wx, double wy, double wz) {
        double[] v = solver.v;
        if (robot != null && robot.leads(this)) {
            robot.follow(vx, vy, vz, wx, wy, wz);
        }
        v[0] = vx;
        v[1] = vy;
        v[2] = vz;
        v[3] = wx;
        v[4] = wy;
        v[5] = wz;
        wake();
    }

    /** Adds a force at the centre of mass for the next step, N, world frame. */
    public void pull(double x, double y, double z) {
        solver.pull(x, y, z);
    }

    /**
     * Copies the velocities of the centre of mass, world frame.
     * @param v takes {vx, vy, vz, wx, wy, wz}, m/s and rad/s
     */
    public void velocities(double[] v) {
        System.arraycopy(solver.v, 0, v, 0, v.length);
    }

    /** Whether it neither touched nor came near another body in the last step. */
    public boolean isFree() {
        return !touching;
    }

    void setTouching(boolean on) {
        touching = on;
    }

    /** Sets whether its wheels on the ground carry it. */
    public void setCarried(boolean on) {
        carried = on;
    }

    boolean isCarried() {
        return carried;
    }

    /** Whether it is awake. */
    public boolean isActive() {
        return state == State.AWAKE;
    }

    /** Returns the solver's body; null if contacts and gravity do not move it in this step. */
    public SolverBody solver() {
        return isSolved() ? solver : null;
    }

    /** Whether it penetrates another body deeply, or did a few substeps ago. */
    public boolean isDeep() {
        return solver.isDeep();
    }

    /** Whether contacts and gravity move it in this step. */
    boolean isSolved() {
        return mass > 0 && state == State.AWAKE;
    }

    /** Removes the body from the simulation until the world restarts; its pose stays. */
    public void stop() {
        state = State.STOPPED;
    }

    /** Returns the lower end of its bounding boxes: y in the world frame, metres. */
    public double lowest() {
        double least = Double.POSITIVE_INFINITY;
        for (PlacedSolid one : place()) {
            least = Math.min(least, one.box.minY);
        }
        return least;
    }

    /** Wakes the body if it sleeps. */
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

    /** Number shared by bodies that fell asleep together; 0 before the first sleep. */
    int getGroup() {
        return group;
    }

    /** Puts the body to sleep as a member of a group. */
    void sleep(int newGroup) {
        group = newGroup;
        solver.halt();
        turningSpeed = 0;
        state = State.ASLEEP;
    }

    /** Sets whether the robot's motors turn, which prevents sleep. */
    public void setDriven(boolean on) {
        driven = on;
    }

    /** Sets the bodies of its robot. Rolling friction does not act on robots. */
    void setRobot(RobotBodies bodies) {
        robot = bodies;
    }

    /** Bodies of its robot; null if it belongs to none. */
    RobotBodies getRobot() {
        return robot;
    }

    public boolean isRobot() {
        return robot != null;
    }

    boolean isDriven() {
        return driven;
    }

    public boolean isFixed() {
        return mass == 0;
    }

    public Pose getPose() {
        return pose;
    }

    public Pose getStart() {
        return start;
    }

    /** Sets the start pose. Before the world starts. */
    public void setStart(Pose newStart) {
        start = newStart;
        pose = newStart;
        if (robot != null) {
            robot.start(this);
        }
    }

    /** Mass, centre of mass and inertia tensor, in the body's frame. */
    public MassProperties getMassProperties() {
        return properties;
    }

    /** Centre of mass in the body's frame: {x, y, z}, metres. */
    public double[] getCentre() {
        return new double[] {cx, cy, cz};
    }
}
