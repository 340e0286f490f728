// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.scene;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;

import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.Node;
import com.jme3.scene.VertexBuffer.Type;
import com.jme3.scene.shape.Box;
import com.jme3.util.BufferUtils;
import org.junit.Test;

/** Light on models whose files contain no normals. */
public class FlatNormalsTest {
    @Test
    public void eachTriangleIsFlatAndKeepsItsPlacesInThePicture() {
        Mesh roof = new Mesh();
        roof.setBuffer(Type.Position, 3, new float[] {0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 1, 0});
        roof.setBuffer(Type.TexCoord, 2, new float[] {0, 0, 0.25f, 0, 0.5f, 0, 0.75f, 1});
        roof.setBuffer(Type.Index, 3, new int[] {0, 1, 2, 0, 3, 1});
        Geometry solid = new Geometry("roof", roof);
        Geometry lit = new Geometry("lit", new Box(1, 1, 1));
        Mesh own = lit.getMesh();
        Node model = new Node("model");
        model.attachChild(solid);
        model.attachChild(lit);
        FlatNormals.add(model);
        assertEquals(own, lit.getMesh());
        Mesh flat = solid.getMesh();
        assertEquals(2, flat.getTriangleCount());
        float[] normals = BufferUtils.getFloatArray(flat.getFloatBuffer(Type.Normal));
        assertArrayEquals(new float[] {0, 1, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0}, normals, 0);
        float[] places = BufferUtils.getFloatArray(flat.getFloatBuffer(Type.TexCoord));
        assertArrayEquals(new float[] {0, 0, 0.25f, 0, 0.5f, 0, 0, 0, 0.75f, 1, 0.25f, 0}, places, 0);
    }
}
