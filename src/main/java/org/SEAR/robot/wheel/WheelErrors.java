// SPDX-License-Identifier: Apache-2.0
package org.SEAR.robot.wheel;

import org.SEAR.POJOs.DriveErrors;
import org.SEAR.sensors.CounterRandom;

/**
 * Deviations of one robot's wheels and encoders, as the seed chooses them. Without errors every value is exactly the
 * nominal one. Immutable, simulation thread; allocates nothing after construction.
 */
public final class WheelErrors {
    /** Streams of random numbers. */
    private static final int RADIUS = 1;
    private static final int DIFFERENCE = 2;
    private static final int TRACK = 3;
    private static final int MISSED = 4;
    private static final int NOISE = 5;
    private static final double PERCENT = 100;

    private final DriveErrors errors;
    private final CounterRandom random;

    /**
     * @param errors of the robot's Dynamics; null for none
     * @param seed random seed of the simulation
     */
    public WheelErrors(DriveErrors errors, long seed, String robot) {
        this.errors = errors == null ? new DriveErrors() : errors;
        random = new CounterRandom(seed, robot);
    }

    /** Returns steering play, delay and understeer. */
    DriveErrors get() {
        return errors;
    }

    /** Ratio of a driven wheel's radius to its nominal one. */
    double size(int wheel) {
        return (1 + deviation(errors.getRadius(), RADIUS, 0)) * (
            1 + deviation(errors.getDifference(), DIFFERENCE, wheel));
    }

    /** Ratio of the distance between left and right wheels to the nominal one. */
    double track() {
        return 1 + deviation(errors.getTrack(), TRACK, 0);
    }

    /** Returns plus or minus half to all of the greatest deviation, both signs equally likely, as a ratio. */
    private double deviation(double greatest, int stream, int wheel) {
        double signed = 2 * random.uniform(0, stream, wheel) - 1;
        return greatest == 0 ? 0 : greatest / PERCENT * (signed + Math.signum(signed)) / 2;
    }

    /** Share of a step's counts that a wheel's encoder counts. */
    double counted(int wheel, long step) {
        return errors.getMissed() == 0 ? 1 : 1 - 2 * errors.getMissed() * random.uniform(step, MISSED, wheel);
    }

    /** Error of a reading of a wheel's encoder, radians. */
    double noise(int wheel, long step) {
        return errors.getEncoderNoise() == 0 ? 0 : Math.toRadians(errors.getEncoderNoise()) * random.normal(
            step, NOISE, wheel);
    }
}
