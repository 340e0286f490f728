package org.SEAR.geometry;

import java.util.Arrays;

/** The surface of a solid as it is drawn: triangles with normals and the place of the picture that is wrapped around. Not for several threads. */
public final class SurfaceMesh {
    private float[] positions = new float[96];
    private float[] normals = new float[96];
    private float[] pictures = new float[64];
    private int[] indices = new int[96];
    private int vertices;
    private int corners;

    /**
     * Adds a vertex.
     *
     * @param x metres, likewise y and z
     * @param nx outward normal of any length but 0, likewise ny and nz
     * @param u place in the picture, 0 at its left edge and 1 at its right
     * @param v 0 at its lower edge and 1 at its upper
     * @return its number
     */
    public int vertex(double x, double y, double z, double nx, double ny, double nz, double u, double v) {
        int at = 3 * vertices;
        if (at == positions.length) {
            positions = Arrays.copyOf(positions, 2 * at);
            normals = Arrays.copyOf(normals, 2 * at);
            pictures = Arrays.copyOf(pictures, 4 * vertices);
        }
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        positions[at] = (float) x;
        positions[at + 1] = (float) y;
        positions[at + 2] = (float) z;
        normals[at] = (float) (nx / length);
        normals[at + 1] = (float) (ny / length);
        normals[at + 2] = (float) (nz / length);
        pictures[2 * vertices] = (float) u;
        pictures[2 * vertices + 1] = (float) v;
        return vertices++;
    }

    /** Adds a triangle of three vertices, counter-clockwise seen from outside. */
    public void triangle(int a, int b, int c) {
        if (corners + 3 > indices.length) {
            indices = Arrays.copyOf(indices, 2 * indices.length);
        }
        indices[corners++] = a;
        indices[corners++] = b;
        indices[corners++] = c;
    }

    /** x, y, z of each vertex, metres. */
    public float[] getPositions() {
        return Arrays.copyOf(positions, 3 * vertices);
    }

    /** x, y, z of each vertex' normal, of length 1. */
    public float[] getNormals() {
        return Arrays.copyOf(normals, 3 * vertices);
    }

    /** Two numbers a vertex. */
    public float[] getPictures() {
        return Arrays.copyOf(pictures, 2 * vertices);
    }

    /** Three vertices a triangle. */
    public int[] getIndices() {
        return Arrays.copyOf(indices, corners);
    }
}
