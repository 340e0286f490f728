package org.SEAR.terrain;

/**
 * Where the posts of a height field lie on a map: exact at every so manyth post and interpolated between, because the way there by geodesics and map
 * projections is smooth, and slow. Immutable after it is made; any thread.
 */
final class PlaneLattice {
    /** Metres that a post may lie beside its place. */
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
            plane.at(grid.x(Math.min(node / nodesAcross * step, grid.rows - 1)), grid.z(Math.min(node % nodesAcross * step, grid.columns - 1)), at);
            column[node] = at[0];
            row[node] = at[1];
        }
    }

    /**
     * As coarse as it may be.
     *
     * @param metresColumn metres from column to column of the map, likewise metresRow
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

    /** The largest error in the middle between nodes, metres, of some of them; NaN if one has no place on the map. */
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
                    double error = Math.hypot((at[0] - column(postRow, postColumn)) * metresColumn, (at[1] - row(postRow, postColumn)) * metresRow);
                    worst = error <= worst ? worst : error;
                }
            }
        }
        return worst;
    }

    /**
     * Column and row on the map of each post of a row.
     *
     * @param into takes them, alternating
     */
    void places(int postRow, double[] into) {
        places(postRow, 0, lastColumn, into);
    }

    /**
     * The same of a part of a row.
     *
     * @param from its first post
     * @param to its last post, at least one further
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

    /** The map's column at a post, with fractions. */
    double column(int postRow, int postColumn) {
        return between(column, postRow, postColumn);
    }

    /** The map's row at a post, with fractions. */
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
