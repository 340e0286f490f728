// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast;

import org.SEAR.raycast.solid.Patches;

/**
 * Lines in which a fan's plane cuts the triangles of {@link Patches}. Counts cut triangles and visible lines instead of
 * branching: a mispredicted branch costs as much as half a line. One thread.
 */
final class PatchCut {
    /**
     * By the sides of the corners: bit offsets in a triangle's link of the upper and the lower corner of its crossed
     * edges, the descending edge first.
     */
    private static final int[] WAYS = {0x00000000, 0x00080010, 0x08100800, 0x08100010, 0x10001008, 0x00081008,
        0x10000800, 0x00000000};
    /** Sides for which a triangle is cut, one bit each. */
    private static final int CUT = 0x7e;

    private final DepthBuffer depth;
    private final TriangleCut triangles;
    private final PlaneCut plane;
    /** Height of each corner above the plane, and its position in the fan's frame. */
    private final double[] above = new double[Patches.CORNERS];
    private final double[] lefts = new double[Patches.CORNERS];
    private final double[] aheads = new double[Patches.CORNERS];
    /** Links and {@link #WAYS} of the cut triangles. One extra entry takes a triangle that is not counted. */
    private final int[] cuts = new int[Patches.MOST + 1];
    private final int[] ways = new int[Patches.MOST + 1];
    /** Both ends of each line that some ray hits, and the first ray at or to the left of each end. */
    private final double[] px = new double[Patches.MOST + 1];
    private final double[] pz = new double[Patches.MOST + 1];
    private final int[] ps = new int[Patches.MOST + 1];
    private final double[] qx = new double[Patches.MOST + 1];
    private final double[] qz = new double[Patches.MOST + 1];
    private final int[] qs = new int[Patches.MOST + 1];

    PatchCut(DepthBuffer depth, TriangleCut triangles) {
        this.depth = depth;
        this.triangles = triangles;
        plane = triangles.plane;
    }

    /**
     * Intersects the triangles of a patch.
     * @param first first ray that may hit the patch, likewise last; the rays are less than half a turn apart and the
     *     patch lies ahead of them
     * @return number of triangles that the plane cuts
     */
    int intersect(Patches patches, int patch, int count, int first, int last) {
        int[] links = patches.links;
        long under = corners(patches.corners, links[patch + Patches.CORNER], links[patch + Patches.COUNT]);
        int begin = patch + Patches.LINKS;
        int cut = 0;
        for (int i = begin; i < begin + count; i++) {
            int link = links[i];
            int sides = (int) (under >> link & 1 | (under >> (link >> 8) & 1) << 1 | (under >> (link >> 16) & 1) << 2);
            cuts[cut] = link;
            ways[cut] = WAYS[sides];
            cut += CUT >> sides & 1;
        }
        int lines = 0;
        for (int i = 0; i < cut; i++) {
            ends(cuts[i], ways[i], lines, first, last);
            lines += ps[lines] != qs[lines] ? 1 : 0;
        }
        for (int i = 0; i < lines; i++) {
            line(i);
        }
        return cut;
    }

    /** Computes the corners and returns a bit for each corner below the plane. */
    private long corners(float[] v, int from, int count) {
        long under = 0;
        for (int i = 0; i < count; i++) {
            double x = v[from + 3 * i];
            double y = v[from + 3 * i + 1];
            double z = v[from + 3 * i + 2];
            double height = plane.height(x, y, z);
            above[i] = height;
            lefts[i] = plane.x(x, y, z);
            aheads[i] = plane.z(x, y, z);
            under |= (long) FanDirections.negative(height + 0.0) << i;
        }
        return under;
    }

    /** Computes where the plane crosses two edges of a triangle, and the first ray of each crossing. */
    private void ends(int link, int way, int line, int first, int last) {
        int up = link >> way & 63;
        int down = link >> (way >> 8) & 63;
        double share = above[up] / (above[up] - above[down]);
        double x = lefts[up] + (lefts[down] - lefts[up]) * share;
        double z = aheads[up] + (aheads[down] - aheads[up]) * share;
        px[line] = x;
        pz[line] = z;
        ps[line] = depth.beams.first(x, z, first, last);
        up = link >> (way >> 16) & 63;
        down = link >> (way >> 24) & 63;
        share = above[up] / (above[up] - above[down]);
        x = lefts[up] + (lefts[down] - lefts[up]) * share;
        z = aheads[up] + (aheads[down] - aheads[up]) * share;
        qx[line] = x;
        qz[line] = z;
        qs[line] = depth.beams.first(x, z, first, last);
    }

    private void line(int i) {
        double turn = pz[i] * qx[i] - px[i] * qz[i];
        double a = (pz[i] - qz[i]) / turn;
        double b = (qx[i] - px[i]) / turn;
        if (turn > 0) {
            depth.fill(ps[i], qs[i], a, b, triangles.shape());
        } else if (turn < 0) {
            depth.fill(qs[i], ps[i], a, b, triangles.shape());
        }
    }
}
