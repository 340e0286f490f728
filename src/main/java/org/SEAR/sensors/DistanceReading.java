// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Pose;

/** Reading of a distance sensor in one step, with its hit for records and views. Immutable; any thread. */
public final class DistanceReading implements Reading {
    /** Speed of sound in dry air at 20 degrees Celsius, m/s. */
    private static final double SOUND = 343.2;
    private static final int DIGITS = 3;

    private final double distance;
    private final double volts;
    private final BeamPattern pattern;
    private final Pose pose;
    private final int line;
    private final double[] hitPoint;
    private final String hitObject;

    /** Reading without a hit. */
    DistanceReading(double volts, BeamPattern pattern, Pose pose) {
        this(Double.POSITIVE_INFINITY, volts, pattern, pose, -1, null, null);
    }

    DistanceReading(double distance, double volts, BeamPattern pattern, Pose pose, int line, double[] hitPoint,
        String hitObject) {
        this.distance = distance;
        this.volts = volts;
        this.pattern = pattern;
        this.pose = pose;
        this.line = line;
        this.hitPoint = hitPoint;
        this.hitObject = hitObject;
    }

    /** Returns metres to the nearest hit of any ray, with the sensor's errors; +infinity without a return. */
    public double getDistance() {
        return distance;
    }

    /** Returns whether there is a return. */
    public boolean isReturn() {
        return distance != Double.POSITIVE_INFINITY;
    }

    /** Returns metres; without a return the longest ray's length, as the dissertation's {@code getDistanceResult}. */
    public double getDistanceOrRange() {
        return isReturn() ? distance : pattern.getMaxRange();
    }

    /** Returns the sensor's rays in its own frame, the same object at every step. */
    public BeamPattern getPattern() {
        return pattern;
    }

    /** Returns the sensor's pose in the world. */
    public Pose getPose() {
        return pose;
    }

    /** Returns the ray of the pattern with the nearest hit, or -1. */
    public int getLine() {
        return line;
    }

    /** Returns that ray's true hit point, {x, y, z} in the world, metres; null without a return. */
    public double[] getHitPoint() {
        return hitPoint == null ? null : hitPoint.clone();
    }

    /** Returns the name of the object hit; null without a return. */
    public String getHitObject() {
        return hitObject;
    }

    /** Returns {@link #getDistanceOrRange}. */
    @Override
    public double[] numbers() {
        return new double[] {getDistanceOrRange()};
    }

    @Override
    public String words(double[] kept, String unit) {
        return kept[0] < pattern.getMaxRange() ? ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit)
            : "nothing within " + ReadingWords.withUnit(ReadingWords.plain(pattern.getMaxRange()), unit);
    }

    /** Returns the true length to the hit for the ray that hit, infinity for the others. */
    @Override
    public double[] beams() {
        double[] lengths = new double[pattern.size()];
        Arrays.fill(lengths, Double.POSITIVE_INFINITY);
        if (line >= 0) {
            double x = hitPoint[0] - pose.x;
            double y = hitPoint[1] - pose.y;
            double z = hitPoint[2] - pose.z;
            lengths[line] = Math.sqrt(x * x + y * y + z * z);
        }
        return lengths;
    }

    @Override
    public List<double[]> hits() {
        return hitPoint == null ? List.of() : List.of(hitPoint.clone());
    }

    /** Returns the output of a triangulating infrared sensor; NaN for a beam without a voltage curve. */
    @Override
    public double volts() {
        return volts;
    }

    @Override
    public double echo() {
        return 2 * distance / SOUND;
    }

    @Override
    public String toString() {
        return isReturn() ? distance + " m" : "no return";
    }
}
