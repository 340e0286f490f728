// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.oi;

import java.util.Arrays;

/** Songs that a robot stores, and the playing song. Durations are in 1/64 s. A song of duration 0 is defined, too. */
final class Songs {
    private static final int MAX_NOTES = 16;
    private static final double TICK = 1 / 64.0;

    private final double[] durations;
    private int number;
    private double end = Double.NEGATIVE_INFINITY;

    Songs(int count) {
        durations = new double[count];
        Arrays.fill(durations, Double.NaN);
    }

    /** Whether a song number is in the robot's range. */
    boolean has(int song) {
        return song < durations.length;
    }

    /**
     * Stores a song (command 140): number, count, then note and duration for each.
     *
     * @return whether the number and length are legal
     */
    boolean define(int[] arguments) {
        int notes = arguments[1];
        if (!has(arguments[0]) || notes == 0 || notes > MAX_NOTES) {
            return false;
        }
        double sum = 0;
        for (int i = 0; i < notes; i++) {
            sum += arguments[2 * i + 3] * TICK;
        }
        durations[arguments[0]] = sum;
        return true;
    }

    /**
     * Plays a song (command 141), unless one is playing.
     *
     * @return whether it is defined
     */
    boolean play(int song, double time) {
        if (Double.isNaN(durations[song])) {
            return false;
        }
        if (!isPlaying(time)) {
            number = song;
            end = time + durations[song];
        }
        return true;
    }

    boolean isPlaying(double time) {
        return time < end;
    }

    /** Song last played (packet 36). */
    int getNumber() {
        return number;
    }
}
