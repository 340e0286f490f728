// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import org.SEAR.geometry.Pose;
import org.SEAR.raycast.BeamScene;

/** Ground truth that a test moves step by step. */
final class ScriptedTruth implements Truth {
    static final double STEP = 1 / 60.0;
    /** 2026-01-01T12:00:00Z. */
    static final long NEW_YEAR_2026 = 1767268800000L;

    long step;
    long epoch = NEW_YEAR_2026;
    double path;
    Pose body = Pose.IDENTITY;
    BeamScene scene;
    Earth earth = new Earth(null, MagneticModel.standard());
    final double[] velocity = new double[3];
    final double[] turn = new double[3];

    ScriptedTruth at(double x, double y, double z, double rx, double ry, double rz) {
        body = Pose.ofDegrees(x, y, z, rx, ry, rz);
        return this;
    }

    ScriptedTruth moving(double x, double y, double z) {
        velocity[0] = x;
        velocity[1] = y;
        velocity[2] = z;
        return this;
    }

    ScriptedTruth turning(double x, double y, double z) {
        turn[0] = x;
        turn[1] = y;
        turn[2] = z;
        return this;
    }

    @Override
    public boolean isTouched(String part) {
        return true;
    }

    /** Advances one step and lets the sensors track it. */
    ScriptedTruth advance(Sensor<?>... sensors) {
        step++;
        for (Sensor<?> sensor : sensors) {
            sensor.track(this);
        }
        return this;
    }

    @Override
    public long step() {
        return step;
    }

    @Override
    public double time() {
        return step * STEP;
    }

    @Override
    public double stepLength() {
        return STEP;
    }

    @Override
    public long epochMillis() {
        return epoch;
    }

    @Override
    public Pose body() {
        return body;
    }

    @Override
    public double[] velocity() {
        return velocity;
    }

    @Override
    public double[] angularVelocity() {
        return turn;
    }

    @Override
    public double path() {
        return path;
    }

    @Override
    public double gravity() {
        return 9.81;
    }

    @Override
    public Earth earth() {
        return earth;
    }

    @Override
    public BeamScene scene() {
        return scene;
    }

    @Override
    public int owner() {
        return 0;
    }

    @Override
    public String objectName(int shape) {
        return "shape " + shape;
    }
}
