package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.CollisionAlgorithm;
import com.bulletphysics.collision.broadphase.CollisionAlgorithmConstructionInfo;
import com.bulletphysics.collision.broadphase.DispatcherInfo;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import com.bulletphysics.util.ObjectArrayList;
import java.util.Arrays;

/**
 * The contacts of two bodies from step to step, where jbullet's broad phase has found that their boxes overlap. They are found anew when the bodies
 * may have moved against each other by more than a tolerance, in a step several times if need be; what pushed at a point pushes on. Simulation
 * thread.
 */
final class PairContacts extends CollisionAlgorithm {
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
    private static final int LEAST_SUBSTEPS = 4;

    private final ContactFinder finder;
    private Body a;
    private Body b;
    private Manifold[] now = new Manifold[1];
    private Manifold[] before = new Manifold[1];
    private int count;
    private int countBefore;
    private int version;
    private double tolerance;
    private double still;
    private boolean flat;
    /** How far both may have moved against each other since the contacts were found, metres. */
    private double travelled;
    private double margin;
    private boolean known;
    /** Whether they may touch within the step. */
    private boolean near;
    /** How far apart they were when contacts were found, metres, and along which direction, from b to a. */
    private double apart;
    private double nx;
    private double ny;
    private double nz;
    private boolean fresh;

    PairContacts(CollisionAlgorithmConstructionInfo info, ContactFinder finder) {
        this.finder = finder;
        init(info);
    }

    @Override
    public void processCollision(CollisionObject first, CollisionObject second, DispatcherInfo info, ManifoldResult result) {
        if (a == null) {
            boolean swapped = ((Body) first.getUserPointer()).isMesh();
            a = (Body) (swapped ? second : first).getUserPointer();
            b = (Body) (swapped ? first : second).getUserPointer();
            boolean rolls = a.canRoll() || b.canRoll();
            tolerance = rolls ? TOLERANCE_ROUND : TOLERANCE;
            still = rolls ? 0 : STILL;
            flat = !rolls && a.solids.size() == 1 && b.solids.size() == 1;
        }
        if (finder.isCrowded(a, b)) {
            count = 0;
            known = false;
            return;
        }
        double ahead = finder.stepSeconds();
        double speed = speed(finder.stepGain());
        if (!known || travelled + speed(0) * ahead > still || a.getShapeVersion() + b.getShapeVersion() != version) {
            version = a.getShapeVersion() + b.getShapeVersion();
            find(speed, ahead, ahead / LEAST_SUBSTEPS);
        }
        if (count > 0 || near) {
            finder.list(this);
        }
    }

    /** How fast any points of both may come together, m/s. */
    private double speed(double gain) {
        double[] p = a.getSolver().v;
        double[] q = b.getSolver().v;
        double dx = p[0] - q[0];
        double dy = p[1] - q[1];
        double dz = p[2] - q[2];
        return Math.sqrt(dx * dx + dy * dy + dz * dz) + a.turningSpeed() + b.turningSpeed() + gain;
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
        near = finder.find(this, a, b, margin, MARGIN + speed * (ahead + next));
        travelled = 0;
        known = true;
    }

    /**
     * Finds the contacts anew within a step, if the bodies have moved too far since.
     *
     * @param seconds that the substep will take
     * @return whether it did
     */
    boolean refresh(double seconds) {
        double next = speed(finder.stepGain()) * seconds;
        double most = Math.min(tolerance, SLIP / Math.max(a.getSolver().turning(), b.getSolver().turning()));
        if (travelled + next <= most && travelled + next <= margin - MARGIN / 2) {
            return false;
        }
        find(next / seconds, seconds, seconds);
        fresh = true;
        return true;
    }

    /** Whether its manifolds are new and not prepared. */
    boolean isFresh() {
        return fresh;
    }

    void setFresh(boolean on) {
        fresh = on;
    }

    /** What went through a mesh in the substep goes back. */
    void stopBeforeMesh(double seconds) {
        if (b.isMesh() && a.isSolved() && travelled + speed(0) * seconds > PASSING * a.getLeast()) {
            finder.stopBefore(a, b);
        }
    }

    /** A substep has passed. */
    void moved(double seconds) {
        travelled += speed(0) * seconds;
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
     * The direction in which they touched last.
     *
     * @param into takes it, world frame; stays as it is if they have not touched
     * @return whether they have
     */
    boolean guess(double[] into) {
        if (countBefore > 0) {
            into[0] = before[0].nx;
            into[1] = before[0].ny;
            into[2] = before[0].nz;
        }
        return countBefore > 0;
    }

    /** Whether neither of them is round, and each is of one solid. */
    boolean isFlat() {
        return flat;
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
        double closing = nx * (q[0] - p[0]) + ny * (q[1] - p[1]) + nz * (q[2] - p[2]) + a.turningSpeed() + b.turningSpeed();
        return apart - Math.max(0, closing) * seconds;
    }

    /**
     * Says how far apart two of their solids are, metres, and along which direction, from b to a.
     */
    void approached(double distance, double dx, double dy, double dz) {
        if (distance < apart) {
            apart = distance;
            nx = dx;
            ny = dy;
            nz = dz;
        }
    }

    /** Where nothing moves any more the distances are those now. */
    void settle() {
        for (int i = 0; i < count; i++) {
            now[i].settle();
        }
    }

    @Override
    public float calculateTimeOfImpact(CollisionObject first, CollisionObject second, DispatcherInfo info, ManifoldResult result) {
        return 1;
    }

    /** None: jbullet does not solve them. */
    @Override
    public void getAllContactManifolds(ObjectArrayList<PersistentManifold> into) {
        // jbullet has none
    }

    @Override
    public void destroy() {
        count = 0;
        known = false;
    }
}
