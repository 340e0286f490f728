package org.SEAR.sensors;

import org.SEAR.geometry.Pose;

/** What a distance sensor met in one step, with everything that shows it. Immutable, any thread. */
public final class DistanceReading {
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

    /** What a triangulating infrared sensor puts out, volts; NaN for a beam without a voltage curve. */
    public double getVolts() {
        return volts;
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

    @Override
    public String toString() {
        return isReturn() ? distance + " m" : "no return";
    }
}
