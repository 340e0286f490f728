// SPDX-License-Identifier: Apache-2.0
package org.SEAR.devices.rplidar;

import org.SEAR.devices.DeviceContext;
import org.SEAR.protocol.rplidar.Capsule;
import org.SEAR.protocol.rplidar.Node;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.LidarSource;

/**
 * The rotating head. It takes 2000 samples per second, 4000 in express scans, clockwise from straight ahead. The
 * motor's speed sets the samples per turn. Each sample is of its own time.
 */
final class Head {
    /** Duration, seconds, of the samples sent together: 16 nodes, or the 32 samples of a capsule. */
    static final double BLOCK_SECONDS = 0.008;
    private static final int NODES = 16;
    /** Reported quality of a sample with a distance; 15 is usual. */
    private static final int QUALITY = 15;
    private static final double CIRCLE = 360;
    private static final double MILLIMETRES = 1000;

    private final DeviceContext context;
    private final LidarSource source;
    private final int samplesPerTurn;
    private final double nearest;
    private LidarScan turn;
    private int perTurn;
    private int sample;

    /**
     * @param resolution degrees between two samples of a standard scan; grows with the motor's speed
     * @param nearest shortest measurable distance, metres
     */
    Head(double resolution, double nearest, LidarSource source, DeviceContext context) {
        this.context = context;
        this.source = source;
        this.samplesPerTurn = 2 * (int) Math.round(CIRCLE / 2 / resolution);
        this.nearest = nearest;
    }

    /** Speed of the head, turns per second. */
    double turnsPerSecond() {
        return NODES / BLOCK_SECONDS / samplesPerTurn;
    }

    /** Starts a scan; its first block is measured by {@code time}. */
    void start(boolean express, double time) {
        perTurn = express ? 2 * samplesPerTurn : samplesPerTurn;
        sample = 0;
        expectTurn(time, express ? Capsule.SAMPLES : NODES);
    }

    /**
     * Announces the start of the next turn to the source.
     *
     * @param time when the next block is measured
     * @param samples of a block
     */
    private void expectTurn(double time, int samples) {
        int blocks = sample == 0 ? 0 : (perTurn - sample) / samples;
        source.expect(time + blocks * BLOCK_SECONDS, CIRCLE, CIRCLE / perTurn);
    }

    /** Returns the next block of a scan, measured by {@code time}: nodes or a capsule. */
    byte[] block(boolean express, boolean first, double time) {
        byte[] bytes = express ? capsule(first, time) : nodes(time);
        expectTurn(time + BLOCK_SECONDS, express ? Capsule.SAMPLES : NODES);
        return bytes;
    }

    private byte[] nodes(double end) {
        byte[] bytes = new byte[NODES * Node.SIZE];
        for (int i = 0; i < NODES; i++) {
            boolean first = sample == 0;
            double angle = sample * CIRCLE / perTurn;
            double distance = next(end - (NODES - i) * BLOCK_SECONDS / NODES);
            System.arraycopy(Node.of(first, distance > 0 ? QUALITY : 0, angle, distance).toBytes(), 0, bytes,
                i * Node.SIZE, Node.SIZE);
        }
        return bytes;
    }

    /** @param first whether it is the first capsule after the request */
    private byte[] capsule(boolean first, double end) {
        double start = sample * CIRCLE / perTurn;
        int[] distances = new int[Capsule.SAMPLES];
        for (int i = 0; i < distances.length; i++) {
            distances[i] = (int) Math.round(next(end - (distances.length - i) * BLOCK_SECONDS / distances.length));
        }
        return Capsule.of(first, start, distances).toBytes();
    }

    /** Returns the next sample, taken at a time, in millimetres; 0 without a return. */
    private double next(double time) {
        if (sample == 0) {
            turn = source.scan(context.truth(), CIRCLE, CIRCLE / perTurn);
        }
        double range = source.range(context.truth(), turn, Math.floorMod(perTurn / 2 - sample, perTurn), time);
        sample = (sample + 1) % perTurn;
        return range < nearest || Double.isInfinite(range) || Double.isNaN(range) ? 0 : range * MILLIMETRES;
    }
}
