// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.solid;

import java.util.Arrays;
import org.SEAR.raycast.tree.Bvh;

/**
 * Triangles grouped into patches of up to 40 neighbours, with a hierarchy over the patches. A fan needs all triangles
 * along the line where its plane cuts a model. The triangles of a patch share corners stored side by side, and the
 * hierarchy ends at the patches. A fan over 100 000 triangles therefore opens less than half as many nodes. A single
 * ray uses the {@link Mesh} instead. Immutable, any thread.
 */
public final class Patches {
    /** Maximum number of triangles of a patch in a large model. Small models have smaller patches. */
    public static final int MOST = 40;
    /** Maximum number of triangles of a patch in the smallest models. */
    private static final int FEW = 20;
    /** Minimum number of patches of a model, unless patches would become smaller than {@link #FEW}. */
    private static final int PATCHES = 200;
    /** Maximum number of corners of a patch: one bit of a long each. */
    public static final int CORNERS = 63;
    /**
     * Offsets within a patch's entry of {@link #links}: first float of its corners, number of corners, first triangle.
     */
    public static final int CORNER = 0;
    public static final int COUNT = 1;
    public static final int TRIANGLE = 2;
    /** Offset of the triangles within a patch's entry: three corner numbers of eight bits each. */
    public static final int LINKS = 3;

    /** Its leaves link to patch entries in {@link #links} and count the patch's triangles. */
    public final Bvh tree;
    /** x, y and z of each corner. */
    public final float[] corners;
    public final int[] links;

    /** Creates and grows the three arrays. */
    private static final class Maker {
        private final Bvh whole;
        private final float[] v;
        private float[] nodes;
        private float[] corners;
        private int[] links;
        /** Maximum number of triangles of a patch of this model. */
        private final int most;
        private int nodeCount = 2;
        private int cornerCount;
        private int linkCount;

        Maker(Bvh whole, float[] v) {
            this.whole = whole;
            this.v = v;
            int n = v.length / 9;
            most = Math.max(FEW, Math.min(MOST, n / PATCHES));
            nodes = new float[Math.max(2, n / 4) * Bvh.STRIDE];
            corners = new float[3 * n];
            links = new int[2 * n];
        }

        /** Copies a node and its subtree. */
        private void copy(int from, int to) {
            System.arraycopy(whole.data, from * Bvh.STRIDE, nodes, to * Bvh.STRIDE, Bvh.BOUNDS);
            int first = from;
            int last = from;
            while (whole.count(first) == 0) {
                first = whole.link(first);
            }
            while (whole.count(last) == 0) {
                last = whole.link(last) + 1;
            }
            int start = whole.link(first);
            int n = whole.link(last) + whole.count(last) - start;
            int at = linkCount;
            if (n <= most && patch(start, n)) {
                Bvh.describe(nodes, to, at, n);
                return;
            }
            int children = nodeCount;
            nodeCount += 2;
            if (nodeCount * Bvh.STRIDE > nodes.length) {
                nodes = Arrays.copyOf(nodes, 2 * nodes.length);
            }
            Bvh.describe(nodes, to, children, 0);
            copy(whole.link(from), children);
            copy(whole.link(from) + 1, children + 1);
        }

        /** Adds a patch. Returns false if its triangles have too many corners. */
        private boolean patch(int start, int n) {
            int first = cornerCount;
            int at = linkCount;
            if (at + LINKS + n > links.length) {
                links = Arrays.copyOf(links, links.length * 3 / 2 + LINKS + n);
            }
            if (first + 9 * n > corners.length) {
                corners = Arrays.copyOf(corners, corners.length * 3 / 2 + 9 * n);
            }
            linkCount += LINKS;
            for (int i = 9 * start; i < 9 * (start + n); i += 9) {
                links[linkCount++] = corner(first, i) | corner(first, i + 3) << 8 | corner(first, i + 6) << 16;
                if (cornerCount - first > 3 * CORNERS) {
                    cornerCount = first;
                    linkCount = at;
                    return false;
                }
            }
            links[at + CORNER] = first;
            links[at + COUNT] = (cornerCount - first) / 3;
            links[at + TRIANGLE] = start;
            return true;
        }

        private int corner(int first, int at) {
            int k = cornerCount - 3;
            while (k >= first && !(corners[k] == v[at] && corners[k + 1] == v[at + 1] && corners[k + 2] == v[at + 2])) {
                k -= 3;
            }
            if (k < first) {
                k = cornerCount;
                System.arraycopy(v, at, corners, k, 3);
                cornerCount += 3;
            }
            return (k - first) / 3;
        }
    }

    Patches(Bvh whole, float[] v) {
        Maker maker = new Maker(whole, v);
        if (v.length > 0) {
            maker.copy(0, 0);
        }
        tree = new Bvh(Arrays.copyOf(maker.nodes, v.length > 0 ? maker.nodeCount * Bvh.STRIDE : 0), new int[0]);
        corners = Arrays.copyOf(maker.corners, maker.cornerCount);
        links = Arrays.copyOf(maker.links, maker.linkCount);
    }
}
