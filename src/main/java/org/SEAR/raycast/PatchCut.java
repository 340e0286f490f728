package org.SEAR.raycast;

import org.SEAR.raycast.solid.Patches;

/** The lines in which a fan's plane cuts the triangles of {@link Patches}. One thread. */
final class PatchCut {
    private final DepthBuffer depth;
    private final TriangleCut triangles;
    private final PlaneCut plane;
    /** Of the corners: height above the plane, and where in the fan's frame. */
    private final double[] above = new double[Patches.MOST];
    private final double[] lefts = new double[Patches.MOST];
    private final double[] aheads = new double[Patches.MOST];

    PatchCut(DepthBuffer depth, TriangleCut triangles) {
        this.depth = depth;
        this.triangles = triangles;
        plane = triangles.plane;
    }

    /**
     * Looks at the triangles of a patch.
     *
     * @param first the first beam that may see them, likewise last: they see the patch ahead of them, less than half a turn apart
     * @return how many of them the plane cuts
     */
    int meet(Patches patches, int patch, int count, int first, int last) {
        int[] links = patches.links;
        long under = corners(patches.corners, links[patch + Patches.CORNER], links[patch + Patches.COUNT]);
        int begin = patch + Patches.LINKS;
        int cut = 0;
        for (int i = begin; i < begin + count; i++) {
            int a = links[i] & 255;
            int b = links[i] >> 8 & 255;
            int c = links[i] >> 16;
            int ab = (int) (under >> a ^ under >> b) & 1;
            int bc = (int) (under >> b ^ under >> c) & 1;
            if ((ab | bc) != 0) {
                cut++;
                int lone = ab == 0 ? c : bc == 0 ? a : b;
                line(lone, ab == 0 ? a : bc == 0 ? b : c, a + b + c, (under >> lone & 1) != 0, first, last);
            }
        }
        return cut;
    }

    /** Sets out the corners. Answers which of them lie under the plane. */
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

    /** The line across a triangle one corner of which lies on a side of the plane of its own. */
    private void line(int lone, int next, int sum, boolean lower, int first, int last) {
        int other = sum - lone - next;
        int pUp = lower ? next : lone;
        int pDown = lower ? lone : next;
        int qUp = lower ? other : lone;
        int qDown = lower ? lone : other;
        double f = above[pUp] / (above[pUp] - above[pDown]);
        double px = lefts[pUp] + (lefts[pDown] - lefts[pUp]) * f;
        double pz = aheads[pUp] + (aheads[pDown] - aheads[pUp]) * f;
        double g = above[qUp] / (above[qUp] - above[qDown]);
        double qx = lefts[qUp] + (lefts[qDown] - lefts[qUp]) * g;
        double qz = aheads[qUp] + (aheads[qDown] - aheads[qUp]) * g;
        triangles.line(px, pz, qx, qz, first, last);
    }
}
