// SPDX-License-Identifier: Apache-2.0
package org.SEAR.geometry;

/**
 * Vertical walls along a line from corner to corner. Each piece extends half its thickness beyond its corners, so that
 * pieces at a right angle have a sharp corner. Immutable.
 */
public final class WallLine {
    private final double half;
    /** Corners {x, z} of each piece, counter-clockwise from above. */
    private final double[][][] pieces;

    /**
     * @param corners {x, z}, metres; neighbours differ
     * @param thickness metres
     */
    public WallLine(double[][] corners, double thickness) {
        half = thickness / 2;
        pieces = new double[corners.length - 1][][];
        for (int i = 0; i < pieces.length; i++) {
            pieces[i] = piece(corners[i], corners[i + 1]);
        }
    }

    private double[][] piece(double[] from, double[] to) {
        double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
        double x = half * (to[0] - from[0]) / length;
        double z = half * (to[1] - from[1]) / length;
        return new double[][] {{from[0] - x + z, from[1] - z - x}, {from[0] - x - z, from[1] - z + x},
            {to[0] + x - z, to[1] + z + x}, {to[0] + x + z, to[1] + z - x}};
    }

    /** Returns the corners {x, z} of each piece, metres. */
    public double[][][] areas() {
        return pieces.clone();
    }

    /** Returns the surface from y = -halfHeight to halfHeight, without the bottom. */
    public Triangles surface(double halfHeight) {
        WallQuads quads = new WallQuads();
        for (double[][] piece : pieces) {
            for (int i = 0; i < piece.length; i++) {
                double[] left = piece[(i + 1) % piece.length];
                quads.side(left[0], left[1], piece[i][0], piece[i][1], halfHeight);
            }
            quads.top(piece, halfHeight);
        }
        return quads.triangles();
    }

    /** Returns the area of the pieces, overlaps counted twice, m^2. */
    public double area() {
        double area = 0;
        for (double[][] piece : pieces) {
            area += 2 * half * Math.hypot(piece[2][0] - piece[1][0], piece[2][1] - piece[1][1]);
        }
        return area;
    }

    /** Returns whether a point is inside of a wall. */
    public boolean contains(double x, double z) {
        for (double[][] piece : pieces) {
            boolean inside = true;
            for (int i = 0; i < piece.length && inside; i++) {
                double[] a = piece[i];
                double[] b = piece[(i + 1) % piece.length];
                inside = (b[0] - a[0]) * (z - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0;
            }
            if (inside) {
                return true;
            }
        }
        return false;
    }
}
