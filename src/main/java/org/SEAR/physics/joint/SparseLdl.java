// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics.joint;

import java.util.Arrays;

/**
 * Solves systems of equations with a sparse, symmetric, positive definite matrix by the factors L D L^T. The pattern of
 * L is found once from the elimination tree (Davis 2005, "Algorithm 849: a concise sparse Cholesky factorization
 * package"); a chain or a tree of joints then costs time in proportion to its length. No allocation after
 * {@link #analyse}. Simulation thread.
 */
final class SparseLdl {
    private int size;
    /** Rows of the entries above the diagonal, column after column. */
    private int[] starts;
    private int[] rows;
    private int[] firsts;
    private int[] lowerRows;
    private double[] lower;
    private double[] pivots;
    private double[] column;
    /** Entries of each row of L in the order of elimination: their columns, and their places in {@link #lower}. */
    private int[] rowStarts;
    private int[] rowColumns;
    private int[] rowPlaces;

    /**
     * Finds the pattern of the factors.
     * @param newStarts start of each column in {@code newRows}, and the end of the last one
     * @param newRows row numbers above the diagonal
     */
    void analyse(int newSize, int[] newStarts, int[] newRows) {
        size = newSize;
        starts = newStarts;
        rows = newRows;
        column = new double[size];
        pivots = new double[size];
        firsts = new int[size + 1];
        int[] parent = new int[size];
        int[] seen = new int[size];
        int[] lengths = new int[size];
        Arrays.fill(parent, -1);
        for (int k = 0; k < size; k++) {
            seen[k] = k;
            for (int p = starts[k]; p < starts[k + 1]; p++) {
                for (int i = rows[p]; seen[i] != k; i = parent[i]) {
                    parent[i] = parent[i] < 0 ? k : parent[i];
                    lengths[i]++;
                    seen[i] = k;
                }
            }
        }
        for (int k = 0; k < size; k++) {
            firsts[k + 1] = firsts[k] + lengths[k];
        }
        lowerRows = new int[firsts[size]];
        lower = new double[firsts[size]];
        findRows(parent);
    }

    private void findRows(int[] parent) {
        rowStarts = new int[size + 1];
        rowColumns = new int[firsts[size]];
        rowPlaces = new int[firsts[size]];
        int[] seen = new int[size];
        int[] path = new int[size];
        int[] lengths = new int[size];
        Arrays.fill(seen, -1);
        for (int k = 0; k < size; k++) {
            int at = rowStarts[k];
            for (int top = reach(k, parent, seen, path); top < size; top++) {
                int i = path[top];
                rowColumns[at] = i;
                rowPlaces[at] = firsts[i] + lengths[i]++;
                lowerRows[rowPlaces[at++]] = k;
            }
            rowStarts[k + 1] = at;
        }
    }

    /** Collects the columns on which column {@code k} depends, in the order of elimination. Returns their start. */
    private int reach(int k, int[] parent, int[] seen, int[] path) {
        int top = size;
        seen[k] = k;
        for (int p = starts[k]; p < starts[k + 1]; p++) {
            int length = 0;
            for (int i = rows[p]; seen[i] != k; i = parent[i]) {
                path[length++] = i;
                seen[i] = k;
            }
            while (length > 0) {
                path[--top] = path[--length];
            }
        }
        return top;
    }

    /**
     * Computes the factors.
     * @param diagonal of the matrix
     * @param entries above the diagonal, in the order of the row numbers
     */
    void factor(double[] diagonal, double[] entries) {
        for (int k = 0; k < size; k++) {
            for (int p = starts[k]; p < starts[k + 1]; p++) {
                column[rows[p]] += entries[p];
            }
            double pivot = diagonal[k];
            for (int at = rowStarts[k]; at < rowStarts[k + 1]; at++) {
                int i = rowColumns[at];
                int end = rowPlaces[at];
                double value = column[i];
                column[i] = 0;
                for (int p = firsts[i]; p < end; p++) {
                    column[lowerRows[p]] -= lower[p] * value;
                }
                double factor = value / pivots[i];
                pivot -= factor * value;
                lower[end] = factor;
            }
            pivots[k] = pivot;
        }
    }

    /** Replaces the right side by the solution. */
    void solve(double[] x) {
        for (int k = 0; k < size; k++) {
            double value = x[k];
            int end = firsts[k + 1];
            for (int p = firsts[k]; p < end; p++) {
                x[lowerRows[p]] -= lower[p] * value;
            }
        }
        for (int k = size - 1; k >= 0; k--) {
            double value = x[k] / pivots[k];
            int end = firsts[k + 1];
            for (int p = firsts[k]; p < end; p++) {
                value -= lower[p] * x[lowerRows[p]];
            }
            x[k] = value;
        }
    }
}
