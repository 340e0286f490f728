// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.io.IOException;
import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.SEAR.POJOs.Model;
import org.SEAR.collision.ConvexParts;
import org.SEAR.collision.ConvexShape;
import org.SEAR.files.LongWork;
import org.SEAR.geometry.Triangles;

/** Convex parts of models; those of the latest meshes are cached by content. Any thread. */
final class MeshPieces {
    /** Number of meshes in the cache. */
    private static final int CACHED = 16;
    private static final Map<List<?>, List<ConvexShape>> CACHE = new LinkedHashMap<List<?>, List<ConvexShape>>(
        CACHED, 1, true) {
        private static final long serialVersionUID = 1;

        @Override
        protected boolean removeEldestEntry(Map.Entry<List<?>, List<ConvexShape>> eldest) {
            return size() > CACHED;
        }
    };

    private MeshPieces() {
    }

    /** @throws IOException if the mesh has too many triangles for parts, or none */
    static void check(Triangles mesh, Model model) throws IOException {
        if (mesh.size() < 1 || mesh.size() > ConvexParts.MAX_TRIANGLES) {
            throw new IOException(String.format(
                Locale.ROOT, "model %s has %d triangles, legal for setCollision(\"parts\"): 1 to %d;"
                + " simplify the model or call setCollision(\"hull\")", model.getName(), mesh.size(),
                    ConvexParts.MAX_TRIANGLES));
        }
    }

    /**
     * Returns the parts, and reports the progress as {@link LongWork}.
     *
     * @param points x, y, z of the mesh's vertices, scaled, metres
     * @param model its name
     */
    static List<ConvexShape> of(Triangles mesh, double[] scale, double[] points, String model) {
        List<?> key = List.of(FloatBuffer.wrap(mesh.vertices), IntBuffer.wrap(mesh.indices), DoubleBuffer.wrap(scale));
        synchronized (CACHE) {
            LongWork work = new LongWork("model " + model + ": splitting into convex parts");
            return CACHE.computeIfAbsent(key,
                absent -> List.copyOf(ConvexParts.of(points, mesh.indices, work::report)));
        }
    }
}
