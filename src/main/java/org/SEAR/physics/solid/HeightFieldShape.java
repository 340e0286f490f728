package org.SEAR.physics.solid;

import com.bulletphysics.collision.broadphase.BroadphaseNativeType;
import com.bulletphysics.collision.shapes.ConcaveShape;
import com.bulletphysics.collision.shapes.TriangleCallback;
import com.bulletphysics.linearmath.Transform;
import java.util.function.Predicate;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightSearch;

/** The triangles of a height field for a body that never moves; what comes near it meets only those in its box. Simulation thread. */
final class HeightFieldShape extends ConcaveShape {
    private final HeightSearch search;
    private final Vector3f middle = new Vector3f();
    private final Vector3f half = new Vector3f();
    private final Vector3f[] corners = {new Vector3f(), new Vector3f(), new Vector3f()};
    private TriangleCallback callback;
    private final Predicate<float[]> visitor = at -> {
        for (int i = 0; i < corners.length; i++) {
            corners[i].set(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
        }
        callback.processTriangle(corners, 0, 0);
        return false;
    };

    HeightFieldShape(HeightField field) {
        search = new HeightSearch(field);
        Vector3f low = new Vector3f(field.x(0), field.getPyramid().lowest(), field.z(0));
        Vector3f high = new Vector3f(field.x(field.rows - 1), field.getPyramid().highest(), field.z(field.columns - 1));
        middle.add(low, high);
        middle.scale(0.5f);
        half.sub(high, middle);
        setMargin(MeshShapes.MARGIN);
    }

    @Override
    public void processAllTriangles(TriangleCallback triangles, Vector3f low, Vector3f high) {
        callback = triangles;
        search.any(low.x, low.y, low.z, high.x, high.y, high.z, visitor);
    }

    @Override
    public void getAabb(Transform place, Vector3f low, Vector3f high) {
        high.set(middle);
        place.transform(high);
        low.set(high);
        float x = reach(place.basis.m00, place.basis.m01, place.basis.m02);
        float y = reach(place.basis.m10, place.basis.m11, place.basis.m12);
        float z = reach(place.basis.m20, place.basis.m21, place.basis.m22);
        low.set(low.x - x, low.y - y, low.z - z);
        high.set(high.x + x, high.y + y, high.z + z);
    }

    private float reach(float x, float y, float z) {
        return Math.abs(x) * half.x + Math.abs(y) * half.y + Math.abs(z) * half.z + getMargin();
    }

    @Override
    public BroadphaseNativeType getShapeType() {
        return BroadphaseNativeType.TERRAIN_SHAPE_PROXYTYPE;
    }

    @Override
    public void setLocalScaling(Vector3f scaling) {
        throw new UnsupportedOperationException("a height field has the size that it has");
    }

    @Override
    public Vector3f getLocalScaling(Vector3f out) {
        out.set(1, 1, 1);
        return out;
    }

    @Override
    public void calculateLocalInertia(float mass, Vector3f inertia) {
        inertia.set(0, 0, 0);
    }

    @Override
    public String getName() {
        return "HeightField";
    }
}
