// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework;

import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import org.myrobotlab.service.config.ServiceConfig;

/** A service that publishes values on request and stores values that it receives. */
public class Talker extends Service<ServiceConfig> {
    private static final long serialVersionUID = 1L;
    private static final int PATIENCE_SECONDS = 120;

    /** Received values. */
    public final transient BlockingQueue<Object> heard = new LinkedBlockingQueue<>();
    private volatile boolean failing;
    private final transient Semaphore begun = new Semaphore(0);
    private final transient CountDownLatch end = new CountDownLatch(1);

    public Talker(String name, String id) {
        super(name, id);
    }

    /** Waits for the next received value. */
    Object next() throws InterruptedException {
        Object value = heard.poll(60, TimeUnit.SECONDS);
        if (value == null) {
            throw new AssertionError(getName() + " heard nothing for 60 s");
        }
        return value;
    }

    public Integer publishNumber(Integer number) {
        return number;
    }

    public int[] publishArray(int[] values) {
        return values;
    }

    public void publishNothing() {
        log.debug("nothing");
    }

    public void onNumber(Integer number) {
        heard.add(number);
    }

    public void other(Integer number) {
        heard.add("other " + number);
    }

    public void onArray(int[] values) {
        heard.add(values);
    }

    public void onCaller(String thread) {
        heard.add(thread);
    }

    public void onNothing() {
        heard.add("nothing");
    }

    public void onStatus(Status status) {
        heard.add(status);
    }

    public void onState(Service<?> state) {
        heard.add("state of " + state.getName());
    }

    public void onStarted(String name) {
        heard.add("started " + name);
    }

    public void onReleased(String name) {
        heard.add("released " + name);
    }

    /** A reading that GET may request, like SEAR's. */
    public String getReading(String name) {
        return "of " + name;
    }

    public double half(double value) {
        return value / 2;
    }

    /** A call that lasts until {@link #goOn}. */
    public void await() throws InterruptedException {
        begun.release();
        end.await();
    }

    /** Waits until this number of calls are in {@link #await}. */
    public void awaiting(int calls) throws InterruptedException {
        if (!begun.tryAcquire(calls, PATIENCE_SECONDS, TimeUnit.SECONDS)) {
            throw new AssertionError("only " + begun.availablePermits() + " of " + calls + " calls have begun");
        }
    }

    /** Ends all {@link #await}. */
    public void goOn() {
        end.countDown();
    }

    /** Returns a text of this length. */
    public String longText(int length) {
        begun.release();
        return "x".repeat(length);
    }

    public void tick() {
        heard.add("tick");
    }

    public void fail() {
        throw new IllegalStateException("no good");
    }

    public String whoCalls() {
        return Thread.currentThread().getName();
    }

    public void failInHook(boolean on) {
        failing = on;
    }

    @Override
    public boolean preProcessHook(Message msg) {
        if (failing) {
            throw new IllegalStateException("hook");
        }
        return true;
    }
}
