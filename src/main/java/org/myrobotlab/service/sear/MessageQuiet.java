package org.myrobotlab.service.sear;

import java.lang.reflect.Field;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.myrobotlab.framework.interfaces.ServiceInterface;
import org.myrobotlab.service.Runtime;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Waits until MyRobotLab's services have dealt with their messages, so that in lock-step a script's callbacks have run when simSleep returns.
 * MyRobotLab has no call for that: this looks at the queues, and at whether the threads that empty them rest.
 */
final class MessageQuiet {
    private static final long PATIENCE = TimeUnit.SECONDS.toNanos(2);
    private static final long LOOK = TimeUnit.MICROSECONDS.toNanos(20);
    private static final int LOOKS_IN_A_ROW = 3;
    /** What follows a service's name in the names of such threads, in the real and in the embedded MyRobotLab. */
    private static final List<String> THREADS = Arrays.asList("_outbox", ".input", "_callbacks");
    private static final List<String> CALLBACK_QUEUES = Arrays.asList("inputQueue", "callbacks");

    private static final Logger log = LoggerFactory.getLogger(MessageQuiet.class);
    private static final String PYTHON = "org.myrobotlab.service.Python";

    private final Host host;
    private final Callers callers;
    private volatile boolean givenUp;

    MessageQuiet(Host host, Callers callers) {
        this.host = host;
        this.callers = callers;
    }

    /** At once on a thread that itself deals with messages: what waits behind it can't move. Gives up for good, with a warning, on a busy one. */
    void await() {
        if (givenUp) {
            return;
        }
        List<ServiceInterface> services = new ArrayList<>(Runtime.getServices());
        List<Thread> threads = threads(services);
        if (threads.contains(Thread.currentThread())) {
            return;
        }
        long end = System.nanoTime() + PATIENCE;
        for (int quiet = 0; quiet < LOOKS_IN_A_ROW;) {
            quiet = isQuiet(services, threads) ? quiet + 1 : 0;
            if (quiet == 0) {
                LockSupport.parkNanos(LOOK);
            }
            if (System.nanoTime() > end) {
                givenUp = true;
                host.warn("a callback has been busy for more than " + TimeUnit.NANOSECONDS.toSeconds(PATIENCE)
                    + " s: lock-step no longer waits for callbacks");
                return;
            }
        }
    }

    private boolean isQuiet(List<ServiceInterface> services, List<Thread> threads) {
        if (callers.areAsking()) {
            return false;
        }
        boolean oneSleeps = threads.stream().anyMatch(callers::sleeps);
        return (oneSleeps || areEmpty(services)) && threads.stream().allMatch(thread -> callers.sleeps(thread) || rests(thread));
    }

    private static boolean areEmpty(List<ServiceInterface> services) {
        for (ServiceInterface service : services) {
            if (service.getOutbox() != null && service.getOutbox().size() > 0 || service.getInbox() != null && service.getInbox().size() > 0
                    || callbacksWaiting(service)) {
                return false;
            }
        }
        return true;
    }

    private static boolean rests(Thread thread) {
        Thread.State state = thread.getState();
        return state != Thread.State.RUNNABLE && state != Thread.State.BLOCKED;
    }

    /** The Python service keeps its callbacks in a queue of its own, which has no public face. */
    private static boolean callbacksWaiting(ServiceInterface service) {
        if (!PYTHON.equals(service.getClass().getName())) {
            return false;
        }
        for (Field field : service.getClass().getDeclaredFields()) {
            if (CALLBACK_QUEUES.contains(field.getName()) && !isEmpty(field, service)) {
                return true;
            }
        }
        return false;
    }

    private static boolean isEmpty(Field field, Object owner) {
        try {
            field.setAccessible(true);
            Object queue = field.get(owner);
            return !(queue instanceof Collection) || ((Collection<?>) queue).isEmpty();
        } catch (ReflectiveOperationException | RuntimeException e) {
            log.debug("Python's queue of callbacks can't be seen: its thread alone is looked at", e);
            return true;
        }
    }

    /** The threads that deal with messages: each service's own, its outbox's, and that of Python's callbacks. */
    private static List<Thread> threads(List<ServiceInterface> services) {
        Set<String> names = new HashSet<>();
        services.forEach(service -> names.add(service.getName()));
        ThreadGroup root = Thread.currentThread().getThreadGroup();
        while (root.getParent() != null) {
            root = root.getParent();
        }
        Thread[] all = new Thread[2 * root.activeCount() + 10];
        int count = root.enumerate(all);
        List<Thread> found = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            if (names.contains(owner(all[i].getName()))) {
                found.add(all[i]);
            }
        }
        return found;
    }

    private static String owner(String thread) {
        for (String suffix : THREADS) {
            int at = thread.indexOf(suffix);
            if (at > 0) {
                return thread.substring(0, at);
            }
        }
        return thread;
    }
}
