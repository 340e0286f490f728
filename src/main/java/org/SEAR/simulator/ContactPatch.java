package org.SEAR.simulator;

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

/**
 * The contact of two solids, or of a solid and the triangles of a fixed mesh, in exact geometry: jbullet's own algorithms work in single precision
 * with margins of a centimetre and let things stop millimetres early or late. Simulation thread.
 */
final class ContactPatch extends CollisionAlgorithm {
    /** Surfaces this close already carry each other, metres: a face that rests has all its corners in touch. */
    static final float SKIN = 5e-4f;
    /** Surfaces farther apart than this have no contact, metres; jbullet's own limit. */
    static final float BREAKING = 0.02f;

    private final Closest closest;
    private final Patch patch;
    private final Contacts contacts;
    private final Placed placedA;
    private final Placed placedB;
    private final Triangle triangle;
    private final Transform place = new Transform();
    private final Transform inMesh = new Transform();
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private PersistentManifold manifold;
    private final TriangleCallback triangles = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] corners, int part, int index) {
            if (triangle.set(corners, place) && triangle.isNear(placedA, BREAKING) && closest.measure(placedA, triangle, BREAKING)
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
            if (closest.measure(placedA, placedB, BREAKING)) {
                patch.ofB.clear();
                placedB.feature(closest.nx, closest.ny, closest.nz, patch.ofB);
                touch();
            }
        }
        contacts.give(manifold, result);
        contacts.announce((Body) a.getUserPointer(), (Body) b.getUserPointer());
    }

    private void meetMesh(CollisionShape shape, CollisionObject mesh) {
        Transform placeOfA = new Transform(place);
        mesh.getWorldTransform(place);
        inMesh.inverse(place);
        inMesh.mul(placeOfA);
        shape.getAabb(inMesh, low, high);
        low.set(low.x - BREAKING, low.y - BREAKING, low.z - BREAKING);
        high.set(high.x + BREAKING, high.y + BREAKING, high.z + BREAKING);
        ((BvhTriangleMeshShape) mesh.getCollisionShape()).processAllTriangles(triangles, low, high);
    }

    /** What has come a little way through a triangle goes back through it, not sideways over its edges to the next triangle. */
    private boolean pushOut() {
        if (closest.distance >= 0 || triangle.depth() > BREAKING) {
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
