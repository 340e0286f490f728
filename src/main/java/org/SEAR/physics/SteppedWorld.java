package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.CollisionFilterGroups;
import com.bulletphysics.collision.dispatch.CollisionDispatcher;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.CollisionWorld;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.TimeStep;

/**
 * jbullet's collision world: it keeps the bodies that are near something awake and finds the pairs whose boxes overlap; where a body may go within a
 * step belongs to its box. Simulation thread.
 */
final class SteppedWorld extends CollisionWorld {
    /** By how much boxes are wider than the bodies, metres: more than half of what contacts look ahead, and than single precision loses. */
    private static final double MARGIN = 5e-3;
    /** What stays in a box that is wider by this gets no new one, metres. */
    private static final double ROOM = 0.01;
    private static final short FIXED = CollisionFilterGroups.STATIC_FILTER;
    private static final short MOVING = CollisionFilterGroups.DEFAULT_FILTER;

    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private final Aabb box = new Aabb();

    SteppedWorld(NarrowPhase finder) {
        super(new CollisionDispatcher(finder), new BroadPhase(), finder);
    }

    void add(Body body) {
        boolean fixed = body.isFixed();
        addCollisionObject(body.getRigid(), fixed ? FIXED : MOVING, fixed ? MOVING : (short) (FIXED | MOVING));
    }

    void remove(Body body) {
        removeCollisionObject(body.getRigid());
    }

    @Override
    public void addCollisionObject(CollisionObject object, short group, short mask) {
        super.addCollisionObject(object, group, mask);
        ((Body) object.getUserPointer()).getRoom().clear();
        updateSingleAabb(object);
    }

    @Override
    public void updateSingleAabb(CollisionObject object) {
        Body body = (Body) object.getUserPointer();
        body.bounds(box);
        body.widen(box, TimeStep.SECONDS);
        if (body.getRoom().contains(box)) {
            return;
        }
        Aabb room = body.getRoom().set(box).grow(MARGIN + ROOM);
        low.set((float) room.minX, (float) room.minY, (float) room.minZ);
        high.set((float) room.maxX, (float) room.maxY, (float) room.maxZ);
        broadphasePairCache.setAabb(object.getBroadphaseHandle(), low, high, dispatcher1);
        room.grow(-MARGIN);
    }
}
