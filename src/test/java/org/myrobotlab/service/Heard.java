// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.myrobotlab.codec.CodecUtils;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.Status;
import org.myrobotlab.service.config.ServiceConfig;

/** A service that stores values published by others, with calls to wait for them. */
public class Heard extends Service<ServiceConfig> {
    private static final long serialVersionUID = 1L;
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(60);

    private final transient List<Object> values = new ArrayList<>();
    private final transient List<String> statuses = new ArrayList<>();
    private final transient List<String> states = new ArrayList<>();

    /** Signature that MyRobotLab requires. */
    public Heard(String name, String id) {
        super(name, id);
    }

    /** Stores any published value. */
    public void onValue(Object value) {
        keep(values, value);
    }

    /** Stores a status of another service. */
    public void onStatus(Status status) {
        keep(statuses, status.level + ": " + status.detail);
    }

    /** Stores the state of another service as a panel sees it at that moment. */
    public void onState(Service<?> state) {
        keep(states, CodecUtils.toJson(state));
    }

    /**
     * Waits for a state with this text.
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

    /** Waits for this number of values and returns all so far. */
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
     * Waits for a value of this kind. Values published before a listener was added may arrive after it, because
     * services deliver from a queue.
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
     * @return whether it came
     */
    public boolean awaitStatus(String part) throws InterruptedException {
        return await(statuses, part);
    }

    /**
     * Waits for this number of statuses with this text.
     * @return whether they came
     */
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

    /** Returns all statuses so far. */
    public List<String> getStatuses() {
        synchronized (values) {
            return new ArrayList<>(statuses);
        }
    }
}
