// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.SearObject;

/** A three-axis sensor of the robot's motion: mean over a window of 1 / bandwidth. Simulation thread. */
abstract class InertialSensor extends Sensor<VectorReading> {
    private static final int AXES = 3;

    private final double bandwidth;
    private final MovingAverage window = new MovingAverage();

    /** @param bandwidth Hz; from half the simulation's rate upwards the window is a single step */
    InertialSensor(SearObject parameters, double bandwidth, long seed) {
        super(parameters, seed, AXES);
        this.bandwidth = bandwidth;
    }

    /** Part of another sensor, without errors. */
    InertialSensor(SearObject parameters, double bandwidth) {
        super(parameters, ErrorModel.NONE);
        this.bandwidth = bandwidth;
    }

    /** Adds the last step's value, along the sensor's axes, to the window. */
    final void add(Truth truth, double x, double y, double z) {
        window.add(MovingAverage.steps(bandwidth, truth.stepLength()), x, y, z);
    }

    @Override
    public void reset() {
        super.reset();
        window.clear();
    }

    @Override
    protected final VectorReading measure(Truth truth) {
        if (errors.drops(truth.step(), 0)) {
            return new VectorReading(Double.NaN, Double.NaN, Double.NaN);
        }
        return new VectorReading(axis(truth, 0), axis(truth, 1), axis(truth, 2));
    }

    private double axis(Truth truth, int axis) {
        return errors.apply(window.mean(axis), truth.step(), axis, axis);
    }
}
