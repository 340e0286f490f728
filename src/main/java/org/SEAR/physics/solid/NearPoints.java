// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.solid;

import java.util.Arrays;

/**
 * Finds points at nearly the same place, in a hash table of cells: corners of triangles that a program wrote separately
 * and rounded differently.
 */
final class NearPoints {
    /** Largest distance along each axis, relative to the largest coordinate: 4 roundings of single precision. */
    private static final double TOLERANCE = 5e-7;

    private final double[] points;
    private final double tolerance;
    private final double cell;
    /** Point plus 1 of each place; 0 for a free one. The length is a power of two. */
    private final int[] table;

    private NearPoints(double[] points) {
        this.points = points;
        double largest = Arrays.stream(points).map(Math::abs).max().orElse(0);
        tolerance = TOLERANCE * largest;
        cell = largest > 0 ? 2 * tolerance : 1;
        table = new int[Math.max(2, Integer.highestOneBit(points.length) << 1)];
    }

    /**
     * Returns for each point the first one at its place.
     *
     * @param points x, y and z of each point
     */
    static int[] first(double[] points) {
        NearPoints near = new NearPoints(points);
        int[] first = new int[points.length / 3];
        for (int i = 0; i < first.length; i++) {
            int known = near.find(i);
            first[i] = known < 0 ? i : known;
            if (known < 0) {
                near.add(i);
            }
        }
        return first;
    }

    private long low(int point, int axis) {
        return (long) Math.floor((points[3 * point + axis] - tolerance) / cell);
    }

    private long high(int point, int axis) {
        return (long) Math.floor((points[3 * point + axis] + tolerance) / cell);
    }

    private long own(int point, int axis) {
        return (long) Math.floor(points[3 * point + axis] / cell);
    }

    private int find(int point) {
        for (long x = low(point, 0); x <= high(point, 0); x++) {
            for (long y = low(point, 1); y <= high(point, 1); y++) {
                for (long z = low(point, 2); z <= high(point, 2); z++) {
                    for (int at = start(x, y, z); table[at] != 0; at = at + 1 & table.length - 1) {
                        if (isNear(point, table[at] - 1)) {
                            return table[at] - 1;
                        }
                    }
                }
            }
        }
        return -1;
    }

    private boolean isNear(int point, int other) {
        for (int axis = 0; axis < 3; axis++) {
            if (Math.abs(points[3 * point + axis] - points[3 * other + axis]) > tolerance) {
                return false;
            }
        }
        return true;
    }

    private void add(int point) {
        int at = start(own(point, 0), own(point, 1), own(point, 2));
        while (table[at] != 0) {
            at = at + 1 & table.length - 1;
        }
        table[at] = point + 1;
    }

    /** Returns the first place to search: the upper bits of a mix of the numbers (finaliser of SplitMix64). */
    private int start(long x, long y, long z) {
        long mixed = (x * 0x9e3779b97f4a7c15L + y) * 0x9e3779b97f4a7c15L + z;
        mixed = (mixed ^ mixed >>> 30) * 0xbf58476d1ce4e5b9L;
        mixed = (mixed ^ mixed >>> 27) * 0x94d049bb133111ebL;
        return (int) (mixed ^ mixed >>> 31) & table.length - 1;
    }
}
