// SPDX-License-Identifier: Apache-2.0
package org.SEAR.raycast.tree;

/**
 * Traverses a {@link Bvh} along one ray, nearer leaves first, with the slab test of Kay and Kajiya, "Ray tracing
 * complex scenes", 1986. A ray hits a box where its intervals between the three pairs of planes overlap. Single
 * precision is rounded so that no touched node is missed (Ize, "Robust BVH ray traversal", 2013). Extra visits cost
 * time, not correctness. Float bits are compared as integers, which is valid as negative numbers need no order among
 * themselves. This avoids the branches of {@code Math.max} for NaN and -0. One thread.
 */
public final class RayTraversal {
    /** Replaces 1 / 0, so that 0 * LARGEST is 0. */
    private static final double LARGEST = 1e30;
    /** Relative error bound of rounding a double to a float. */
    private static final double FLOAT = 1.2e-7;
    /**
     * Absolute error bound near 0, where floats have fewer digits. Times {@link #LARGEST} it exceeds any ray's range.
     */
    private static final double LEAST = 1e-12;
    /** Factor that moves out a node's far side and the limit, above all rounding errors of the test together. */
    private static final double SLACK = 1 + 1e-6;

    /** Number of nodes visited since construction. */
    public long nodes;

    private final int[] stack = new int[Bvh.MAX_DEPTH];
    private final int[] stackNear = new int[Bvh.MAX_DEPTH];
    private int depth;
    private float[] data;
    /** Offsets within a node of the sides that the ray enters. */
    private int sideX;
    private int sideY;
    private int sideZ;
    /** Origin and 1 / direction, rounded conservatively for near and far sides. */
    private float nearX;
    private float nearY;
    private float nearZ;
    private float farX;
    private float farY;
    private float farZ;
    private float nearIx;
    private float nearIy;
    private float nearIz;
    private float farIx;
    private float farIy;
    private float farIz;

    /** Begins a ray. The direction may have any length but 0; distances are in lengths of the direction. */
    public void start(Bvh tree, double ox, double oy, double oz, double dx, double dy, double dz) {
        data = tree.data;
        depth = 0;
        if (data.length > 0) {
            stack[0] = 0;
            stackNear[0] = 0;
            depth = 1;
        }
        double ix = inverse(dx);
        double iy = inverse(dy);
        double iz = inverse(dz);
        sideX = ix >= 0 ? 0 : 3;
        sideY = iy >= 0 ? 1 : 4;
        sideZ = iz >= 0 ? 2 : 5;
        nearIx = (float) ix;
        nearIy = (float) iy;
        nearIz = (float) iz;
        farIx = (float) (ix * SLACK);
        farIy = (float) (iy * SLACK);
        farIz = (float) (iz * SLACK);
        double gap = Math.copySign(Math.abs(ox) * FLOAT + LEAST, ix);
        nearX = (float) (ox + gap);
        farX = (float) (ox - gap);
        gap = Math.copySign(Math.abs(oy) * FLOAT + LEAST, iy);
        nearY = (float) (oy + gap);
        farY = (float) (oy - gap);
        gap = Math.copySign(Math.abs(oz) * FLOAT + LEAST, iz);
        nearZ = (float) (oz + gap);
        farZ = (float) (oz - gap);
    }

    private static double inverse(double d) {
        return Math.abs(d) < 1 / LARGEST ? Math.copySign(LARGEST, d) : 1 / d;
    }

    /**
     * Returns the next leaf that the ray may hit within limit, or -1. Visits the child first whose interval has the
     * nearer midpoint, as overlapping boxes often share the entry point.
     */
    public int next(double limit) {
        float[] box = data;
        int x = sideX;
        int y = sideY;
        int z = sideZ;
        int reach = bits((float) (limit * SLACK));
        while (depth > 0) {
            depth--;
            int node = stackNear[depth] <= reach ? stack[depth] : -1;
            while (node >= 0) {
                nodes++;
                if (bits(box[node * Bvh.STRIDE + Bvh.COUNT]) > 0) {
                    return node;
                }
                int left = bits(box[node * Bvh.STRIDE + Bvh.LINK]);
                int at = left * Bvh.STRIDE;
                int inLeft = Math.max(Math.max(bits((box[at + x] - nearX) * nearIx),
                    bits((box[at + y] - nearY) * nearIy)), Math.max(bits((box[at + z] - nearZ) * nearIz), 0));
                int outLeft = Math.min(Math.min(bits((box[at + 3 - x] - farX) * farIx),
                    bits((box[at + 5 - y] - farY) * farIy)), Math.min(bits((box[at + 7 - z] - farZ) * farIz), reach));
                at += Bvh.STRIDE;
                int inRight = Math.max(Math.max(bits((box[at + x] - nearX) * nearIx),
                    bits((box[at + y] - nearY) * nearIy)), Math.max(bits((box[at + z] - nearZ) * nearIz), 0));
                int outRight = Math.min(Math.min(bits((box[at + 3 - x] - farX) * farIx),
                    bits((box[at + 5 - y] - farY) * farIy)), Math.min(bits((box[at + 7 - z] - farZ) * farIz), reach));
                if (inLeft <= outLeft) {
                    if (inRight <= outRight) {
                        int leftLast = value(inLeft) + value(outLeft) > value(inRight) + value(outRight) ? 1 : 0;
                        stack[depth] = left + 1 - leftLast;
                        stackNear[depth++] = leftLast == 1 ? inLeft : inRight;
                        node = left + leftLast;
                    } else {
                        node = left;
                    }
                } else {
                    node = inRight <= outRight ? left + 1 : -1;
                }
            }
        }
        return -1;
    }

    private static int bits(float value) {
        return Float.floatToRawIntBits(value);
    }

    private static float value(int bits) {
        return Float.intBitsToFloat(bits);
    }
}
