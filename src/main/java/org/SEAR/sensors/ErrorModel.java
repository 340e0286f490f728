// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;

/**
 * Errors of one sensor: reading = quantise(truth + bias + drift + white), or no value after a drop-out. The sensor
 * clamps the result to its range. Simulation thread.
 *
 * <p>White errors and drop-outs are functions of (seed, sensor name, step). The drift is a random walk. {@link #track}
 * advances it once per step by a normal number of standard deviation drift * sqrt(step length).
 */
public final class ErrorModel {
    /** No errors: every value passes unchanged. */
    public static final ErrorModel NONE = new ErrorModel(null, null, 0);

    private static final int WHITE = 1;
    private static final int DRIFT = 2;
    private static final int DROPOUT = 3;

    private final Noise noise;
    private final String name;
    private final double[] drift;
    private CounterRandom random;

    private ErrorModel(Noise noise, String name, int channels) {
        this.noise = noise;
        this.name = name;
        this.drift = new double[channels];
    }

    /**
     * Returns the errors of a sensor; {@link #NONE} if its object has none.
     *
     * @param seed random seed of the simulation
     * @param channels independent drifts, for example 3 for three axes
     */
    public static ErrorModel of(SearObject parameters, long seed, int channels) {
        Noise noise = parameters instanceof SensorObject ? ((SensorObject) parameters).getNoise() : null;
        if (noise == null) {
            return NONE;
        }
        ErrorModel errors = new ErrorModel(noise, parameters.getFullName(), channels);
        errors.reseed(seed);
        return errors;
    }

    /** Takes later random numbers from another seed. */
    public void reseed(long seed) {
        random = noise == null ? null : new CounterRandom(seed, name);
    }

    /** Returns whether every value passes unchanged. */
    public boolean isNone() {
        return noise == null;
    }

    /** Advances the drift by a step. */
    public void track(Truth truth) {
        if (noise == null || noise.getDrift() == 0 || truth.step() == 0) {
            return;
        }
        double size = noise.getDrift() * Math.sqrt(truth.stepLength());
        for (int channel = 0; channel < drift.length; channel++) {
            drift[channel] += size * random.normal(truth.step(), DRIFT, channel);
        }
    }

    /** Resets the drift to 0. */
    public void reset() {
        java.util.Arrays.fill(drift, 0);
    }

    /**
     * Returns whether a value drops out.
     *
     * @param sample number of the value in this step (a beam, an axis; 0 if all values of a reading drop out together)
     */
    public boolean drops(long step, int sample) {
        return noise != null && noise.getDropout() > 0 && random.uniform(step, DROPOUT, sample) < noise.getDropout();
    }

    /**
     * Returns a value with its error.
     *
     * @param channel number of the drift, from 0
     * @param sample number of the value in this step; each has its own white error
     */
    public double apply(double value, long step, int channel, int sample) {
        return noise == null ? value : applyAt(value, step, drift[channel], sample);
    }

    /** Returns the present drift of a channel; 0 without errors. */
    double drift(int channel) {
        return noise == null ? 0 : drift[channel];
    }

    /** Returns a value with its error at a step with this drift. */
    double applyAt(double value, long step, double drifted, int sample) {
        if (noise == null) {
            return value;
        }
        double result = value + noise.getBias() + drifted;
        if (noise.getWhite() > 0) {
            result += noise.getWhite() * random.normal(step, WHITE, sample);
        }
        double smallest = noise.getQuantisation();
        return smallest > 0 ? Math.floor(result / smallest + 0.5) * smallest : result;
    }
}
