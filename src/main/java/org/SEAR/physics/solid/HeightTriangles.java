// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import com.bulletphysics.collision.shapes.TriangleCallback;
import java.util.function.Predicate;
import javax.vecmath.Vector3f;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightSearch;

/** Triangle search in a height grid; visits only the triangles in the query box. Simulation thread. */
final class HeightTriangles implements TriangleSearch {
    private final HeightSearch search;
    private final Vector3f[] corners = {new Vector3f(), new Vector3f(), new Vector3f()};
    private TriangleCallback callback;
    private final Predicate<float[]> visitor = at -> {
        for (int i = 0; i < corners.length; i++) {
            corners[i].set(at[3 * i], at[3 * i + 1], at[3 * i + 2]);
        }
        callback.processTriangle(corners, 0, 0);
        return false;
    };

    HeightTriangles(HeightGrid field) {
        search = new HeightSearch(field);
    }

    @Override
    public void find(TriangleCallback triangles, Vector3f low, Vector3f high) {
        callback = triangles;
        search.any(low.x, low.y, low.z, high.x, high.y, high.z, visitor);
    }
}
