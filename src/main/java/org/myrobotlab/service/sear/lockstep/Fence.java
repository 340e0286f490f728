// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.lockstep;

import java.util.HashMap;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Service;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.sear.Host;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Waits until MyRobotLab's services have processed their messages, so that in lock-step a script's callbacks have run
 * when simSleep returns.
 *
 * <p>Sends its own messages behind all others and waits for their return. The first go from each outbox straight to
 * SEAR. The next go through each inbox and ask the service to put a message into its outbox ({@code out(Message)}),
 * again for SEAR. Python has a separate queue of callbacks; there the fence sends the callback
 * {@code _sear_fence.passed(pass)}, where {@code _sear_fence} is a global variable of the script. Messages from
 * callbacks pass the queues again, so the fence repeats this until two rounds in a row find empty queues.
 *
 * <p>One thread at a time may wait. The fence does not wait for a service whose thread itself waits for simulated time,
 * in a callback that sleeps.
 */
public final class Fence {
    /** SEAR's method for messages that return from an outbox. */
    public static final String CALLBACK = "onFence";

    private static final long LOOK_MILLIS = 1;
    private static final int CLEAN_ROUNDS = 2;
    /**
     * Constants: Python names the variables of a callback's arguments after sender and method, and compiles the call
     * once.
     */
    private static final String SENDER = "sear";
    private static final String SENDING = "fence";
    private static final String VARIABLE = "_sear_fence";

    private static final Logger log = LoggerFactory.getLogger(Fence.class);

    private final Host host;
    private final SleepingThreads sleepers;
    /** Callback thread by service, learned from its passes. */
    private final Map<ServiceInterface, Thread> handlers = new ConcurrentHashMap<>();
    /** Overdue pass by outbox or service. */
    private final Map<Object, FencePass> late = new HashMap<>();
    private final Map<ServiceInterface, FencePass> greetings = new HashMap<>();
    private boolean reportedOfWaiting;
    private boolean reportedOfGoingOn;

    Fence(Host host, SleepingThreads sleepers) {
        this.host = host;
        this.sleepers = sleepers;
    }

    /** Learns the threads of Python's callbacks: sends a pass without waiting for it. */
    synchronized void greet() {
        for (ServiceInterface service : Runtime.getServices()) {
            if (service instanceof Python && service.isRunning() && !handlers.containsKey(service)) {
                greetings.put(service, sendToPython(service));
            }
        }
    }

    /** Waits; returns immediately without listeners. */
    synchronized void await() throws InterruptedException {
        long end = System.nanoTime() + Timeouts.nanos(Timeouts.END);
        int clean = 0;
        while (clean < CLEAN_ROUNDS && System.nanoTime() < end) {
            ServiceQueues queues = new ServiceQueues(host.getName());
            boolean held = queues.hold();
            round(queues, end);
            clean = held || queues.hold() ? 0 : clean + 1;
        }
    }

    private void round(ServiceQueues queues, long end) throws InterruptedException {
        Map<Object, FencePass> out = new HashMap<>();
        for (ServiceInterface service : queues.getPublishers()) {
            if (isOnTime(service.getOutbox())) {
                FencePass pass = new FencePass();
                service.getOutbox().add(back(pass));
                out.put(service.getOutbox(), pass);
            }
        }
        await(out, end);
        Map<Object, FencePass> through = new HashMap<>();
        for (ServiceInterface service : queues.getReceivers()) {
            if (isOnTime(service) && !isHeld(service)) {
                through.put(service, hasCallbacks(service) ? sendToPython(service) : sendThrough(service));
            }
        }
        await(through, end);
    }

    private Message back(FencePass pass) {
        return Message.createMessage(SENDER, host.getName(), CALLBACK, pass);
    }

    private FencePass sendThrough(ServiceInterface service) {
        FencePass pass = new FencePass();
        service.in(Message.createMessage(SENDER, service.getName(), "out", back(pass)));
        return pass;
    }

    /** Returns whether the service runs callbacks on a separate thread. */
    private static boolean hasCallbacks(ServiceInterface service) {
        return service instanceof Python || service instanceof CallbackService;
    }

    private static FencePass sendToPython(ServiceInterface python) {
        FencePass pass = new FencePass();
        if (python instanceof Python) {
            ((Python) python).set(VARIABLE, FencePass.class);
        }
        Message msg = Message.createMessage(SENDER, python.getName(), VARIABLE + ".passed", pass);
        msg.sendingMethod = SENDING;
        python.in(msg);
        return pass;
    }

    private boolean isOnTime(Object queue) {
        FencePass pass = late.get(queue);
        if (pass != null && pass.isBack()) {
            late.remove(queue);
        }
        return pass == null || pass.isBack();
    }

    private void await(Map<Object, FencePass> passes, long end) throws InterruptedException {
        for (Map.Entry<Object, FencePass> entry : passes.entrySet()) {
            FencePass pass = entry.getValue();
            while (!pass.await(LOOK_MILLIS) && !isHeld(entry.getKey()) && !isReleased(entry.getKey())) {
                long left = end - System.nanoTime();
                if (left < 0) {
                    late.put(entry.getKey(), pass);
                    reportOfGoingOn(entry.getKey());
                    break;
                } else if (left < Timeouts.nanos(Timeouts.END - Timeouts.WORD)) {
                    reportOfWaiting();
                }
            }
            if (pass.isBack() && entry.getKey() instanceof Python) {
                handlers.put((Python) entry.getKey(), pass.getHandler());
            }
        }
    }

    /** Returns whether the queue's service has ended and can't answer. */
    private static boolean isReleased(Object queue) {
        return queue instanceof ServiceInterface && !((ServiceInterface) queue).isRunning();
    }

    private void reportOfWaiting() {
        if (!reportedOfWaiting) {
            reportedOfWaiting = true;
            host.warn(busy(Timeouts.WORD) + Timeouts.waits());
        }
    }

    private void reportOfGoingOn(Object queue) {
        log.debug("no pass came back from {}", queue);
        if (!reportedOfGoingOn) {
            reportedOfGoingOn = true;
            host.warn(busy(Timeouts.END) + ": lock-step continues and ignores callbacks of that service until "
                + "this one ends");
        }
    }

    private static String busy(long seconds) {
        return "a callback has been busy for more than " + seconds + " s";
    }

    /** Returns whether the service is blocked until the present thread or simulated time continues. */
    private boolean isHeld(Object queue) {
        if (!(queue instanceof Service)) {
            return false;
        }
        Service<?> service = (Service<?>) queue;
        FencePass greeting = greetings.get(service);
        if (greeting != null && greeting.isBack()) {
            handlers.put(service, greeting.getHandler());
            greetings.remove(service);
        }
        return holds(service instanceof CallbackService ? ((CallbackService) service).getCallbackThread()
            : handlers.get(service)) || holds(service.getThisThread());
    }

    private boolean holds(Thread thread) {
        return thread != null && (thread == Thread.currentThread() || sleepers.sleeps(thread));
    }
}
