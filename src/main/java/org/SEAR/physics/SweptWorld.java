package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.BroadphaseInterface;
import com.bulletphysics.collision.dispatch.CollisionDispatcher;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.dynamics.DiscreteDynamicsWorld;
import com.bulletphysics.dynamics.RigidBody;
import com.bulletphysics.dynamics.constraintsolver.ConstraintSolver;
import com.bulletphysics.linearmath.Transform;
import javax.vecmath.Vector3f;

/** jbullet's world, but bodies fall as a parabola and stop where they would pass through something. Simulation thread. */
final class SweptWorld extends DiscreteDynamicsWorld {
    private static final float MARGIN = 0.02f;

    private final Sweeps sweeps;
    private final float step;
    private final float pull;
    private final Transform scratch = new Transform();
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();

    /**
     * @param step its length, seconds
     * @param pull gravity, m/s^2 downwards
     */
    SweptWorld(CollisionDispatcher dispatcher, BroadphaseInterface pairs, ConstraintSolver solver, ContactConfiguration configuration, float step,
            float pull) {
        super(dispatcher, pairs, solver, configuration);
        sweeps = configuration.getSweeps();
        this.step = step;
        this.pull = pull;
        setGravity(new Vector3f(0, -pull, 0));
    }

    private static Motion motion(CollisionObject object) {
        return object.isActive() ? ((Body) object.getUserPointer()).getMotion() : null;
    }

    /** jbullet's own also works out, and throws away, where each body would be, and brakes it by nothing. */
    @Override
    protected void predictUnconstraintMotion(float timeStep) {
        for (int i = 0; i < collisionObjects.size(); i++) {
            CollisionObject object = collisionObjects.getQuick(i);
            if (motion(object) != null) {
                ((RigidBody) object).integrateVelocities(timeStep);
            }
        }
    }

    @Override
    public void performDiscreteCollisionDetection() {
        sweeps.clear();
        for (int i = 0; i < collisionObjects.size(); i++) {
            Motion motion = motion(collisionObjects.getQuick(i));
            if (motion != null) {
                motion.predict(step);
                RollingResistance rolling = ((Body) collisionObjects.getQuick(i).getUserPointer()).getRolling();
                if (rolling != null) {
                    rolling.clear();
                }
            }
        }
        super.performDiscreteCollisionDetection();
    }

    @Override
    public void updateSingleAabb(CollisionObject object) {
        Motion motion = motion(object);
        if (motion == null || !motion.isFast()) {
            super.updateSingleAabb(object);
            return;
        }
        object.getWorldTransform(scratch);
        object.getCollisionShape().getAabb(scratch, low, high);
        motion.widen(low, high, step);
        low.set(low.x - MARGIN, low.y - MARGIN, low.z - MARGIN);
        high.set(high.x + MARGIN, high.y + MARGIN, high.z + MARGIN);
        broadphasePairCache.setAabb(object.getBroadphaseHandle(), low, high, dispatcher1);
    }

    @Override
    protected void integrateTransforms(float timeStep) {
        for (int i = 0; i < collisionObjects.size(); i++) {
            Motion motion = motion(collisionObjects.getQuick(i));
            if (motion != null) {
                motion.plan(timeStep, pull);
            }
        }
        sweeps.stop();
        for (int i = 0; i < collisionObjects.size(); i++) {
            Motion motion = motion(collisionObjects.getQuick(i));
            if (motion != null) {
                motion.go(timeStep, pull, scratch);
            }
        }
    }
}
