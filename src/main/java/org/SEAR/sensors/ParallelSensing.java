package org.SEAR.sensors;

import java.util.Arrays;
import java.util.function.IntConsumer;
import org.SEAR.parallel.WorkerPool;

/**
 * Has several sensors measure at the same time, where they cast so many beams that it pays. Their readings are the same as one after the other: each
 * is a function of the truth, its own parameters and its own random numbers. One that fails does so again where it is asked for. Simulation thread.
 */
public final class ParallelSensing {
    /** Beams that take longer than waking a thread: 10 to 200 ns each. */
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

    /** The sensor's reading is about to be asked for. */
    public void read(Sensor<?> sensor, Truth truth) {
        int more = sensor.beamsAside();
        if (more > 0 && !sensor.isRead(truth)) {
            add(sensor, truth, more);
        }
    }

    /** The scanner may be asked for a scan, as {@link LidarSource#expect} has told, up to a time. */
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

    /** Measures what {@link #read} was called for, if it pays. */
    public void measure() {
        share(false);
    }

    /**
     * Makes the scans that {@link #scan} was called for, if it pays. They count until {@link LidarSensor#forgetAhead}.
     *
     * @return whether there are some
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
            sensors[number].forget();    // who asks for it meets the same again, and in its turn
        }
    }
}
