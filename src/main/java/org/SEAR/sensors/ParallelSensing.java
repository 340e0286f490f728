// SPDX-License-Identifier: Apache-2.0
package org.SEAR.sensors;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.SEAR.parallel.WorkerPool;

/**
 * Measures several sensors in parallel where their number of beams makes it worthwhile. Readings are the same as in
 * sequence: each is a function of the truth, its parameters and its own random numbers. A failing sensor fails again
 * where its reading is requested. Simulation thread.
 */
public final class ParallelSensing {
    /** Number of beams that takes longer than waking a thread; a beam takes 10 to 200 ns. */
    static final int WORTH_SHARING = 1500;
    private static final int FIRST_SIZE = 16;

    private final WorkerPool workers;
    private final IntConsumer piece = this::measure;
    private Sensor<?>[] sensors = new Sensor<?>[FIRST_SIZE];
    private Truth[] truths = new Truth[FIRST_SIZE];
    private int count;
    private long beams;
    private boolean scans;

    public ParallelSensing(WorkerPool workers) {
        this.workers = workers;
    }

    /** Queues a sensor whose reading will be requested. */
    public void read(Sensor<?> sensor, Truth truth) {
        int more = sensor.beamsAside();
        if (more > 0 && !sensor.isRead(truth)) {
            add(sensor, truth, more);
        }
    }

    /** Queues a scanner for its next scan, if {@link LidarSource#expect} announced one up to a time. */
    public void scan(LidarSensor scanner, Truth truth, double end) {
        int more = scanner.beamsExpected(end);
        if (more > 0) {
            add(scanner, truth, more);
        }
    }

    private void add(Sensor<?> sensor, Truth truth, int more) {
        if (sensor.isQueued) {
            return;
        }
        if (count == sensors.length) {
            sensors = Arrays.copyOf(sensors, 2 * count);
            truths = Arrays.copyOf(truths, 2 * count);
        }
        sensor.isQueued = true;
        sensors[count] = sensor;
        truths[count++] = truth;
        beams += more;
    }

    /** Measures the sensors queued by {@link #read}, if it is worthwhile. */
    public void measure() {
        share(false);
    }

    /**
     * Measures the scans queued by {@link #scan}, if it is worthwhile. They are valid until
     * {@link LidarSensor#forgetAhead}.
     *
     * @return whether scans were measured
     */
    public boolean scanAhead() {
        return share(true);
    }

    private boolean share(boolean ofScans) {
        boolean pays = count > 1 && beams >= WORTH_SHARING && workers.getThreads() > 1;
        if (pays) {
            scans = ofScans;
            workers.forEach(count, piece);
        }
        for (int i = 0; i < count; i++) {
            sensors[i].isQueued = false;
        }
        count = 0;
        beams = 0;
        return pays;
    }

    private void measure(int number) {
        try {
            if (scans) {
                ((LidarSensor) sensors[number]).scanAhead(truths[number]);
            } else {
                sensors[number].read(truths[number]);
            }
        } catch (RuntimeException | Error e) {
            sensors[number].forget();    // the caller that requests the reading gets the error again, in its turn
        }
    }
}
