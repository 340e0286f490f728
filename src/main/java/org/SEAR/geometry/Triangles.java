// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/** Triangles of a model in its own frame. The arrays never change. */
public final class Triangles {
    /** x, y, z of each vertex, metres. */
    public final float[] vertices;
    /** Three vertex indices per triangle, counter-clockwise seen from outside. */
    public final int[] indices;

    public Triangles(float[] vertices, int[] indices) {
        this.vertices = vertices;
        this.indices = indices;
    }

    public int size() {
        return indices.length / 3;
    }
}
