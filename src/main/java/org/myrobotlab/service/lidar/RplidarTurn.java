// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.lidar;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.SEAR.protocol.rplidar.Capsule;
import org.SEAR.protocol.rplidar.Node;

/** Assembles an RPLIDAR's samples to turns, and turns to scans, right to left. One thread at a time. */
final class RplidarTurn {
    /** Most samples per turn: four times those of the fastest mode of any RPLIDAR at its slowest turn. */
    private static final int MAX_SAMPLES = 32768;
    private static final double CIRCLE = 360;
    private static final double STRAIGHT_AHEAD = 90;
    private static final double BEHIND = -90;
    /** Millimetres; greater than 16 bits of quarter millimetres hold. */
    private static final int NO_RETURN = 16384;
    private static final double ROUNDING = 1e-6;

    private final List<Sample> samples = new ArrayList<>();
    private boolean begun;
    private Capsule last;
    private double lastAngle;

    void clear() {
        samples.clear();
        begun = false;
        last = null;
        lastAngle = 0;
    }

    /**
     * Adds a node.
     *
     * @return the turn that ended before it, or null
     */
    List<Sample> add(Node node) {
        List<Sample> turn = node.isFirst() ? next() : null;
        add(node.getAngle(), node.getDistance());
        return turn;
    }

    /**
     * Adds a capsule. The angles of its samples are known when the next one arrives.
     *
     * @return the turn that ended, or null
     */
    List<Sample> add(Capsule capsule) {
        List<Sample> turn = null;
        if (last != null && !capsule.isFirst()) {
            double step = ((capsule.getStart() - last.getStart() + CIRCLE) % CIRCLE) / Capsule.SAMPLES;
            for (int i = 0; i < Capsule.SAMPLES; i++) {
                double angle = (last.getStart() + i * step - last.getShift(i) + CIRCLE) % CIRCLE;
                if (angle < lastAngle - CIRCLE / 2) {
                    turn = next();
                }
                lastAngle = angle;
                add(angle, last.getDistance(i));
            }
        }
        last = capsule;
        return turn;
    }

    private List<Sample> next() {
        List<Sample> turn = begun ? new ArrayList<>(samples) : null;
        samples.clear();
        begun = true;
        return turn;
    }

    private void add(double angle, double distance) {
        if (begun && samples.size() < MAX_SAMPLES) {
            samples.add(new Sample(angle, distance));
        }
    }

    /**
     * Returns the scan of a turn.
     *
     * @param spread degrees, centred on straight ahead
     */
    static RangeScan scan(List<Sample> turn, double spread, double time) {
        double resolution = CIRCLE / turn.size();
        List<Sample> wanted = new ArrayList<>();
        for (Sample sample : turn) {
            if (Math.abs(sample.angle - STRAIGHT_AHEAD) <= spread / 2 + ROUNDING) {
                wanted.add(sample);
            }
        }
        wanted.sort(Comparator.comparingDouble(sample -> sample.angle));
        int[] raw = new int[wanted.size()];
        double[] angles = new double[raw.length];
        for (int i = 0; i < raw.length; i++) {
            raw[i] = wanted.get(i).millimetres;
            angles[i] = wanted.get(i).angle;
        }
        return new RangeScan(raw, "mm", 1, NO_RETURN, angles, resolution, time);
    }

    /** One measurement. */
    static final class Sample {
        private final double angle;
        private final int millimetres;

        /** @param clockwise degrees from straight ahead */
        private Sample(double clockwise, double millimetres) {
            double counterClockwise = STRAIGHT_AHEAD - clockwise;
            this.angle = counterClockwise < BEHIND ? counterClockwise + CIRCLE : counterClockwise;
            this.millimetres = (int) Math.round(millimetres);
        }
    }
}
