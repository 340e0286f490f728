// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;
import org.SEAR.geometry.HeightField;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightTiles;
import org.SEAR.geometry.Rotation;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.solid.RaySolid;
import org.SEAR.raycast.solid.TileTree;

/**
 * Shapes of a scene in flat arrays. {@link #data} holds {@link #STRIDE} numbers per shape: rotation matrix (world = R *
 * own, row by row), position and sizes. Sizes are the half sizes of a box or of the box around another convex solid,
 * the scale of a mesh, or 1 for elevation.
 */
final class Shapes {
    /** Owner of shapes that belong to no robot. */
    static final int WORLD = -1;
    /** Numbers per pose, see {@link BeamScene#POSE}. */
    static final int POSE = 7;
    static final byte BOX = 0;
    static final byte CONVEX = 1;
    static final byte MESH = 2;
    static final byte HEIGHTS = 3;
    /** Tiled elevation. */
    static final byte TILES = 4;
    static final int STRIDE = 16;
    static final int POSITION = 9;
    static final int SIZE = 12;
    private static final double ROUNDING = 1e-6;

    int count;
    byte[] kind = new byte[16];
    int[] owner = new int[16];
    boolean[] visible = new boolean[16];
    Mesh[] mesh = new Mesh[16];
    RaySolid[] solid = new RaySolid[16];
    HeightField[] heights = new HeightField[16];
    HeightTiles[] tiles = new HeightTiles[16];
    TileTree[] tileTrees = new TileTree[16];
    double[] data = new double[16 * STRIDE];

    int add(byte kindOfShape, int ownerOfShape, double a, double b, double c) {
        if (count == kind.length) {
            int size = 2 * count;
            kind = Arrays.copyOf(kind, size);
            owner = Arrays.copyOf(owner, size);
            visible = Arrays.copyOf(visible, size);
            mesh = Arrays.copyOf(mesh, size);
            solid = Arrays.copyOf(solid, size);
            heights = Arrays.copyOf(heights, size);
            tiles = Arrays.copyOf(tiles, size);
            tileTrees = Arrays.copyOf(tileTrees, size);
            data = Arrays.copyOf(data, size * STRIDE);
        }
        int shape = count++;
        kind[shape] = kindOfShape;
        owner[shape] = ownerOfShape;
        data[shape * STRIDE + SIZE] = a;
        data[shape * STRIDE + SIZE + 1] = b;
        data[shape * STRIDE + SIZE + 2] = c;
        return shape;
    }

    /** Adds a shape of another scene, without its pose. */
    void addAs(Shapes other, int shape) {
        int i = shape * STRIDE + SIZE;
        int added = add(other.kind[shape], other.owner[shape], other.data[i], other.data[i + 1], other.data[i + 2]);
        mesh[added] = other.mesh[shape];
        solid[added] = other.solid[shape];
        heights[added] = other.heights[shape];
        tiles[added] = other.tiles[shape];
        tileTrees[added] = other.tileTrees[shape];
    }

    /** Becomes a view of another scene's shapes, with a copy of their visibility. */
    void share(Shapes other) {
        count = other.count;
        kind = other.kind;
        owner = other.owner;
        mesh = other.mesh;
        solid = other.solid;
        heights = other.heights;
        tiles = other.tiles;
        tileTrees = other.tileTrees;
        data = other.data;
        if (visible.length != other.visible.length) {
            visible = new boolean[other.visible.length];
        }
        System.arraycopy(other.visible, 0, visible, 0, count);
    }

    /** Returns the radius of a sphere about a shape's origin that contains the shape, metres. */
    double radius(int shape) {
        double sum = 0;
        for (int k = 0; k < 3; k++) {
            double size = Math.abs(data[shape * STRIDE + SIZE + k]);
            boolean symmetric = kind[shape] == BOX || kind[shape] == CONVEX;
            double reach = symmetric ? size : size * Math.max(Math.abs(side(shape, k)), Math.abs(side(shape, k + 3)));
            sum += reach * reach;
        }
        return Math.sqrt(sum) * (1 + ROUNDING);
    }

    boolean isSeen(int shape, int ignoredOwner) {
        return visible[shape] && (owner[shape] == WORLD || owner[shape] != ignoredOwner);
    }

    void place(int shape, double[] pose, int at) {
        int i = shape * STRIDE;
        Rotation.write(pose[at + 3], pose[at + 4], pose[at + 5], pose[at + 6], data, i);
        System.arraycopy(pose, at, data, i + POSITION, 3);
    }

    /** Writes the axis-aligned world bounds of a shape, rounded outward. */
    void bounds(int shape, float[] out, int at) {
        int i = shape * STRIDE;
        int size = i + SIZE;
        for (int k = 0; k < 3; k++) {
            double centre = data[i + POSITION + k];
            int row = i + 3 * k;
            double half;
            if (kind[shape] == BOX) {
                half = Math.abs(data[row]) * data[size] + Math.abs(data[row + 1]) * data[size + 1]
                    + Math.abs(data[row + 2]) * data[size + 2];
            } else if (kind[shape] == CONVEX) {
                half = solid[shape].reach(data[row], data[row + 1], data[row + 2]);
            } else {
                half = 0;
                for (int j = 0; j < 3; j++) {
                    double low = side(shape, j) * data[size + j];
                    double high = side(shape, j + 3) * data[size + j];
                    centre += data[row + j] * (low + high) / 2;
                    half += Math.abs(data[row + j] * (high - low)) / 2;
                }
            }
            double slack = 1e-12 * (Math.abs(centre) + half);
            out[at + k] = Math.nextDown((float) (centre - half - slack));
            out[at + k + 3] = Math.nextUp((float) (centre + half + slack));
        }
    }

    /** Returns a bound of triangles in their own frame before scaling: minimum x, y, z, then maximum x, y, z. */
    private float side(int shape, int number) {
        if (kind[shape] == MESH) {
            float[] root = mesh[shape].tree.data;
            return root.length == 0 ? 0 : root[number];
        }
        HeightGrid field = kind[shape] == TILES ? tiles[shape] : heights[shape];
        switch (number) {
            case 0:
                return field.x(0);
            case 1:
                return field.lowest();
            case 2:
                return field.z(0);
            case 3:
                return field.x(field.rows - 1);
            case 4:
                return field.highest();
            default:
                return field.z(field.columns - 1);
        }
    }
}
