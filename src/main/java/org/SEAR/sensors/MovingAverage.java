// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;

/**
 * Mean of the last values of a vector, for a sensor of limited bandwidth. A window that is not yet full averages the
 * values it has. Simulation thread.
 */
final class MovingAverage {
    private double[] values = new double[0];
    private int next;
    private int filled;

    /**
     * Returns the steps of a window of 1 / bandwidth, at least one.
     *
     * @param bandwidth Hz
     * @param stepLength seconds
     */
    static int steps(double bandwidth, double stepLength) {
        return (int) Math.max(1, Math.round(1 / (bandwidth * stepLength)));
    }

    /**
     * Adds a value.
     *
     * @param steps length of the window, constant between two {@link #clear}
     */
    void add(int steps, double x, double y, double z) {
        if (values.length != 3 * steps) {
            values = new double[3 * steps];
            clear();
        }
        values[3 * next] = x;
        values[3 * next + 1] = y;
        values[3 * next + 2] = z;
        next = (next + 1) % steps;
        filled = Math.min(filled + 1, steps);
    }

    /** Returns the mean along an axis; 0 for an empty window. */
    double mean(int axis) {
        double sum = 0;
        for (int i = 0; i < filled; i++) {
            sum += values[3 * i + axis];
        }
        return filled == 0 ? 0 : sum / filled;
    }

    void clear() {
        Arrays.fill(values, 0);
        next = 0;
        filled = 0;
    }
}
