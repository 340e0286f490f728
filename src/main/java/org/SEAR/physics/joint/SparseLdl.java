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
    private int[] parent;
    private int[] firsts;
    private int[] lengths;
    private int[] lowerRows;
    private double[] lower;
    private double[] pivots;
    private double[] column;
    private int[] path;
    private int[] seen;

    /**
     * Finds the pattern of the factors.
     * @param newStarts start of each column in {@code newRows}, and the end of the last one
     * @param newRows row numbers above the diagonal
     */
    void analyse(int newSize, int[] newStarts, int[] newRows) {
        size = newSize;
        starts = newStarts;
        rows = newRows;
        parent = new int[size];
        lengths = new int[size];
        seen = new int[size];
        path = new int[size];
        column = new double[size];
        pivots = new double[size];
        firsts = new int[size + 1];
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
    }

    /**
     * Computes the factors.
     * @param diagonal of the matrix
     * @param entries above the diagonal, in the order of the row numbers
     */
    void factor(double[] diagonal, double[] entries) {
        Arrays.fill(lengths, 0);
        Arrays.fill(seen, -1);
        for (int k = 0; k < size; k++) {
            int top = reach(k, entries);
            double pivot = diagonal[k];
            for (; top < size; top++) {
                int i = path[top];
                double value = column[i];
                column[i] = 0;
                int end = firsts[i] + lengths[i];
                for (int p = firsts[i]; p < end; p++) {
                    column[lowerRows[p]] -= lower[p] * value;
                }
                double factor = value / pivots[i];
                pivot -= factor * value;
                lowerRows[end] = k;
                lower[end] = factor;
                lengths[i]++;
            }
            pivots[k] = pivot;
        }
    }

    /** Scatters column {@code k} and collects the columns on which it depends, in the order of elimination. */
    private int reach(int k, double[] entries) {
        int top = size;
        seen[k] = k;
        for (int p = starts[k]; p < starts[k + 1]; p++) {
            int i = rows[p];
            column[i] += entries[p];
            int length = 0;
            for (; seen[i] != k; i = parent[i]) {
                path[length++] = i;
                seen[i] = k;
            }
            while (length > 0) {
                path[--top] = path[--length];
            }
        }
        return top;
    }

    /** Replaces the right side by the solution. */
    void solve(double[] x) {
        for (int k = 0; k < size; k++) {
            double value = x[k];
            for (int p = firsts[k]; p < firsts[k] + lengths[k]; p++) {
                x[lowerRows[p]] -= lower[p] * value;
            }
        }
        for (int k = size - 1; k >= 0; k--) {
            double value = x[k] / pivots[k];
            for (int p = firsts[k]; p < firsts[k] + lengths[k]; p++) {
                value -= lower[p] * x[lowerRows[p]];
            }
            x[k] = value;
        }
    }
}
