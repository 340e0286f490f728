// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import java.util.Arrays;

/** Drawn surface of a solid: triangles with normals and picture coordinates. Not thread-safe. */
public final class SurfaceMesh {
    private static final float HALF = 0.5f;

    private float[] positions = new float[96];
    private float[] normals = new float[96];
    private float[] pictures = new float[64];
    private int[] indices = new int[96];
    private int vertices;
    private int corners;

    /**
     * Adds a vertex.
     * @param x metres, likewise y and z
     * @param nx outward normal of any length but 0, likewise ny and nz
     * @param u picture coordinate, 0 at the left edge and 1 at the right
     * @param v 0 at the lower edge and 1 at the upper
     * @return its index
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

    /** Picture coordinates: two per vertex. */
    public float[] getPictures() {
        return Arrays.copyOf(pictures, 2 * vertices);
    }

    /** Vertex indices: three per triangle. */
    public int[] getIndices() {
        return Arrays.copyOf(indices, corners);
    }

    /**
     * Repeats a picture at its true size over the sides of a box.
     * @param size width and height of the picture, metres
     */
    public void tile(double size) {
        for (int i = 0; i < vertices; i++) {
            boolean level = Math.abs(normals[3 * i + 1]) > HALF;
            pictures[2 * i] = (float) (positions[Math.abs(normals[3 * i]) > HALF ? 3 * i + 2 : 3 * i] / size);
            pictures[2 * i + 1] = (float) (positions[level ? 3 * i + 2 : 3 * i + 1] / size);
        }
    }

    /** Adds a triangle mesh with flat shading. */
    public void addFlat(Triangles mesh, double[] scale) {
        double[] at = new double[9];
        for (int first = 0; first < mesh.indices.length; first += 3) {
            for (int i = 0; i < at.length; i++) {
                at[i] = mesh.vertices[3 * mesh.indices[first + i / 3] + i % 3] * scale[i % 3];
            }
            addFlat(at);
        }
    }

    private void addFlat(double[] at) {
        double ax = at[3] - at[0];
        double ay = at[4] - at[1];
        double az = at[5] - at[2];
        double bx = at[6] - at[0];
        double by = at[7] - at[1];
        double bz = at[8] - at[2];
        double nx = ay * bz - az * by;
        double ny = az * bx - ax * bz;
        double nz = ax * by - ay * bx;
        if (nx == 0 && ny == 0 && nz == 0) {
            return;
        }
        for (int i = 0; i < at.length; i += 3) {
            vertex(at[i], at[i + 1], at[i + 2], nx, ny, nz, 0, 0);
        }
        triangle(vertices - 3, vertices - 2, vertices - 1);
    }

    /** Returns the surface transformed by a pose. */
    public SurfaceMesh placed(Pose pose) {
        SurfaceMesh placed = new SurfaceMesh();
        for (int i = 0; i < vertices; i++) {
            double[] at = pose.transform(positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]);
            double[] normal = pose.rotate(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]);
            placed.vertex(at[0], at[1], at[2], normal[0], normal[1], normal[2], pictures[2 * i], pictures[2 * i + 1]);
        }
        for (int i = 0; i < corners; i += 3) {
            placed.triangle(indices[i], indices[i + 1], indices[i + 2]);
        }
        return placed;
    }
}
