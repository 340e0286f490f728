// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.readings;

import java.util.Map;
import java.util.concurrent.ConcurrentSkipListMap;
import java.util.concurrent.Executors;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.SEAR.grammar.ScriptText;
import org.myrobotlab.serial.PortClock;
import org.myrobotlab.service.sear.Host;
import org.myrobotlab.service.sear.SensorReading;
import org.myrobotlab.service.sear.lockstep.SleepingThreads;
import org.myrobotlab.service.sear.run.SimulationControl;
import org.myrobotlab.service.sear.run.SimulationSession;

/**
 * Publishes readings and the state of the world while a simulation runs: readings by simulated time, the state for
 * panels by the computer's clock. In lock-step the thread that advances time publishes readings. Any thread.
 */
public final class Publisher {
    private static final long LOOK_MILLIS = 10;
    private static final long STATE_MILLIS = 100;
    private static final long FINISH_SECONDS = 1;
    private static final double HIGHEST_RATE = 60;
    /** Simulated time without a reading after which SEAR warns a listener's user, s. */
    private static final double TIMEOUT = 2;

    private final SimulationControl control;
    private final ScriptReadings readings;
    private final ScriptCameras cameras;
    private final Host host;
    private volatile String lastFailure = "";
    private volatile boolean started;
    private volatile boolean silenceReported;
    private final Map<String, Schedule> subscriptions = new ConcurrentSkipListMap<>();
    private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread thread = new Thread(work, "SEAR publisher");
        thread.setDaemon(true);
        return thread;
    });

    /** Starts the periodic checks. */
    public Publisher(Host host, SimulationControl control, ScriptReadings readings, ScriptCameras cameras) {
        this.host = host;
        this.control = control;
        this.readings = readings;
        this.cameras = cameras;
        timer.scheduleWithFixedDelay(() -> guarded(this::look), LOOK_MILLIS, LOOK_MILLIS, TimeUnit.MILLISECONDS);
        timer.scheduleWithFixedDelay(() -> guarded(() -> {
            SimulationSession session = control.sessionOrNull();
            if (session != null) {
                session.reportWarnings();
                session.lookForClockTrap();
                host.state();
            }
        }), STATE_MILLIS, STATE_MILLIS, TimeUnit.MILLISECONDS);
    }

    /** Warns if a listener waits for readings although no script has called {@link #start}. */
    private void lookForSilence(SimulationSession session) {
        if (session != null && session.time() > TIMEOUT && host.isReadingHeard()) {
            silenceReported = true;
            host.warn("a listener waits for publishReading, but no reading is published: call "
                + "sear.startPublishing(sensor, readings per second); sensors: " + String.join(", ", readings.names()));
        }
    }

    private void guarded(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) {
            if (control.isRunning() && !e.toString().equals(lastFailure)) {
                lastFailure = e.toString();
                host.error("publishing failed: " + lastFailure);
            }
        }
    }

    /** @param rate readings per simulated second, above 0 to 60 */
    public void start(String name, double rate) {
        String sensor = ScriptText.of(name);
        if (!(rate > 0 && rate <= HIGHEST_RATE)) {
            throw new IllegalArgumentException("rate is " + rate + ", legal: above 0 to " + HIGHEST_RATE
                + " readings per second");
        }
        readings.check(sensor);
        started = true;
        subscriptions.put(sensor, new Schedule(rate));
    }

    /** Stops publishing a sensor's readings. */
    public void stop(String sensor) {
        subscriptions.remove(String.valueOf(ScriptText.of(sensor)));
    }

    private void look() {
        if (!PortClock.current().isLockStep()) {
            try {
                publishDue(() -> { });
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    /**
     * Publishes the due readings, in the order of the sensors' names. In lock-step the thread that advances time calls
     * it.
     *
     * @param published run after each reading
     */
    public void publishDue(SleepingThreads.Work published) throws InterruptedException {
        if (subscriptions.isEmpty() && !started && !silenceReported) {
            lookForSilence(control.sessionOrNull());
        }
        SimulationSession session = subscriptions.isEmpty() ? null : control.sessionOrNull();
        if (session == null) {
            return;
        }
        double now = session.time();
        for (Map.Entry<String, Schedule> entry : subscriptions.entrySet()) {
            if (entry.getValue().isDue(session, now)) {
                publish(entry.getKey(), now);
                published.run();
            }
        }
    }

    private void publish(String sensor, double now) {
        try {
            if (host.isImageHeard() && cameras.isCamera(sensor)) {
                host.image(sensor, cameras.png(sensor));
            }
            host.reading(new SensorReading(sensor, now, readings.any(sensor)));
        } catch (IllegalArgumentException e) {
            subscriptions.remove(sensor);
            host.warn("SEAR stops publishing readings: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Stops publishing; waits a while for a reading in progress. */
    public void finish() {
        timer.shutdown();
        subscriptions.clear();
        try {
            timer.awaitTermination(FINISH_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Interrupts a reading in progress. */
    public void close() {
        timer.shutdownNow();
    }
}
