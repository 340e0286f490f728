package org.SEAR.sensors;

import java.util.Arrays;
import java.util.List;
import org.SEAR.geometry.Pose;

/** What a distance sensor met in one step, with everything that shows it. Immutable, any thread. */
public final class DistanceReading implements Reading {
    /** m/s, of dry air at 20 degrees. */
    private static final double SOUND = 343.2;
    private static final int DIGITS = 3;

    private final double distance;
    private final double volts;
    private final BeamPattern pattern;
    private final Pose pose;
    private final int line;
    private final double[] hitPoint;
    private final String hitObject;

    /** Nothing was met. */
    DistanceReading(double volts, BeamPattern pattern, Pose pose) {
        this(Double.POSITIVE_INFINITY, volts, pattern, pose, -1, null, null);
    }

    DistanceReading(double distance, double volts, BeamPattern pattern, Pose pose, int line, double[] hitPoint, String hitObject) {
        this.distance = distance;
        this.volts = volts;
        this.pattern = pattern;
        this.pose = pose;
        this.line = line;
        this.hitPoint = hitPoint;
        this.hitObject = hitObject;
    }

    /** Metres to the nearest thing that any line met, with the sensor's errors; +infinity for no return. */
    public double getDistance() {
        return distance;
    }

    /** Whether anything came back. */
    public boolean isReturn() {
        return distance != Double.POSITIVE_INFINITY;
    }

    /** Metres; the longest line's length where nothing came back, as the dissertation's {@code getDistanceResult} answers. */
    public double getDistanceOrRange() {
        return isReturn() ? distance : pattern.getMaxRange();
    }

    /** The sensor's lines in its own frame; the same object at every step. */
    public BeamPattern getPattern() {
        return pattern;
    }

    /** The sensor in the world. */
    public Pose getPose() {
        return pose;
    }

    /** The line of the pattern that met the nearest thing, or -1. */
    public int getLine() {
        return line;
    }

    /** Where that line truly met it, world frame {x, y, z} in metres; null for no return. */
    public double[] getHitPoint() {
        return hitPoint == null ? null : hitPoint.clone();
    }

    /** Name of the object that was met; null for no return. */
    public String getHitObject() {
        return hitObject;
    }

    /** {@link #getDistanceOrRange}. */
    @Override
    public double[] numbers() {
        return new double[] {getDistanceOrRange()};
    }

    @Override
    public String words(double[] kept, String unit) {
        return kept[0] < pattern.getMaxRange() ? ReadingWords.withUnit(ReadingWords.fixed(kept, DIGITS), unit)
            : "nothing within " + ReadingWords.withUnit(ReadingWords.plain(pattern.getMaxRange()), unit);
    }

    /** The true way to what was met, on the line that met it. */
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

    /** What a triangulating infrared sensor puts out; NaN for a beam without a voltage curve. */
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
