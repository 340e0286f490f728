package org.SEAR.physics;

/**
 * All points of a manifold solved at once where all of them push, which is how things rest: one after the other they would turn the bodies to and
 * fro. The matrix of four points in a plane has rank three; a little softness shares what is left evenly. Simulation thread.
 */
final class NormalBlock {
    /** Share of the diagonal that is added to it. */
    private static final double SOFT = 1e-3;
    private static final int MOST = Manifold.MOST_POINTS;

    private final double[] inverse = new double[MOST * MOST];
    private final double[] work = new double[MOST * MOST];
    private final double[] error = new double[MOST];
    private final double[] sum = new double[MOST];

    /** Makes the matrix of the manifold's points and its inverse. */
    void prepare(Manifold of) {
        int n = of.count;
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double yields = of.points[i].yields(of, of.points[k]);
                work[i * MOST + k] = i == k ? yields * (1 + SOFT) : yields;
            }
        }
        factor(n);
        for (int column = 0; column < n; column++) {
            column(n, column);
        }
    }

    /** Cholesky's factor in place. */
    private void factor(int n) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k <= i; k++) {
                double rest = work[i * MOST + k];
                for (int j = 0; j < k; j++) {
                    rest -= work[i * MOST + j] * work[k * MOST + j];
                }
                work[i * MOST + k] = i == k ? Math.sqrt(rest) : rest / work[k * MOST + k];
            }
        }
    }

    private void column(int n, int column) {
        for (int i = 0; i < n; i++) {
            double rest = i == column ? 1 : 0;
            for (int k = 0; k < i; k++) {
                rest -= work[i * MOST + k] * sum[k];
            }
            sum[i] = rest / work[i * MOST + i];
        }
        for (int i = n - 1; i >= 0; i--) {
            double rest = sum[i];
            for (int k = i + 1; k < n; k++) {
                rest -= work[k * MOST + i] * sum[k];
            }
            sum[i] = rest / work[i * MOST + i];
            inverse[i * MOST + column] = sum[i];
        }
    }

    /** Room for the speed at which each point is to part, m/s. */
    double[] wanted() {
        return error;
    }

    /**
     * Solves for the speeds in {@link #wanted}.
     *
     * @return false, and nothing is done, if a point would have to pull
     */
    boolean solve(Manifold of) {
        int n = of.count;
        for (int i = 0; i < n; i++) {
            sum[i] = error[i] - of.points[i].parting(of);
        }
        for (int i = 0; i < n; i++) {
            double change = 0;
            for (int k = 0; k < n; k++) {
                change += inverse[i * MOST + k] * sum[k];
            }
            work[i] = of.points[i].impulse + change;
            if (work[i] < 0) {
                return false;
            }
        }
        for (int i = 0; i < n; i++) {
            ContactPoint point = of.points[i];
            point.push(of, work[i] - point.impulse);
            point.impulse = work[i];
        }
        return true;
    }
}
