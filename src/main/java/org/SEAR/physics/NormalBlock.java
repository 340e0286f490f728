package org.SEAR.physics;

/**
 * All points of a manifold solved at once where all of them push, which is how things rest: one after the other they would turn the bodies to and
 * fro. The matrix of four points in a plane has rank three; a little softness shares what is left evenly. Its inverse is in the array of
 * {@link ContactRows}. Simulation thread.
 */
final class NormalBlock {
    private static final int MOST = Manifold.MOST_POINTS;
    static final int SIZE = MOST * MOST;
    /** Share of the diagonal that is added to it. */
    private static final double SOFT = 1e-3;

    /** The speed at which each point is to part, m/s. */
    final double[] wanted = new double[MOST];
    private final double[] work = new double[SIZE];
    private final double[] sum = new double[MOST];

    /**
     * Makes the inverse of the matrix of a manifold's points.
     *
     * @param at where it goes in the array
     * @param points where the rows of the points begin, one each {@link ContactRows#POINT}
     */
    void prepare(double[] r, int at, int points, int n, double massA, double massB) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double yields = PairRow.yields(r, points + i * ContactRows.POINT, points + k * ContactRows.POINT, massA, massB);
                work[i * MOST + k] = i == k ? yields * (1 + SOFT) : yields;
            }
        }
        factor(n);
        for (int column = 0; column < n; column++) {
            column(r, at, n, column);
        }
    }

    /** Cholesky's factor in place, with the reciprocals of its diagonal: dividing takes longer than all else here. */
    private void factor(int n) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double rest = work[i * MOST + k];
                for (int j = 0; j < k; j++) {
                    rest -= work[i * MOST + j] * work[k * MOST + j];
                }
                work[i * MOST + k] = i == k ? 1 / Math.sqrt(rest) : rest * work[k * MOST + k];
            }
        }
    }

    private void column(double[] r, int at, int n, int column) {
        for (int i = 0; i < n; i++) {
            double rest = i == column ? 1 : 0;
            for (int k = 0; k < i; k++) {
                rest -= work[i * MOST + k] * sum[k];
            }
            sum[i] = rest * work[i * MOST + i];
        }
        for (int i = n - 1; i >= 0; i--) {
            double rest = sum[i];
            for (int k = i + 1; k < n; k++) {
                rest -= work[k * MOST + i] * sum[k];
            }
            sum[i] = rest * work[i * MOST + i];
            r[at + i * MOST + column] = sum[i];
        }
    }

    /**
     * Solves for the speeds in {@link #wanted}.
     *
     * @return false, and nothing is done, if a point would have to pull
     */
    boolean solve(double[] r, int at, int points, int n, double[] p, double[] q, double massA, double massB) {
        for (int i = 0; i < n; i++) {
            sum[i] = wanted[i] - PairRow.along(r, points + i * ContactRows.POINT, p, q);
        }
        for (int i = 0; i < n; i++) {
            double change = 0;
            for (int k = 0; k < n; k++) {
                change += r[at + i * MOST + k] * sum[k];
            }
            work[i] = r[points + i * ContactRows.POINT + PairRow.IMPULSE] + change;
            if (work[i] < 0) {
                return false;
            }
        }
        for (int i = 0; i < n; i++) {
            int point = points + i * ContactRows.POINT;
            PairRow.push(r, point, p, q, massA, massB, work[i] - r[point + PairRow.IMPULSE]);
            r[point + PairRow.IMPULSE] = work[i];
        }
        return true;
    }
}
