// SPDX-License-Identifier: Apache-2.0
package org.SEAR.view.terrain;

import com.jme3.bounding.BoundingBox;
import com.jme3.math.Vector3f;
import com.jme3.renderer.queue.RenderQueue.ShadowMode;
import com.jme3.scene.Geometry;
import com.jme3.scene.Mesh;
import com.jme3.scene.VertexBuffer;
import com.jme3.util.BufferUtils;
import java.nio.FloatBuffer;

/**
 * Drawable square of ground: 17 x 17 posts, 3.5 kB. Corners are in the world's frame, so neighbours share them exactly.
 * Reused for other ground.
 */
final class Tile {
    private static final int SIDE = TilePyramid.CELLS + 1;

    final Geometry geometry;
    int level;
    int row;
    int column;
    /** Number of the frame that last showed the tile. */
    long used;
    private final FloatBuffer places = BufferUtils.createFloatBuffer(3 * SIDE * SIDE);
    private final Mesh mesh = new Mesh();
    private int kind = -1;

    Tile() {
        VertexBuffer buffer = new VertexBuffer(VertexBuffer.Type.Position);
        buffer.setupData(VertexBuffer.Usage.Dynamic, 3, VertexBuffer.Format.Float, places);
        mesh.setBuffer(buffer);
        geometry = new Geometry("ground", mesh);
        geometry.setShadowMode(ShadowMode.Off);
    }

    void fill(TilePyramid pyramid, int newLevel, int newRow, int newColumn) {
        level = newLevel;
        row = newRow;
        column = newColumn;
        places.clear();
        for (int i = 0; i < SIDE; i++) {
            int r = pyramid.postRow(level, row, i);
            for (int j = 0; j < SIDE; j++) {
                int c = pyramid.postColumn(level, column, j);
                places.put(pyramid.field.x(r)).put(pyramid.y(level, r, c)).put(pyramid.field.z(c));
            }
        }
        places.flip();
        Vector3f low = new Vector3f(places.get(0), pyramid.low(level, row, column), places.get(2));
        Vector3f high = new Vector3f(places.get(places.limit() - 3), pyramid.high(level, row, column),
            places.get(places.limit() - 1));
        mesh.getBuffer(VertexBuffer.Type.Position).updateData(places);
        mesh.setBound(new BoundingBox(low, high));
        geometry.updateModelBound();
    }

    /** @param newKind number of an index list in {@link TileIndices} */
    void stitch(TileIndices indices, int newKind) {
        if (kind != newKind) {
            kind = newKind;
            mesh.clearBuffer(VertexBuffer.Type.Index);
            mesh.setBuffer(indices.get(newKind));
        }
    }

    /** Returns the corners in the world, {x, y, z} each. */
    FloatBuffer places() {
        return places;
    }
}
