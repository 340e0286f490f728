// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project.models.format;

import java.util.Arrays;

/**
 * Triangles of one material, whose corners refer to lists of the file. Corners with equal position, texture
 * coordinates and normal share a vertex, found by a hash table with open addressing.
 */
final class MeshPart {
    /** Numbers of a vertex: position, texture coordinates, normal; each from 0, -1 for none. */
    private static final int NUMBERS = 3;

    /** The numbers of each vertex. */
    private int[] vertices = new int[NUMBERS * 16];
    private int vertexCount;
    private int[] indices = new int[48];
    private int indexCount;
    /** Vertex plus 1 of each place; 0 for a free one. The length is a power of two. */
    private int[] table = new int[64];

    /**
     * Adds a corner of a triangle.
     *
     * @return whether it needed a new vertex
     */
    boolean add(int position, int place, int normal) {
        int before = vertexCount;
        if (indexCount == indices.length) {
            indices = Arrays.copyOf(indices, 2 * indexCount);
        }
        indices[indexCount++] = vertex(position, place, normal);
        return vertexCount > before;
    }

    private int vertex(int position, int place, int normal) {
        int at = start(position, place, normal);
        for (; table[at] != 0; at = at + 1 & table.length - 1) {
            int known = NUMBERS * (table[at] - 1);
            if (vertices[known] == position && vertices[known + 1] == place && vertices[known + 2] == normal) {
                return table[at] - 1;
            }
        }
        if (NUMBERS * vertexCount == vertices.length) {
            vertices = Arrays.copyOf(vertices, 2 * vertices.length);
        }
        vertices[NUMBERS * vertexCount] = position;
        vertices[NUMBERS * vertexCount + 1] = place;
        vertices[NUMBERS * vertexCount + 2] = normal;
        table[at] = ++vertexCount;
        if (2 * vertexCount > table.length) {
            grow();
        }
        return vertexCount - 1;
    }

    /** Returns the first place to search: the upper bits of a mix of the numbers (finaliser of SplitMix64). */
    private int start(int position, int place, int normal) {
        long mixed = (position * 0x9e3779b97f4a7c15L + place) * 0x9e3779b97f4a7c15L + normal;
        mixed = (mixed ^ mixed >>> 30) * 0xbf58476d1ce4e5b9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94d049bb133111ebL;
        return (int) (mixed ^ mixed >>> 31) & table.length - 1;
    }

    private void grow() {
        table = new int[2 * table.length];
        for (int i = 0; i < vertexCount; i++) {
            int at = start(vertices[NUMBERS * i], vertices[NUMBERS * i + 1], vertices[NUMBERS * i + 2]);
            while (table[at] != 0) {
                at = at + 1 & table.length - 1;
            }
            table[at] = i + 1;
        }
    }

    /**
     * Returns the part as a mesh. It has texture coordinates if any corner has them, and normals if all corners have
     * them.
     */
    SolidMesh mesh(float[] positions, float[] places, float[] normals) {
        SolidMesh mesh = new SolidMesh(gathered(positions, 0, 3), Arrays.copyOf(indices, indexCount));
        mesh.places = lacking(1) < vertexCount ? gathered(places, 1, 2) : null;
        mesh.normals = lacking(2) == 0 ? gathered(normals, 2, 3) : null;
        return mesh;
    }

    private int lacking(int number) {
        int lacking = 0;
        for (int i = 0; i < vertexCount; i++) {
            lacking += vertices[NUMBERS * i + number] < 0 ? 1 : 0;
        }
        return lacking;
    }

    private float[] gathered(float[] values, int number, int size) {
        float[] all = new float[size * vertexCount];
        for (int i = 0; i < vertexCount; i++) {
            if (vertices[NUMBERS * i + number] >= 0) {
                System.arraycopy(values, size * vertices[NUMBERS * i + number], all, size * i, size);
            }
        }
        return all;
    }
}
