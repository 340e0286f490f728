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
 * Publishes readings and the state of the world again and again while a simulation runs: readings by simulated time, the state for panels by the
 * computer's. In lock-step readings are published by the thread that advances time. Any thread.
 */
public final class Publisher {
    private static final long LOOK_MILLIS = 10;
    private static final long STATE_MILLIS = 100;
    private static final long FINISH_SECONDS = 1;
    private static final double HIGHEST_RATE = 60;
    /** So long a listener may hear nothing, simulated s. */
    private static final double TIMEOUT = 2;

    private final SimulationControl control;
    private final ScriptReadings readings;
    private final ScriptCameras cameras;
    private final Host host;
    private volatile String lastFailure = "";
    private volatile boolean started;
    private volatile boolean silenceReported;
    private final Map<String, Subscription> subscriptions = new ConcurrentSkipListMap<>();
    private final ScheduledExecutorService timer = Executors.newSingleThreadScheduledExecutor(work -> {
        Thread thread = new Thread(work, "SEAR publisher");
        thread.setDaemon(true);
        return thread;
    });

    private static final class Subscription {
        private final double period;
        private double next;

        Subscription(double period) {
            this.period = period;
        }
    }

    /** Starts looking for what is due. */
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

    /** Who listens and has not said to what waits in vain. */
    private void lookForSilence(SimulationSession session) {
        if (session != null && session.time() > TIMEOUT && host.isReadingHeard()) {
            silenceReported = true;
            host.warn("something listens to publishReading, and no reading is published: sear.startPublishing(sensor, readings a second) begins;"
                + " there are the sensors " + String.join(", ", readings.names()));
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

    /** @param rate a second of simulated time, above 0 to 60 */
    public void start(String name, double rate) {
        String sensor = ScriptText.of(name);
        if (!(rate > 0 && rate <= HIGHEST_RATE)) {
            throw new IllegalArgumentException("rate is " + rate + ", legal: above 0 to " + HIGHEST_RATE + " readings a second");
        }
        readings.check(sensor);
        started = true;
        subscriptions.put(sensor, new Subscription(1 / rate));
    }

    /** Ends {@link #start}. */
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
     * Publishes the readings whose time has come, in the order of the sensors' names; the stepping thread calls it in lock-step.
     *
     * @param published run after each
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
        for (Map.Entry<String, Subscription> entry : subscriptions.entrySet()) {
            Subscription subscription = entry.getValue();
            if (now >= subscription.next || now < subscription.next - subscription.period) {
                subscription.next = now + subscription.period;
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
            host.warn("readings are no longer published: " + e.getMessage());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Publishes nothing more but what is in hand, and waits a while for that. */
    public void finish() {
        timer.shutdown();
        subscriptions.clear();
        try {
            timer.awaitTermination(FINISH_SECONDS, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    /** Ends what is in hand, too. */
    public void close() {
        timer.shutdownNow();
    }
}
