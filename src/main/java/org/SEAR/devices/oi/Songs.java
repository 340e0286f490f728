package org.SEAR.devices.oi;

import java.util.Arrays;

/** The songs that a robot remembers, and which one sounds. Durations are in 1/64 s; one of no duration is a song, too. */
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

    /** Whether a robot has so many songs. */
    boolean has(int song) {
        return song < durations.length;
    }

    /**
     * Command 140: number, count, then note and duration for each.
     *
     * @return whether there is room for such a song
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
     * Command 141; a song that sounds is not disturbed.
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

    /** Packet 36: the song last played. */
    int getNumber() {
        return number;
    }
}
