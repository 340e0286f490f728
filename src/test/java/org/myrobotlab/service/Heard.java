package org.myrobotlab.service;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;
import org.myrobotlab.service.config.ServiceConfig;

/** A service that keeps what others publish to it, to be waited for. */
public class Heard extends Service<ServiceConfig> {
    private static final long serialVersionUID = 1L;
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    private final transient List<Object> values = new ArrayList<>();
    private final transient List<String> statuses = new ArrayList<>();
    private final transient List<String> states = new ArrayList<>();

    /** As MyRobotLab makes services. */
    public Heard(String name, String id) {
        super(name, id);
    }

    /** Any published value. */
    public void onValue(Object value) {
        keep(values, value);
    }

    /** A status of another service. */
    public void onStatus(Status status) {
        keep(statuses, status.level + ": " + status.detail);
    }

    /** The state of another service, as a panel sees it at that moment. */
    public void onState(Service<?> state) {
        keep(states, CodecUtils.toJson(state));
    }

    /**
     * Waits for a state with this text.
     *
     * @return whether it came
     */
    public boolean awaitState(String part) throws InterruptedException {
        return await(states, part);
    }

    private <T> void keep(List<T> list, T value) {
        synchronized (values) {
            list.add(value);
            values.notifyAll();
        }
    }

    /** The values so far, at least that many. */
    public List<Object> await(int count) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        synchronized (values) {
            while (values.size() < count && System.nanoTime() < end) {
                values.wait(50);
            }
            return new ArrayList<>(values);
        }
    }

    /**
     * Waits for a value of this kind: what was said before a listener was added may come after it, for services deliver from a queue.
     *
     * @return whether it came
     */
    public boolean awaitValue(Predicate<Object> kind) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        synchronized (values) {
            while (values.stream().noneMatch(kind) && System.nanoTime() < end) {
                values.wait(50);
            }
            return values.stream().anyMatch(kind);
        }
    }

    /**
     * Waits for a status with this text.
     *
     * @return whether it came
     */
    public boolean awaitStatus(String part) throws InterruptedException {
        return await(statuses, part);
    }

    /** Whether so many of them come. */
    public boolean awaitStatus(String part, int times) throws InterruptedException {
        return await(statuses, part, times);
    }

    private boolean await(List<String> texts, String part) throws InterruptedException {
        return await(texts, part, 1);
    }

    private boolean await(List<String> texts, String part, int times) throws InterruptedException {
        long end = System.nanoTime() + PATIENCE;
        synchronized (values) {
            while (count(texts, part) < times && System.nanoTime() < end) {
                values.wait(50);
            }
            return count(texts, part) >= times;
        }
    }

    private static long count(List<String> texts, String part) {
        return texts.stream().filter(text -> text.contains(part)).count();
    }

    /** All statuses so far. */
    public List<String> getStatuses() {
        synchronized (values) {
            return new ArrayList<>(statuses);
        }
    }
}
