// SPDX-License-Identifier: Apache-2.0
package org.SEAR.terrain;

/**
 * Positions of a height field's posts on a map: exact at every n-th post and interpolated between. The conversion
 * through geodesics and map projections is smooth but slow. Immutable, any thread.
 */
final class PlaneLattice {
    /** Maximum position error of a post, metres. */
    static final double TOLERANCE = 0.02;
    private static final int COARSEST = 256;
    private static final int FINEST = 4;

    /** Posts between two nodes. */
    private final int step;
    private final int nodesAcross;
    private final int lastRow;
    private final int lastColumn;
    private final double[] column;
    private final double[] row;

    private PlaneLattice(FieldGrid grid, MapPlane plane, int step) {
        this.step = step;
        this.lastRow = grid.rows - 1;
        this.lastColumn = grid.columns - 1;
        int nodesDown = (grid.rows + step - 2) / step + 1;
        this.nodesAcross = (grid.columns + step - 2) / step + 1;
        this.column = new double[nodesDown * nodesAcross];
        this.row = new double[nodesDown * nodesAcross];
        double[] at = new double[2];
        for (int node = 0; node < column.length; node++) {
            plane.at(grid.x(Math.min(node / nodesAcross * step, grid.rows - 1)),
                grid.z(Math.min(node % nodesAcross * step, grid.columns - 1)), at);
            column[node] = at[0];
            row[node] = at[1];
        }
    }

    /**
     * Returns the coarsest lattice within {@link #TOLERANCE}.
     * @param metresColumn spacing of the map's columns, metres, likewise metresRow
     */
    static PlaneLattice of(FieldGrid grid, MapPlane plane, double metresColumn, double metresRow) {
        int step = COARSEST;
        PlaneLattice lattice = new PlaneLattice(grid, plane, step);
        while (step > FINEST && !(lattice.error(grid, plane, metresColumn, metresRow) <= TOLERANCE)) {
            step /= 2;
            lattice = new PlaneLattice(grid, plane, step);
        }
        return lattice;
    }

    /**
     * Returns the maximum error between a sample of nodes, metres; NaN if a position is outside the map's coordinate
     * system.
     */
    private double error(FieldGrid grid, MapPlane plane, double metresColumn, double metresRow) {
        double[] at = new double[2];
        double worst = 0;
        int many = Math.max(1, nodesAcross / 16);
        int nodesDown = column.length / nodesAcross;
        for (int r = 0; r < nodesDown - 1; r += many) {
            for (int c = 0; c < nodesAcross - 1; c += many) {
                for (int half = 1; half < 4; half++) {
                    int postRow = Math.min(r * step + (half & 1) * step / 2, lastRow);
                    int postColumn = Math.min(c * step + (half >> 1) * step / 2, lastColumn);
                    plane.at(grid.x(postRow), grid.z(postColumn), at);
                    double error = Math.hypot((at[0] - column(postRow, postColumn)) * metresColumn,
                        (at[1] - row(postRow, postColumn)) * metresRow);
                    worst = error <= worst ? worst : error;
                }
            }
        }
        return worst;
    }

    /**
     * Writes the map's column and row at each post of a row.
     * @param into receives column and row, alternating
     */
    void places(int postRow, double[] into) {
        places(postRow, 0, lastColumn, into);
    }

    /**
     * Does the same for a part of a row.
     * @param from first post
     * @param to last post, greater than from
     */
    void places(int postRow, int from, int to, double[] into) {
        for (int c = from / step * step; c <= to && c < lastColumn; c += step) {
            int end = Math.min(c + step, lastColumn);
            double firstColumn = column(postRow, c);
            double firstRow = row(postRow, c);
            double columnStep = (column(postRow, end) - firstColumn) / (end - c);
            double rowStep = (row(postRow, end) - firstRow) / (end - c);
            for (int i = Math.max(c, from); i <= Math.min(end, to); i++) {
                into[2 * (i - from)] = firstColumn + (i - c) * columnStep;
                into[2 * (i - from) + 1] = firstRow + (i - c) * rowStep;
            }
        }
    }

    /** Returns the map's fractional column at a post. */
    double column(int postRow, int postColumn) {
        return between(column, postRow, postColumn);
    }

    /** Returns the map's fractional row at a post. */
    double row(int postRow, int postColumn) {
        return between(row, postRow, postColumn);
    }

    private double between(double[] nodes, int postRow, int postColumn) {
        int r = Math.min(postRow / step, nodes.length / nodesAcross - 2);
        int c = Math.min(postColumn / step, nodesAcross - 2);
        double v = (postRow - r * step) / (double) Math.min(step, lastRow - r * step);
        double u = (postColumn - c * step) / (double) Math.min(step, lastColumn - c * step);
        int at = r * nodesAcross + c;
        double low = nodes[at] + u * (nodes[at + 1] - nodes[at]);
        double high = nodes[at + nodesAcross] + u * (nodes[at + nodesAcross + 1] - nodes[at + nodesAcross]);
        return low + v * (high - low);
    }
}
