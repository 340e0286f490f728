// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;

/**
 * Cells of a grid of vertical walls, between lines along x and z. Its triangles are the sides and the top of the walls;
 * sides in one plane, and rectangles of the top, are merged. Immutable after filling.
 */
public final class WallGrid {
    /** Most rectangles of a grid's surface. */
    public static final int MOST = 250_000;

    private final double[] x;
    private final double[] z;
    private final BitSet walls;

    /**
     * @param x ascending positions of the lines that bound cells along x, metres; likewise z
     */
    public WallGrid(double[] x, double[] z) {
        this.x = x;
        this.z = z;
        walls = new BitSet((x.length - 1) * (z.length - 1));
    }

    /**
     * Makes a cell a wall.
     *
     * @param i its number along x, likewise k along z
     */
    public void fill(int i, int k) {
        walls.set(i * (z.length - 1) + k);
    }

    /** Returns whether a cell is a wall; those outside are not. */
    public boolean isWall(int i, int k) {
        return i >= 0 && k >= 0 && i < x.length - 1 && k < z.length - 1 && walls.get(i * (z.length - 1) + k);
    }

    /** Returns whether a point is inside of a wall. */
    public boolean contains(double atX, double atZ) {
        return isWall(cell(x, atX), cell(z, atZ));
    }

    private static int cell(double[] lines, double at) {
        int found = Arrays.binarySearch(lines, at);
        return found >= 0 ? found : -found - 2;
    }

    public boolean isEmpty() {
        return walls.isEmpty();
    }

    /** Returns the extent {x, z} of all cells, metres. */
    public double[] size() {
        return new double[] {x[x.length - 1] - x[0], z[z.length - 1] - z[0]};
    }

    /** Returns the area of the walls, m^2. */
    public double area() {
        double area = 0;
        for (int at = walls.nextSetBit(0); at >= 0; at = walls.nextSetBit(at + 1)) {
            int i = at / (z.length - 1);
            int k = at % (z.length - 1);
            area += (x[i + 1] - x[i]) * (z[k + 1] - z[k]);
        }
        return area;
    }

    /** Returns the thinnest cell, metres. */
    public double thickness() {
        double least = Double.POSITIVE_INFINITY;
        for (double[] lines : new double[][] {x, z}) {
            for (int i = 1; i < lines.length; i++) {
                least = Math.min(least, lines[i] - lines[i - 1]);
            }
        }
        return least;
    }

    /**
     * Returns the surface from y = -half to half, without the bottom.
     *
     * @return null if it has more than {@link #MOST} rectangles
     */
    public Triangles surface(double half) {
        WallQuads quads = new WallQuads();
        for (int i = 0; i <= x.length - 1 && quads.size() <= MOST; i++) {
            sidesAlongZ(i, half, quads);
        }
        for (int k = 0; k <= z.length - 1 && quads.size() <= MOST; k++) {
            sidesAlongX(k, half, quads);
        }
        double[][] tops = quads.size() > MOST ? null : rectangles(MOST - quads.size());
        if (tops == null) {
            return null;
        }
        for (double[] top : tops) {
            quads.top(new double[][] {{top[0], top[2]}, {top[0], top[3]}, {top[1], top[3]}, {top[1], top[2]}}, half);
        }
        return quads.triangles();
    }

    /** Adds the sides in the plane of line i along x. */
    private void sidesAlongZ(int i, double half, WallQuads quads) {
        int start = 0;
        int before = 0;
        for (int k = 0; k < z.length; k++) {
            int now = k == z.length - 1 ? 0 : side(isWall(i - 1, k), isWall(i, k));
            if (now != before) {
                if (before != 0) {
                    double from = before > 0 ? z[k] : z[start];
                    double to = before > 0 ? z[start] : z[k];
                    quads.side(x[i], from, x[i], to, half);
                }
                start = k;
                before = now;
            }
        }
    }

    private void sidesAlongX(int k, double half, WallQuads quads) {
        int start = 0;
        int before = 0;
        for (int i = 0; i < x.length; i++) {
            int now = i == x.length - 1 ? 0 : side(isWall(i, k - 1), isWall(i, k));
            if (now != before) {
                if (before != 0) {
                    double from = before > 0 ? x[start] : x[i];
                    double to = before > 0 ? x[i] : x[start];
                    quads.side(from, z[k], to, z[k], half);
                }
                start = i;
                before = now;
            }
        }
    }

    /** Returns 1 if the side looks in the positive direction, -1 in the negative, 0 if there is none. */
    private static int side(boolean below, boolean above) {
        return below == above ? 0 : below ? 1 : -1;
    }

    /**
     * Returns rectangles that cover the walls from above: {low x, high x, low z, high z}, metres. If there are too many
     * they are those of a coarser grid, which covers more.
     *
     * @param most number of rectangles, at least 1
     */
    public double[][] tops(int most) {
        WallGrid grid = this;
        double[][] tops = rectangles(most);
        while (tops == null) {
            grid = grid.coarser();
            tops = grid.rectangles(most);
        }
        return tops;
    }

    /** Returns the grid of every other line; its walls are cells that contain a wall. */
    private WallGrid coarser() {
        WallGrid coarse = new WallGrid(everyOther(x), everyOther(z));
        int columns = z.length - 1;
        for (int at = walls.nextSetBit(0); at >= 0; at = walls.nextSetBit(at + 1)) {
            coarse.fill(at / columns / 2, at % columns / 2);
        }
        return coarse;
    }

    private static double[] everyOther(double[] lines) {
        double[] other = new double[lines.length / 2 + 1];
        for (int i = 0; i < other.length; i++) {
            other[i] = lines[Math.min(2 * i, lines.length - 1)];
        }
        return other;
    }

    /** Returns disjoint rectangles that make up the walls; null if there are more than {@code most}. */
    private double[][] rectangles(int most) {
        List<double[]> found = new ArrayList<>();
        BitSet left = (BitSet) walls.clone();
        int columns = z.length - 1;
        for (int at = left.nextSetBit(0); at >= 0 && found.size() <= most; at = left.nextSetBit(at)) {
            int i = at / columns;
            int k = at % columns;
            int end = Math.min(left.nextClearBit(at), (i + 1) * columns) - i * columns;
            int last = i + 1;
            while (last < x.length - 1 && left.nextClearBit(last * columns + k) >= last * columns + end) {
                last++;
            }
            for (int row = i; row < last; row++) {
                left.clear(row * columns + k, row * columns + end);
            }
            found.add(new double[] {x[i], x[last], z[k], z[end]});
        }
        return found.size() > most ? null : found.toArray(new double[0][]);
    }
}
