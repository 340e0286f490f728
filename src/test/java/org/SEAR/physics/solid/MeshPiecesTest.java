// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import org.SEAR.POJOs.Model;
import org.SEAR.collision.ConvexParts;
import org.SEAR.collision.Meshes;
import org.SEAR.geometry.Triangles;
import org.SEAR.project.ProjectRule;
import org.junit.Test;

/** Limits and cache of convex parts. */
public class MeshPiecesTest {
    @Test
    public void tooManyTrianglesAreRefusedWithTheLimit() throws Exception {
        Model model = ProjectRule.unread(() -> new Model("ring", "ring.obj", 1));
        MeshPieces.check(new Triangles(new float[3], new int[3 * ConvexParts.MAX_TRIANGLES]), model);
        for (int count : new int[] {0, ConvexParts.MAX_TRIANGLES + 1}) {
            Triangles mesh = new Triangles(new float[3], new int[3 * count]);
            String message = assertThrows(IOException.class, () -> MeshPieces.check(mesh, model)).getMessage();
            assertTrue(message, message.startsWith(
                "model ring has " + count + " triangles, legal for setCollision(\"parts\"): 1 to 250000"));
        }
    }

    @Test
    public void theSameContentIsSplitOnce() {
        Meshes pair = new Meshes().box(0, 0, 0, 1, 1, 1).box(2, 0, 0, 3, 1, 1);
        double[] scale = {1, 1, 1};
        assertEquals(2, MeshPieces.of(triangles(pair), scale, pair.points(), "pair").size());
        assertSame(MeshPieces.of(triangles(pair), scale, pair.points(), "pair"),
            MeshPieces.of(triangles(pair), scale, pair.points(), "pair"));
    }

    private static Triangles triangles(Meshes mesh) {
        double[] points = mesh.points();
        float[] vertices = new float[points.length];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = (float) points[i];
        }
        return new Triangles(vertices, mesh.indices());
    }
}
