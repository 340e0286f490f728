package org.SEAR.sensors;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * What a sensor has read in one step, and how it is told: to scripts, in words, in records and plots, in the views, to the pin of a board. A sensor
 * from outside SEAR answers a {@link Quantity}, a {@link Switch}, or a class of its own, which has to say its numbers only. Immutable, any thread.
 */
public interface Reading {
    /**
     * The numbers that records and plots keep, in the unit of the sensor's type; always as many. Not a number where there is none, as after a
     * drop-out. A reading that has no numbers answers an empty array; one with more than 127 can't be recorded.
     */
    double[] numbers();

    /**
     * What the numbers are called, appended to the sensor's name: nothing for a single one, {@code .x .y .z} for three, {@code .1 .2 ..} for
     * others. As many as {@link #numbers}.
     */
    default List<String> names() {
        return names(numbers().length);
    }

    /** What so many numbers are called if nothing else is said. */
    static List<String> names(int size) {
        switch (size) {
            case 1:
                return List.of("");
            case 3:
                return List.of(".x", ".y", ".z");
            default:
                return IntStream.rangeClosed(1, size).mapToObj(i -> "." + i).collect(Collectors.toUnmodifiableList());
        }
    }

    /** What a script gets: a Double for a single number, else a double[]; a class of its own says so if it is a text, a truth value or a list. */
    default Object value() {
        double[] numbers = numbers();
        return numbers.length == 1 ? (Object) numbers[0] : numbers;
    }

    /**
     * In words, for people.
     *
     * @param unit of the sensor's type, see {@link SensorType#unit}; empty for none
     */
    default String words(String unit) {
        return words(numbers(), unit);
    }

    /**
     * Another reading of the same sensor, of which a record has kept the numbers, in words: the numbers with their unit, or the lowest and the
     * highest of many.
     *
     * @param kept as many as {@link #numbers}
     * @param unit of the sensor's type; empty for none
     */
    default String words(double[] kept, String unit) {
        return ReadingWords.of(kept, unit);
    }

    /** The plane of beams that it is or has; null for none. */
    default LidarScan scan() {
        return null;
    }

    /** Length of each beam, metres, infinite where nothing was hit; null for a reading of a sensor without beams. */
    default double[] beams() {
        return scan() == null ? null : scan().ranges();
    }

    /** Where beams have met something, {x, y, z} in the world, metres: empty if nothing was met; null if it does not know. */
    default List<double[]> hits() {
        return null;
    }

    /** What it looks like; null for what is no picture. */
    default Picture picture() {
        return null;
    }

    /** What the sensor puts on a pin of a board, volts: 0 for a closed switch to ground; NaN if it leaves the pin alone. */
    default double volts() {
        return Double.NaN;
    }

    /** How long the sound that it has sent is on its way, there and back, seconds; infinite if nothing comes back. */
    default double echo() {
        return Double.POSITIVE_INFINITY;
    }
}
