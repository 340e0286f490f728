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
 * Waits until MyRobotLab's services have dealt with their messages, so that in lock-step a script's callbacks have run when simSleep returns.
 *
 * <p>It sends messages of its own behind all others and waits until they come back: first out of each outbox, straight to SEAR; then through each
 * inbox, where the service is asked to put one into its outbox ({@code out(Message)}), again for SEAR. Python has a queue of its own for callbacks:
 * there a callback {@code _sear_fence.passed(pass)} is sent, which is a variable of that name in the script's globals. What a callback publishes
 * goes through the queues once more, so this is repeated until nothing waited in two rounds one after the other.
 *
 * <p>One thread at a time may wait. A service whose thread waits for simulated time itself, in a callback that sleeps, is not waited for.
 */
public final class Fence {
    /** SEAR's method for what comes back out of an outbox. */
    public static final String CALLBACK = "onFence";

    private static final long LOOK_MILLIS = 1;
    private static final int CLEAN_ROUNDS = 2;
    /** Python names the variables of a callback's arguments after sender and method, and compiles the call only once: these never change. */
    private static final String SENDER = "sear";
    private static final String SENDING = "fence";
    private static final String VARIABLE = "_sear_fence";

    private static final Logger log = LoggerFactory.getLogger(Fence.class);

    private final Host host;
    private final SleepingThreads sleepers;
    /** By service, the thread that its callbacks run on, as its passes have shown. */
    private final Map<ServiceInterface, Thread> handlers = new ConcurrentHashMap<>();
    /** By outbox or service, the pass that did not come back in time. */
    private final Map<Object, FencePass> late = new HashMap<>();
    private final Map<ServiceInterface, FencePass> greetings = new HashMap<>();
    private boolean reportedOfWaiting;
    private boolean reportedOfGoingOn;

    Fence(Host host, SleepingThreads sleepers) {
        this.host = host;
        this.sleepers = sleepers;
    }

    /** Learns on which threads Python runs callbacks: a pass is sent and not waited for. */
    synchronized void greet() {
        for (ServiceInterface service : Runtime.getServices()) {
            if (service instanceof Python && service.isRunning() && !handlers.containsKey(service)) {
                greetings.put(service, sendToPython(service));
            }
        }
    }

    /** At once if nobody listens. */
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

    /** Whether it carries out callbacks on a thread of its own, beside its messages. */
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

    /** Whether it is a service that has ended meanwhile, and answers no more. */
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
            host.warn(busy(Timeouts.END) + ": lock-step goes on and no longer waits for callbacks of that service until it ends");
        }
    }

    private static String busy(long seconds) {
        return "a callback has been busy for more than " + seconds + " s";
    }

    /** Whether the service can't move before the present thread goes on, or before simulated time does. */
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
        return holds(service instanceof CallbackService ? ((CallbackService) service).getCallbackThread() : handlers.get(service))
            || holds(service.getThisThread());
    }

    private boolean holds(Thread thread) {
        return thread != null && (thread == Thread.currentThread() || sleepers.sleeps(thread));
    }
}
