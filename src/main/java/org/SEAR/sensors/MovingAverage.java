package org.SEAR.sensors;

import java.util.Arrays;

/** The mean of the last values of a vector; a sensor of limited bandwidth. While it fills, what there is counts. Simulation thread. */
final class MovingAverage {
    private double[] values = new double[0];
    private int next;
    private int filled;

    /**
     * Steps that a window of 1 / bandwidth takes, at least one.
     *
     * @param bandwidth Hz
     * @param stepLength seconds
     */
    static int steps(double bandwidth, double stepLength) {
        return (int) Math.max(1, Math.round(1 / (bandwidth * stepLength)));
    }

    /**
     * Takes a value.
     *
     * @param steps length of the window, always the same between two {@link #clear}
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

    /** Mean of what is in the window along an axis, 0 if nothing is. */
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
