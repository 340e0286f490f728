package org.SEAR.physics;

import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.CompoundShape;
import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.dynamics.RigidBodyConstructionInfo;
import com.bulletphysics.linearmath.Transform;
import java.util.List;
import javax.vecmath.Quat4f;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Frame;
import org.SEAR.geometry.Placement;
import org.SEAR.geometry.Pose;
import org.SEAR.physics.solid.Solid;

/**
 * One thing that can be touched: an environment object or a robot's body. Its frame is that of the object; jbullet's body sits in the centre of
 * mass, (cx, cy, cz) of that frame. Simulation thread.
 */
public final class Body {
    /** Smallest moment of inertia, as a share of mass times square metre, that a thin body is given so that it can be solved. */
    private static final float LEAST_INERTIA = 1e-4f;

    /** For how many steps a body has to stay where it is before it may sleep. */
    private static final int STILL_STEPS = 60;
    private static final double TURN_PER_METRE = 10;
    /** More than jbullet's two seconds, after which a slow body falls asleep. */
    private static final float DEACTIVATED = 10;

    public final String name;
    public final double mass;
    /** Its place in the order of the world. */
    int number;
    public final List<Solid> solids;
    /** Where each solid stands in the body's frame. */
    public final Pose[] places;
    private int[] shapes = {};
    private final double cx;
    private final double cy;
    private final double cz;
    private final CollisionShape collision;
    private double leastReach;
    private boolean robot;
    private ApproachConstraints approach;
    private boolean driven;
    private Pose anchor;
    private int still;
    /** Where it starts. */
    private Pose start;
    private Pose pose;
    private RigidBody rigid;
    private final Transform home = new Transform();
    private Motion motion;
    private RollingResistance rolling;
    private final Frame frame = new Frame();
    private final Transform transform = new Transform();
    private final Quat4f rotation = new Quat4f();
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private final Vector3f position = new Vector3f();
    private final Vector3f axis = new Vector3f();

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
        this.collision = makeShape();
    }

    private CollisionShape makeShape() {
        if (solids.size() == 1 && isAtCentre(places[0])) {
            return solids.get(0).collision(mass > 0);
        }
        CompoundShape compound = new CompoundShape();
        for (int i = 0; i < places.length; i++) {
            Transform child = new Transform();
            centred(places[i], child);
            compound.addChildShape(child, solids.get(i).collision(mass > 0));
        }
        return compound;
    }

    /** Whether its solids are children of one shape; else its only solid is where its centre of mass is. */
    boolean isCompound() {
        return collision instanceof CompoundShape;
    }

    private boolean isAtCentre(Pose place) {
        return place.x == cx && place.y == cy && place.z == cz && place.qw == 1;
    }

    static void toTransform(Pose pose, Transform to) {
        to.setRotation(new Quat4f((float) pose.qx, (float) pose.qy, (float) pose.qz, (float) pose.qw));
        to.origin.set((float) pose.x, (float) pose.y, (float) pose.z);
    }

    /** Copies where jbullet has something. */
    static void toPlacement(Transform from, Placement into) {
        into.m00 = from.basis.m00;
        into.m01 = from.basis.m01;
        into.m02 = from.basis.m02;
        into.m10 = from.basis.m10;
        into.m11 = from.basis.m11;
        into.m12 = from.basis.m12;
        into.m20 = from.basis.m20;
        into.m21 = from.basis.m21;
        into.m22 = from.basis.m22;
        into.x = from.origin.x;
        into.y = from.origin.y;
        into.z = from.origin.z;
    }

    /**
     * Puts its first solids into the scenes; the others only collide.
     *
     * @param visible whether beams see each
     */
    public void addTo(Scenes scenes, List<Boolean> visible, int owner, int count) {
        shapes = new int[count];
        for (int i = 0; i < count; i++) {
            shapes[i] = scenes.add(this, solids.get(i), visible.get(i), owner);
        }
    }

    /** Moves its solids in the scenes to where it is. */
    public void mirror(Scenes scenes) {
        for (int i = 0; i < shapes.length; i++) {
            frame.set(pose);
            if (places[i] != Pose.IDENTITY) {
                frame.times(places[i]);
            }
            scenes.setPose(shapes[i], frame);
        }
    }

    /** A fresh jbullet body at the start pose. */
    void restart() {
        pose = start;
        anchor = start;
        still = 0;
        Vector3f inertia = new Vector3f();
        if (mass > 0) {
            if (solids.size() == 1 && places[0].qw == 1) {
                double[] moments = solids.get(0).convex().inertia();
                inertia.set((float) (mass * moments[0]), (float) (mass * moments[1]), (float) (mass * moments[2]));
            } else {
                collision.calculateLocalInertia((float) mass, inertia);
            }
            float least = (float) mass * LEAST_INERTIA;
            inertia.set(Math.max(inertia.x, least), Math.max(inertia.y, least), Math.max(inertia.z, least));
        }
        RigidBodyConstructionInfo info = new RigidBodyConstructionInfo((float) mass, null, collision, inertia);
        toTransform(centred(start), info.startWorldTransform);
        rigid = new RigidBody(info);
        rigid.setUserPointer(this);
        home.set(info.startWorldTransform);
        motion = mass > 0 ? new Motion(rigid, reach(), getRestitution() > 0) : null;
        rolling = mass > 0 && canRoll() ? new RollingResistance(rigid) : null;
        rigid.setActivationState(mass > 0 ? CollisionObject.ACTIVE_TAG : CollisionObject.ISLAND_SLEEPING);
    }

    /** Puts it elsewhere at once, at rest, and says where the next start of the world finds it. */
    void moveTo(Pose newStart, Pose to) {
        start = newStart;
        pose = to;
        anchor = to;
        still = 0;
        toTransform(centred(to), home);
        rigid.setCenterOfMassTransform(home);
        rigid.setInterpolationWorldTransform(home);
        if (mass > 0) {
            low.set(0, 0, 0);
            rigid.setLinearVelocity(low);
            rigid.setAngularVelocity(low);
            rigid.clearForces();
            rigid.setSleepingThresholds(0, 0);
            rigid.setDeactivationTime(0);
            rigid.forceActivationState(CollisionObject.ACTIVE_TAG);
        }
    }

    /** Says how far from its centre of mass solids come that are going to move in it, metres. Before the world starts. */
    public void setLeastReach(double metres) {
        leastReach = metres;
    }

    /**
     * Moves one of its solids in its own frame. A body of a single solid that stands in its centre of mass goes on to collide as before.
     *
     * @param solid its number
     */
    public void setPlace(int solid, Pose place) {
        places[solid] = place;
        if (isCompound()) {
            CompoundShape compound = (CompoundShape) collision;
            centred(place, compound.getChildList().getQuick(solid).transform);
            compound.recalculateLocalAabb();
        }
    }

    /** Where a solid is seen from the centre of mass. */
    private void centred(Pose place, Transform child) {
        toTransform(place, child);
        child.origin.x -= (float) cx;
        child.origin.y -= (float) cy;
        child.origin.z -= (float) cz;
    }

    /** Distance of its farthest point from its centre of mass, metres, or more. */
    private double reach() {
        double farthest = leastReach;
        for (int i = 0; i < places.length; i++) {
            double off = Math.sqrt((places[i].x - cx) * (places[i].x - cx) + (places[i].y - cy) * (places[i].y - cy)
                + (places[i].z - cz) * (places[i].z - cz));
            farthest = Math.max(farthest, off + solids.get(i).convex().radius());
        }
        return farthest;
    }

    private boolean canRoll() {
        return !robot && solids.stream().anyMatch(solid -> solid.convex().isRound());
    }

    /** The greatest of its solids' restitutions. */
    private double getRestitution() {
        return solids.stream().mapToDouble(solid -> solid.getSurface().restitution()).max().orElse(0);
    }

    /** The axis about which it can turn without looking different, in the world; null if there is none. */
    Vector3f turningAxis() {
        if (solids.size() != 1 || !solids.get(0).convex().isTurned() || places[0].qw != 1) {
            return null;
        }
        rigid.getCenterOfMassTransform(transform);
        axis.set(transform.basis.m01, transform.basis.m11, transform.basis.m21);
        return axis;
    }

    /** Where its centre of mass is when a step begins. jbullet itself shows the place of one solid while it looks at the contacts of several. */
    Transform getPlace() {
        return motion == null ? home : motion.start();
    }

    /** How it moves within a step; null if it never does. */
    Motion getMotion() {
        return motion;
    }

    /** What brakes it when it rolls; null for what can't roll. */
    RollingResistance getRolling() {
        return rolling;
    }

    private Pose centred(Pose frame) {
        double[] centre = frame.transform(cx, cy, cz);
        return new Pose(centre[0], centre[1], centre[2], frame.qx, frame.qy, frame.qz, frame.qw);
    }

    /** Takes over where jbullet has moved it. */
    void follow() {
        rigid.getCenterOfMassTransform(transform);
        Turning.quaternion(transform.basis, rotation);
        double length = Math.sqrt((double) rotation.x * rotation.x + (double) rotation.y * rotation.y + (double) rotation.z * rotation.z
            + (double) rotation.w * rotation.w);
        double qx = rotation.x / length;
        double qy = rotation.y / length;
        double qz = rotation.z / length;
        double qw = rotation.w / length;
        double tx = 2 * (qy * cz - qz * cy);
        double ty = 2 * (qz * cx - qx * cz);
        double tz = 2 * (qx * cy - qy * cx);
        pose = new Pose(transform.origin.x - (cx + qw * tx + qy * tz - qz * ty), transform.origin.y - (cy + qw * ty + qz * tx - qx * tz),
            transform.origin.z - (cz + qw * tz + qx * ty - qy * tx), qx, qy, qz, qw);
    }

    /**
     * Lets jbullet put the body to sleep when it has stayed within a band for a while; measured on poses, because the speeds of a body at rest
     * tremble more than slow bodies move.
     *
     * @param band metres, and radians times ten
     */
    void rest(double band, boolean mayRest) {
        double dx = pose.x - anchor.x;
        double dy = pose.y - anchor.y;
        double dz = pose.z - anchor.z;
        double cosine = Math.abs(pose.qx * anchor.qx + pose.qy * anchor.qy + pose.qz * anchor.qz + pose.qw * anchor.qw);
        if (!mayRest || dx * dx + dy * dy + dz * dz > band * band || cosine < Math.cos(TURN_PER_METRE * band / 2)) {
            anchor = pose;
            still = 0;
            rigid.setSleepingThresholds(0, 0);
        } else if (++still == STILL_STEPS) {
            rigid.setSleepingThresholds(Float.MAX_VALUE, Float.MAX_VALUE);
            rigid.setDeactivationTime(DEACTIVATED);
        }
    }

    /** The box around it in the world, margin included. */
    void bounds(double[] into) {
        rigid.getAabb(low, high);
        into[0] = low.x;
        into[1] = low.y;
        into[2] = low.z;
        into[3] = high.x;
        into[4] = high.y;
        into[5] = high.z;
    }

    /**
     * Velocity of a point of the body, m/s, everything in the world frame.
     *
     * @param into takes {x, y, z}
     */
    public void velocityAt(double x, double y, double z, double[] into) {
        rigid.getCenterOfMassPosition(low);
        double rx = x - low.x;
        double ry = y - low.y;
        double rz = z - low.z;
        rigid.getLinearVelocity(low);
        rigid.getAngularVelocity(high);
        into[0] = low.x + high.y * rz - high.z * ry;
        into[1] = low.y + high.z * rx - high.x * rz;
        into[2] = low.z + high.x * ry - high.y * rx;
    }

    /**
     * Angular velocity in the world frame, rad/s.
     *
     * @param into takes {x, y, z}
     */
    public void angularVelocity(double[] into) {
        rigid.getAngularVelocity(high);
        into[0] = high.x;
        into[1] = high.y;
        into[2] = high.z;
    }

    /** Says that it is a robot's body: nothing brakes it but its wheels. */
    public void setRobot() {
        robot = true;
        approach = new ApproachConstraints();
    }

    /**
     * Says that something stands near a robot's body.
     *
     * @param nx from there to the body, world frame
     * @param x of its surface
     * @param gap metres
     */
    void near(Body other, double nx, double ny, double nz, double x, double y, double z, double gap) {
        if (approach != null) {
            approach.add(other, nx, ny, nz, x, y, z, gap);
        }
    }

    /** Forgets what stands near a robot's body; each step finds it anew. */
    public void forgetObstacles() {
        approach.clear();
    }

    /** Gives what stood near a robot's body, where it can move, what it took to stop before it. */
    public void pushObstacles(double[] impulse, double[] at) {
        for (int i = 0; i < approach.size(); i++) {
            if (approach.reaction(i, impulse, at)) {
                approach.body(i).push(impulse, at);
            }
        }
    }

    /** What keeps a robot's body from entering what it comes near to; null if this is none. */
    ApproachConstraints getApproach() {
        return approach;
    }

    /**
     * Changes its velocities at once.
     *
     * @param impulse {x, y, z}, Ns, world frame
     * @param at the point of the body where it acts, world frame
     */
    public void push(double[] impulse, double[] at) {
        rigid.getCenterOfMassPosition(position);
        low.set((float) impulse[0], (float) impulse[1], (float) impulse[2]);
        high.set((float) (at[0] - position.x), (float) (at[1] - position.y), (float) (at[2] - position.z));
        rigid.applyImpulse(low, high);
    }

    /** Gives it these velocities at once and wakes it: of its centre of mass, m/s, and of its turning, rad/s, world frame. */
    public void setVelocities(double vx, double vy, double vz, double wx, double wy, double wz) {
        low.set((float) vx, (float) vy, (float) vz);
        high.set((float) wx, (float) wy, (float) wz);
        rigid.setLinearVelocity(low);
        rigid.setAngularVelocity(high);
        rigid.activate();
    }

    /**
     * Velocities of its centre of mass, world frame.
     *
     * @param v takes {vx, vy, vz, wx, wy, wz}, m/s and rad/s
     */
    public void velocities(double[] v) {
        rigid.getLinearVelocity(low);
        rigid.getAngularVelocity(high);
        v[0] = low.x;
        v[1] = low.y;
        v[2] = low.z;
        v[3] = high.x;
        v[4] = high.y;
        v[5] = high.z;
    }

    /** Whether a robot's body touched nothing, and came near nothing, in the last step. */
    public boolean isFree() {
        return approach.size() == 0 && !motion.isTouching();
    }

    /** Says whether wheels on the ground carry it. */
    public void setCarried(boolean on) {
        motion.setCarried(on);
    }

    /** Whether it does not sleep. */
    public boolean isActive() {
        return rigid.isActive();
    }

    /** Takes it out of the physics until the world starts anew; it stays where it is. */
    public void stop() {
        rigid.setActivationState(CollisionObject.DISABLE_SIMULATION);
    }

    /** The height of its lowest point, world frame, metres. */
    public double lowest() {
        rigid.getAabb(low, high);
        return low.y;
    }

    /** Ends its sleep. */
    public void wake() {
        rigid.activate();
    }

    /** Whether the robot's motors turn: then it does not sleep. */
    public void setDriven(boolean on) {
        driven = on;
    }

    boolean isRobot() {
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

    void setStart(Pose newStart) {
        start = newStart;
        pose = newStart;
    }

    RigidBody getRigid() {
        return rigid;
    }

    /** Centre of mass in the body's frame: {x, y, z}. */
    public double[] getCentre() {
        return new double[] {cx, cy, cz};
    }
}
