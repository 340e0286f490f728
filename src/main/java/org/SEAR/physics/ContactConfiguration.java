package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.BroadphaseNativeType;
import com.bulletphysics.collision.dispatch.CollisionAlgorithmCreateFunc;
import com.bulletphysics.collision.dispatch.DefaultCollisionConfiguration;
import java.util.EnumSet;
import java.util.Set;

/** jbullet's collision algorithms, but {@link ContactAlgorithm} for every pair of shapes that SEAR has. */
final class ContactConfiguration extends DefaultCollisionConfiguration {
    private static final Set<BroadphaseNativeType> SOLIDS = EnumSet.of(BroadphaseNativeType.BOX_SHAPE_PROXYTYPE,
        BroadphaseNativeType.CYLINDER_SHAPE_PROXYTYPE, BroadphaseNativeType.CONE_SHAPE_PROXYTYPE, BroadphaseNativeType.CONVEX_HULL_SHAPE_PROXYTYPE);

    private final Sweeps sweeps = new Sweeps();
    private final CollisionAlgorithmCreateFunc patches = new ContactAlgorithm.Maker(sweeps);

    /** The pairs of a step that may meet within it. */
    Sweeps getSweeps() {
        return sweeps;
    }

    @Override
    public CollisionAlgorithmCreateFunc getCollisionAlgorithmCreateFunc(BroadphaseNativeType a, BroadphaseNativeType b) {
        if (patches != null && (SOLIDS.contains(a) && (SOLIDS.contains(b) || b.isConcave()) || a.isConcave() && SOLIDS.contains(b))) {
            return patches;
        }
        return super.getCollisionAlgorithmCreateFunc(a, b);
    }
}
