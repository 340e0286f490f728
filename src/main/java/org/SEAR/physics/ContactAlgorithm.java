package org.SEAR.physics;

import com.bulletphysics.collision.broadphase.CollisionAlgorithm;
import com.bulletphysics.collision.broadphase.CollisionAlgorithmConstructionInfo;
import com.bulletphysics.collision.broadphase.DispatcherInfo;
import com.bulletphysics.collision.dispatch.CollisionAlgorithmCreateFunc;
import com.bulletphysics.collision.dispatch.CollisionObject;
import com.bulletphysics.collision.dispatch.ManifoldResult;
import com.bulletphysics.collision.narrowphase.PersistentManifold;
import com.bulletphysics.collision.shapes.CollisionShape;
import com.bulletphysics.collision.shapes.ConcaveShape;
import com.bulletphysics.collision.shapes.TriangleCallback;
import com.bulletphysics.linearmath.Transform;
import com.bulletphysics.util.ObjectArrayList;
import javax.vecmath.Vector3f;
import org.SEAR.collision.ContactPoints;
import org.SEAR.collision.ContactTriangle;
import org.SEAR.collision.GjkDistance;
import org.SEAR.collision.ManifoldClipper;
import org.SEAR.collision.PlacedConvex;
import org.SEAR.geometry.Placement;
import org.SEAR.physics.solid.Solid;

/**
 * The contact of two solids, or of a solid and the triangles of a fixed mesh or a terrain, from the shapes themselves in double
 * precision (the poses are jbullet's, in single precision, and so is what it makes of the points): jbullet's own algorithms work in single precision
 * with margins of a centimetre and let things stop millimetres early or late. Simulation thread.
 */
public final class ContactAlgorithm extends CollisionAlgorithm {
    private final GjkDistance gjk;
    private final ManifoldClipper clipper;
    private final ContactPoints contacts;
    private final ManifoldWriter writer;
    private final PlacedConvex placedA;
    private final PlacedConvex placedB;
    private final ContactTriangle triangle;
    private final Sweeps sweeps;
    private final Transform placeOfA = new Transform();
    private final Transform place = new Transform();
    private final Placement placeOfMesh = new Placement();
    private final Transform inMesh = new Transform();
    private final Vector3f low = new Vector3f();
    private final Vector3f high = new Vector3f();
    private PersistentManifold manifold;
    private final TriangleCallback triangles = new TriangleCallback() {
        @Override
        public void processTriangle(Vector3f[] corners, int part, int index) {
            if (triangle.set(corners, placeOfMesh) && triangle.isNear(placedA, ManifoldClipper.BREAKING)
                && gjk.measure(placedA, triangle, ManifoldClipper.BREAKING) && !pushOut()) {
                triangle.feature(gjk.nx, gjk.ny, gjk.nz, clipper.ofB);
                touch();
            }
        }
    };

    private ContactAlgorithm(CollisionAlgorithmConstructionInfo info, Maker maker) {
        gjk = maker.gjk;
        clipper = maker.clipper;
        contacts = maker.contacts;
        writer = maker.writer;
        placedA = maker.placedA;
        placedB = maker.placedB;
        triangle = maker.triangle;
        sweeps = maker.sweeps;
        init(info);
    }

    /** Makes them for a world. They work one after the other and share their tools: pairs come and go all the time. */
    static final class Maker extends CollisionAlgorithmCreateFunc {
        private final GjkDistance gjk = new GjkDistance();
        private final ManifoldClipper clipper = new ManifoldClipper();
        private final ContactPoints contacts = new ContactPoints();
        private final ManifoldWriter writer = new ManifoldWriter();
        private final PlacedConvex placedA = new PlacedConvex();
        private final PlacedConvex placedB = new PlacedConvex();
        private final ContactTriangle triangle = new ContactTriangle();
        private final Sweeps sweeps;

        Maker(Sweeps sweeps) {
            this.sweeps = sweeps;
        }

        @Override
        public CollisionAlgorithm createCollisionAlgorithm(CollisionAlgorithmConstructionInfo info, CollisionObject a, CollisionObject b) {
            return new ContactAlgorithm(info, this);
        }

        @Override
        public void releaseCollisionAlgorithm(CollisionAlgorithm algorithm) {
            // garbage collection does
        }
    }

    @Override
    public void processCollision(CollisionObject first, CollisionObject second, DispatcherInfo info, ManifoldResult result) {
        boolean swapped = first.getCollisionShape().isConcave();
        CollisionObject a = swapped ? second : first;
        CollisionObject b = swapped ? first : second;
        if (manifold == null) {
            manifold = dispatcher.getNewManifold(a, b);
        }
        result.setPersistentManifold(manifold);
        contacts.clear();
        Solid solidA = (Solid) a.getCollisionShape().getUserPointer();
        Solid solidB = (Solid) b.getCollisionShape().getUserPointer();
        a.getWorldTransform(placeOfA);
        b.getWorldTransform(place);
        Body.toPlacement(placeOfA, placedA.set(solidA.convex()));
        boolean near = false;
        if (b.getCollisionShape().isConcave()) {
            meetMesh(a.getCollisionShape(), b);
        } else {
            Body.toPlacement(place, placedB.set(solidB.convex()));
            near = gjk.measure(placedA, placedB, ManifoldClipper.BREAKING);
            if (near) {
                clipper.ofB.clear();
                placedB.feature(gjk.nx, gjk.ny, gjk.nz, clipper.ofB);
                touch();
            }
        }
        if (isFast(a) || isFast(b)) {
            sweeps.add(a, solidA, placeOfA, b, solidB, place, gjk, near);
        }
        writer.give(contacts, solidA, solidB, manifold, result);
        ManifoldWriter.announce(contacts, (Body) a.getUserPointer(), (Body) b.getUserPointer());
    }

    private static boolean isFast(CollisionObject object) {
        Motion motion = ((Body) object.getUserPointer()).getMotion();
        return motion != null && object.isActive() && motion.isFast();
    }

    private void meetMesh(CollisionShape shape, CollisionObject mesh) {
        Body.toPlacement(place, placeOfMesh);
        inMesh.inverse(place);
        inMesh.mul(placeOfA);
        shape.getAabb(inMesh, low, high);
        low.set(low.x - ManifoldClipper.BREAKING, low.y - ManifoldClipper.BREAKING, low.z - ManifoldClipper.BREAKING);
        high.set(high.x + ManifoldClipper.BREAKING, high.y + ManifoldClipper.BREAKING, high.z + ManifoldClipper.BREAKING);
        ((ConcaveShape) mesh.getCollisionShape()).processAllTriangles(triangles, low, high);
    }

    /** What has come a little way through a triangle goes back through it, not sideways over its edges to the next triangle. */
    private boolean pushOut() {
        if (gjk.distance >= 0 || triangle.depth() > ManifoldClipper.BREAKING) {
            return false;
        }
        triangle.front(clipper.ofB);
        placedA.feature(-clipper.ofB.nx, -clipper.ofB.ny, -clipper.ofB.nz, clipper.ofA);
        return clipper.faces(clipper.ofB.nx, clipper.ofB.ny, clipper.ofB.nz, contacts);
    }

    private void touch() {
        placedA.feature(-gjk.nx, -gjk.ny, -gjk.nz, clipper.ofA);
        clipper.find(gjk, contacts);
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
