// SPDX-License-Identifier: Apache-2.0
package org.SEAR.physics;

/**
 * Block solver for all normal constraints of a manifold, used while all points push, as they do at rest: sequential
 * solving would rock the bodies. Loose solids with a point that did not push in the last pass skip it, since that
 * point would nearly always have to pull. The matrix of four coplanar points has rank three; a small softness
 * distributes the rest evenly. The array also holds the factor.
 */
final class NormalBlock {
    private static final int MOST = Manifold.MAX_POINTS;
    static final int SIZE = MOST * MOST;
    /** Softness: relative increase of the diagonal. */
    private static final double SOFT = 1e-3;

    /** Required separating speed of each point, m/s. */
    final double[] wanted = new double[MOST];
    /** Largest missing separating speed of a point in the last solve, m/s. */
    double fastest;
    /** Largest velocity change of a point in the last solve, m/s. */
    double change;
    private final double[] work = new double[SIZE];
    private final double[] sum = new double[MOST];

    /**
     * Factors the matrix of a manifold's points.
     * @param at start of the factor in the array
     * @param points start of the points' rows, one per {@link ContactRows#POINT}
     */
    void prepare(double[] r, int at, int points, int n, double massA, double massB) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double yields = PairRow.yields(r, points + i * ContactRows.POINT, points + k * ContactRows.POINT,
                    massA, massB);
                work[i * MOST + k] = i == k ? yields * (1 + SOFT) : yields;
            }
        }
        factor(r, at, n);
    }

    /** Computes the Cholesky factor with reciprocals of the diagonal, because divisions dominate the cost. */
    private void factor(double[] r, int at, int n) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double rest = work[i * MOST + k];
                for (int j = 0; j < k; j++) {
                    rest -= r[at + i * MOST + j] * r[at + k * MOST + j];
                }
                r[at + i * MOST + k] = i == k ? 1 / Math.sqrt(rest) : rest * r[at + k * MOST + k];
            }
        }
    }

    /**
     * Solves for the speeds in {@link #wanted}.
     * @return false, and changes nothing, if a point would have to pull
     */
    boolean solve(double[] r, int at, int points, int n, double[] p, double[] q, double massA, double massB) {
        fastest = 0;
        change = 0;
        for (int i = 0; i < n; i++) {
            sum[i] = wanted[i] - PairRow.along(r, points + i * ContactRows.POINT, p, q);
            fastest = Math.max(fastest, sum[i]);
            change = Math.max(change, Math.abs(sum[i]));
        }
        for (int i = 0; i < n; i++) {
            double rest = sum[i];
            for (int k = 0; k < i; k++) {
                rest -= r[at + i * MOST + k] * sum[k];
            }
            sum[i] = rest * r[at + i * MOST + i];
        }
        for (int i = n - 1; i >= 0; i--) {
            double rest = sum[i];
            for (int k = i + 1; k < n; k++) {
                rest -= r[at + k * MOST + i] * sum[k];
            }
            sum[i] = rest * r[at + i * MOST + i];
            work[i] = r[points + i * ContactRows.POINT + PairRow.IMPULSE] + sum[i];
            if (work[i] < 0) {
                return false;
            }
        }
        for (int i = 0; i < n; i++) {
            int point = points + i * ContactRows.POINT;
            PairRow.applyImpulse(r, point, p, q, massA, massB, work[i] - r[point + PairRow.IMPULSE]);
            r[point + PairRow.IMPULSE] = work[i];
        }
        return true;
    }
}
