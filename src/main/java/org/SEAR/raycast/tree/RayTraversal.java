package org.SEAR.raycast.tree;

/**
 * Leads one ray through a {@link Bvh}, leaf by leaf, nearer ones first: a ray meets a box where its stretches between the three pairs of parallel
 * planes overlap (the slab test of Kay and Kajiya, "Ray tracing complex scenes", 1986). It computes in single precision, rounded so that no node is
 * left out that the ray touches (Ize, "Robust BVH ray traversal", 2013); that some are visited in vain costs time, not correctness. The bits of
 * floats are compared as integers: that is right as long as negative numbers need no order among themselves, and spares the branches that {@code
 * Math.max} takes because of NaN and -0. One thread.
 */
public final class RayTraversal {
    /** Stands for 1 / 0, so that 0 * LARGEST is 0. */
    private static final double LARGEST = 1e30;
    /** Relative; more than the rounding of a double to a float ... */
    private static final double FLOAT = 1.2e-7;
    /** ... and for numbers whose floats have fewer digits: times {@link #LARGEST} it is farther than any beam goes. */
    private static final double LEAST = 1e-12;
    /** By how much the far side of a node and the limit are moved out: more than all roundings of the test together. */
    private static final double SLACK = 1 + 1e-6;

    /** Nodes looked at since the beginning. */
    public long nodes;

    private final int[] stack = new int[Bvh.MAX_DEPTH];
    private final int[] stackNear = new int[Bvh.MAX_DEPTH];
    private int depth;
    private float[] data;
    /** Where a node holds the sides that the ray meets first. */
    private int sideX;
    private int sideY;
    private int sideZ;
    /** The origin and 1 / direction as the near sides have to see them, and as the far sides have to. */
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

    /** Begins a ray; the direction may have any length but 0, and distances are in units of it. */
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
     * The next leaf that the ray may meet up to a distance, -1 when there is none left. Of two children the one whose middle part of the ray comes
     * first goes first: where boxes overlap, they often begin at the same place.
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
                int inLeft = Math.max(Math.max(bits((box[at + x] - nearX) * nearIx), bits((box[at + y] - nearY) * nearIy)),
                    Math.max(bits((box[at + z] - nearZ) * nearIz), 0));
                int outLeft = Math.min(Math.min(bits((box[at + 3 - x] - farX) * farIx), bits((box[at + 5 - y] - farY) * farIy)),
                    Math.min(bits((box[at + 7 - z] - farZ) * farIz), reach));
                at += Bvh.STRIDE;
                int inRight = Math.max(Math.max(bits((box[at + x] - nearX) * nearIx), bits((box[at + y] - nearY) * nearIy)),
                    Math.max(bits((box[at + z] - nearZ) * nearIz), 0));
                int outRight = Math.min(Math.min(bits((box[at + 3 - x] - farX) * farIx), bits((box[at + 5 - y] - farY) * farIy)),
                    Math.min(bits((box[at + 7 - z] - farZ) * farIz), reach));
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
