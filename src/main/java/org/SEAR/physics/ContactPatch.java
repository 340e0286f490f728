package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.CollisionAlgorithm;
import com.bulletphysics.collision.broadphase.CollisionAlgorithmConstructionInfo;
import com.bulletphysics.collision.broadphase.DispatcherInfo;
import com.bulletphysics.collision.dispatch.CollisionAlgorithmCreateFunc;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import com.bulletphysics.collision.shapes.BvhTriangleMeshShape;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.TriangleCallback;
import com.bulletphysics.linearmath.Transform;
import com.bulletphysics.util.ObjectArrayList;
import javax.vecmath.Vector3f;
import org.SEAR.collision.Closest;
import org.SEAR.collision.Contacts;
import org.SEAR.collision.Patch;
import org.SEAR.collision.Triangle;
import org.SEAR.geometry.Placement;

/**
 * The contact of two solids, or of a solid and the triangles of a fixed mesh, in exact geometry: jbullet's own algorithms work in single precision
 * with margins of a centimetre and let things stop millimetres early or late. Simulation thread.
 */
public final class ContactPatch extends CollisionAlgorithm {
    private final Closest closest;
    private final Patch patch;
    private final Contacts contacts;
    private final Handover handover;
    private final Placed placedA;
    private final Placed placedB;
    private final Triangle triangle;
    private final Transform place = new Transform();
    private final Placement placeOfMesh = new Placement();
    private final Transform inMesh = new Transform();
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private PersistentManifold manifold;
    private final TriangleCallback triangles = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] corners, int part, int index) {
            if (triangle.set(corners, placeOfMesh) && triangle.isNear(placedA, Patch.BREAKING) && closest.measure(placedA, triangle, Patch.BREAKING)
                && !pushOut()) {
                triangle.feature(closest.nx, closest.ny, closest.nz, patch.ofB);
                touch();
            }
        }
    };

    private ContactPatch(CollisionAlgorithmConstructionInfo info, Maker maker) {
        closest = maker.closest;
        patch = maker.patch;
        contacts = maker.contacts;
        handover = maker.handover;
        placedA = maker.placedA;
        placedB = maker.placedB;
        triangle = maker.triangle;
        init(info);
    }

    /** Makes them for a world. They work one after the other and share their tools: pairs come and go all the time. */
    static final class Maker extends CollisionAlgorithmCreateFunc {
        private final Closest closest = new Closest();
        private final Patch patch = new Patch();
        private final Contacts contacts = new Contacts();
        private final Handover handover = new Handover();
        private final Placed placedA = new Placed();
        private final Placed placedB = new Placed();
        private final Triangle triangle = new Triangle();

        @Override
        public CollisionAlgorithm createCollisionAlgorithm(CollisionAlgorithmConstructionInfo info, CollisionObject a, CollisionObject b) {
            return new ContactPatch(info, this);
        }

        @Override
        public void releaseCollisionAlgorithm(CollisionAlgorithm algorithm) {
            // garbage collection does
        }
    }

    @Override
    public void processCollision(CollisionObject first, CollisionObject second, DispatcherInfo info, ManifoldResult result) {
        boolean swapped = first.getCollisionShape() instanceof BvhTriangleMeshShape;
        CollisionObject a = swapped ? second : first;
        CollisionObject b = swapped ? first : second;
        if (manifold == null) {
            manifold = dispatcher.getNewManifold(a, b);
        }
        result.setPersistentManifold(manifold);
        contacts.clear();
        a.getWorldTransform(place);
        placedA.set((Solid) a.getCollisionShape().getUserPointer(), place);
        if (b.getCollisionShape() instanceof BvhTriangleMeshShape) {
            meetMesh(a.getCollisionShape(), b);
        } else {
            b.getWorldTransform(place);
            placedB.set((Solid) b.getCollisionShape().getUserPointer(), place);
            if (closest.measure(placedA, placedB, Patch.BREAKING)) {
                patch.ofB.clear();
                placedB.feature(closest.nx, closest.ny, closest.nz, patch.ofB);
                touch();
            }
        }
        handover.give(contacts, manifold, result);
        Handover.announce(contacts, (Body) a.getUserPointer(), (Body) b.getUserPointer());
    }

    private void meetMesh(CollisionShape shape, CollisionObject mesh) {
        Transform placeOfA = new Transform(place);
        mesh.getWorldTransform(place);
        Placed.toPlacement(place, placeOfMesh);
        inMesh.inverse(place);
        inMesh.mul(placeOfA);
        shape.getAabb(inMesh, low, high);
        low.set(low.x - Patch.BREAKING, low.y - Patch.BREAKING, low.z - Patch.BREAKING);
        high.set(high.x + Patch.BREAKING, high.y + Patch.BREAKING, high.z + Patch.BREAKING);
        ((BvhTriangleMeshShape) mesh.getCollisionShape()).processAllTriangles(triangles, low, high);
    }

    /** What has come a little way through a triangle goes back through it, not sideways over its edges to the next triangle. */
    private boolean pushOut() {
        if (closest.distance >= 0 || triangle.depth() > Patch.BREAKING) {
            return false;
        }
        triangle.front(patch.ofB);
        placedA.feature(-patch.ofB.nx, -patch.ofB.ny, -patch.ofB.nz, patch.ofA);
        return patch.faces(patch.ofB.nx, patch.ofB.ny, patch.ofB.nz, contacts);
    }

    private void touch() {
        placedA.feature(-closest.nx, -closest.ny, -closest.nz, patch.ofA);
        patch.find(closest, contacts);
    }

    @Override
    public float calculateTimeOfImpact(CollisionObject a, CollisionObject b, DispatcherInfo info, ManifoldResult result) {
        return 1;
    }

    @Override
    public void getAllContactManifolds(ObjectArrayList<PersistentManifold> into) {
        if (manifold != null) {
            into.add(manifold);
        }
    }

    @Override
    public void destroy() {
        if (manifold != null) {
            dispatcher.releaseManifold(manifold);
        }
        manifold = null;
    }
}
