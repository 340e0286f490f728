package org.SEAR.geometry;

/**
 * The triangles of a model in its own frame. Owned by whoever loaded it; nobody changes the arrays afterwards.
 */
public final class Triangles {
    /** x, y, z of each vertex, metres. */
    public final float[] vertices;
    /** Three vertex numbers a triangle, counter-clockwise seen from outside. */
    public final int[] indices;

    public Triangles(float[] vertices, int[] indices) {
        this.vertices = vertices;
        this.indices = indices;
    }

    /** How many triangles there are. */
    public int size() {
        return indices.length / 3;
    }
}
