package org.SEAR.sensors;

import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SearObject;
import org.SEAR.POJOs.SensorObject;

/**
 * The errors of one sensor: reading = quantise(truth + bias + drift + white), or nothing at all when it drops out. The sensor itself clamps the
 * result to what it can say. Simulation thread.
 *
 * <p>White errors and drop-outs are functions of (seed, sensor name, step); the drift is a random walk that {@link #track} advances once a step by a
 * normal step of standard deviation drift * sqrt(step length).
 */
public final class ErrorModel {
    /** No errors: every value passes as it is. */
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
     * The errors of a sensor; {@link #NONE} if its object has none.
     *
     * @param seed of the simulation
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

    /** From now on random numbers come from another seed. */
    public void reseed(long seed) {
        random = noise == null ? null : new CounterRandom(seed, name);
    }

    /** Whether every value passes as it is. */
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

    /** Back to no drift. */
    public void reset() {
        java.util.Arrays.fill(drift, 0);
    }

    /**
     * Whether a value is missing.
     *
     * @param sample which of the step's values (a beam, an axis; 0 if all of a reading drop out together)
     */
    public boolean drops(long step, int sample) {
        return noise != null && noise.getDropout() > 0 && random.uniform(step, DROPOUT, sample) < noise.getDropout();
    }

    /**
     * A value with its error.
     *
     * @param channel which drift, from 0
     * @param sample which of the step's values; each has its own white error
     */
    public double apply(double value, long step, int channel, int sample) {
        return noise == null ? value : applyAt(value, step, drift[channel], sample);
    }

    /** The present drift of a channel; 0 without errors. */
    double drift(int channel) {
        return noise == null ? 0 : drift[channel];
    }

    /** A value with its error at a step at which its channel had drifted so far. */
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
