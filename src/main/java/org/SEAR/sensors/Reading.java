// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/**
 * A sensor's reading in one step, in its forms for scripts, text, records, plots, views and board pins. A sensor from
 * outside SEAR returns a {@link Quantity}, a {@link Switch} or a class of its own, which must implement only
 * {@link #numbers}. Immutable; any thread.
 */
public interface Reading {
    /**
     * Returns the numbers for records and plots, in the unit of the sensor type. Their count is constant. NaN marks a
     * missing number, for example after a drop-out. A reading without numbers returns an empty array; more than 127
     * cannot be recorded.
     */
    double[] numbers();

    /**
     * Returns the numbers' names, appended to the sensor's name: empty for a single number, {@code .x .y .z} for three,
     * {@code .1 .2 ..} for others. As many as {@link #numbers}.
     */
    default List<String> names() {
        return names(numbers().length);
    }

    /** Returns the default names of a count of numbers. */
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

    /**
     * Returns the value for scripts: a Double for a single number, otherwise a double[]. Classes whose value is a text,
     * boolean or list override it.
     */
    default Object value() {
        double[] numbers = numbers();
        return numbers.length == 1 ? (Object) numbers[0] : numbers;
    }

    /**
     * Returns the reading as text.
     *
     * @param unit of the sensor type, see {@link SensorType#unit}; empty for none
     */
    default String words(String unit) {
        return words(numbers(), unit);
    }

    /**
     * Returns another reading of the same sensor as text, from numbers in a record: the numbers with their unit, or the
     * lowest and highest of many.
     *
     * @param kept as many as {@link #numbers}
     * @param unit of the sensor type; empty for none
     */
    default String words(double[] kept, String unit) {
        return ReadingWords.of(kept, unit);
    }

    /** Returns the plane of beams of this reading; null for none. */
    default LidarScan scan() {
        return null;
    }

    /** Returns the length of each beam, metres, infinite without a hit; null for a sensor without beams. */
    default double[] beams() {
        return scan() == null ? null : scan().ranges();
    }

    /** Returns where beams hit, {x, y, z} in the world, metres: empty without a hit; null if unknown. */
    default List<double[]> hits() {
        return null;
    }

    /** Returns the picture; null if the reading has none. */
    default Picture picture() {
        return null;
    }

    /**
     * Returns the voltage at a board's pin: 0 for a switch closed to ground; NaN if the sensor does not drive the pin.
     */
    default double volts() {
        return Double.NaN;
    }

    /** Returns the round-trip time of the sound, seconds; infinite without an echo. */
    default double echo() {
        return Double.POSITIVE_INFINITY;
    }
}
