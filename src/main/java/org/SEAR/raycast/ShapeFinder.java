// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import java.util.Arrays;
import java.util.function.Predicate;
import org.SEAR.geometry.Aabb;
import org.SEAR.geometry.HeightGrid;
import org.SEAR.geometry.HeightSearch;
import org.SEAR.raycast.solid.Mesh;
import org.SEAR.raycast.tree.BoxTraversal;
import org.SEAR.raycast.tree.Bvh;

/** Finds the shapes of a scene, and the triangles of a shape, in a box. Allocates only at growth. One thread. */
public final class ShapeFinder {
    /** Takes triangles. */
    public interface Triangles {
        /** @param corners x, y and z of three corners, world frame, metres; valid only during the call */
        void triangle(double[] corners);
    }

    private final Shapes shapes;
    private final BeamScene scene;
    private final BoxTraversal nodes = new BoxTraversal();
    private final BoxTraversal leaves = new BoxTraversal();
    private final Aabb inside = new Aabb();
    private final double[] corners = new double[9];
    private int[] found = new int[16];
    private int count;
    private HeightSearch[] searches = new HeightSearch[0];
    private Triangles visitor;
    private int frame;
    private final Predicate<float[]> heights = at -> {
        visit(at, 0, 1, 1, 1);
        return false;
    };

    public ShapeFinder(BeamScene scene) {
        this.scene = scene;
        shapes = scene.shapes();
    }

    /**
     * Finds the shapes whose bounds overlap a box.
     * @param box world frame
     * @return their number; {@link #get} returns them in ascending order
     */
    public int find(Aabb box, int ignoredOwner) {
        count = 0;
        Bvh tree = scene.tree();
        nodes.start(tree, box);
        for (int node = nodes.next(); node >= 0; node = nodes.next()) {
            int end = tree.link(node) + tree.count(node);
            for (int i = tree.link(node); i < end; i++) {
                add(tree.items[i], ignoredOwner);
            }
        }
        if (count > 1) {
            Arrays.sort(found, 0, count);
        }
        return count;
    }

    private void add(int shape, int ignoredOwner) {
        if (shapes.isSeen(shape, ignoredOwner)) {
            if (count == found.length) {
                found = Arrays.copyOf(found, 2 * count);
            }
            found[count++] = shape;
        }
    }

    /** Returns the number of nodes visited so far. */
    public long getNodes() {
        return nodes.getNodes() + leaves.getNodes();
    }

    /** Returns the number of a found shape. */
    public int get(int index) {
        return found[index];
    }

    /** Whether a shape consists of triangles: a mesh or elevation. */
    public boolean isMesh(int shape) {
        return shapes.kind[shape] != Shapes.BOX && shapes.kind[shape] != Shapes.CONVEX;
    }

    /**
     * Visits the triangles of a mesh or of elevation that may reach into a box.
     * @param box world frame
     */
    public void triangles(int shape, Aabb box, Triangles newVisitor) {
        visitor = newVisitor;
        frame = shape * Shapes.STRIDE;
        double[] data = shapes.data;
        for (int axis = 0; axis < 3; axis++) {
            double middle = 0;
            double half = 0;
            for (int k = 0; k < 3; k++) {
                double turned = data[frame + 3 * k + axis];
                middle += turned * ((box.min(k) + box.max(k)) / 2 - data[frame + Shapes.POSITION + k]);
                half += Math.abs(turned) * (box.max(k) - box.min(k)) / 2;
            }
            double scale = data[frame + Shapes.SIZE + axis];
            inside.set(axis, (middle - half) / scale, (middle + half) / scale);
        }
        if (shapes.kind[shape] == Shapes.MESH) {
            mesh(shapes.mesh[shape]);
        } else {
            search(shape).any(inside.minX, inside.minY, inside.minZ, inside.maxX, inside.maxY, inside.maxZ, heights);
        }
    }

    private void mesh(Mesh mesh) {
        leaves.start(mesh.tree, inside);
        for (int node = leaves.next(); node >= 0; node = leaves.next()) {
            int end = mesh.tree.link(node) + mesh.tree.count(node);
            for (int i = mesh.tree.link(node); i < end; i++) {
                visit(mesh.corners, 9 * i, shapes.data[frame + Shapes.SIZE], shapes.data[frame + Shapes.SIZE + 1],
                    shapes.data[frame + Shapes.SIZE + 2]);
            }
        }
    }

    private HeightSearch search(int shape) {
        if (shape >= searches.length) {
            searches = Arrays.copyOf(searches, shapes.count);
        }
        if (searches[shape] == null) {
            HeightGrid grid = shapes.kind[shape] == Shapes.TILES ? shapes.tiles[shape] : shapes.heights[shape];
            searches[shape] = new HeightSearch(grid);
        }
        return searches[shape];
    }

    private void visit(float[] at, int first, double sx, double sy, double sz) {
        double[] m = shapes.data;
        for (int i = 0; i < 9; i += 3) {
            double x = at[first + i] * sx;
            double y = at[first + i + 1] * sy;
            double z = at[first + i + 2] * sz;
            for (int k = 0; k < 3; k++) {
                corners[i + k] = m[frame + 3 * k] * x + m[frame + 3 * k + 1] * y + m[frame + 3 * k + 2] * z
                    + m[frame + Shapes.POSITION + k];
            }
        }
        visitor.triangle(corners);
    }
}
