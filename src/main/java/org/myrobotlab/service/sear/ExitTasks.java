// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Tasks at the end of the process, such as deleting a link to a pseudo-terminal, which the system gives to another
 * program later. They run when Java ends, and in a Python program also when a signal ends it. A process that is killed
 * (SIGKILL) runs none. Any thread.
 */
public final class ExitTasks {
    private static final Logger LOG = LoggerFactory.getLogger(ExitTasks.class);
    private static final Set<Runnable> TASKS = new LinkedHashSet<>();

    static {
        Runtime.getRuntime().addShutdownHook(new Thread(ExitTasks::run, "exit tasks"));
        if (Boolean.getBoolean("sear.inPython")) {
            try {
                EndSignals.precede(ExitTasks::run);
            } catch (ReflectiveOperationException | LinkageError e) {
                LOG.warn("links to pseudo-terminals stay when a signal ends this program: {}", e.toString());
            }
        }
    }

    private ExitTasks() {
    }

    /** Adds a task. */
    public static void add(Runnable task) {
        synchronized (TASKS) {
            TASKS.add(task);
        }
    }

    /** Removes a task that is no longer necessary. */
    public static void remove(Runnable task) {
        synchronized (TASKS) {
            TASKS.remove(task);
        }
    }

    /** Runs and removes all tasks. Logs those that fail. */
    private static void run() {
        List<Runnable> tasks;
        synchronized (TASKS) {
            tasks = new ArrayList<>(TASKS);
            TASKS.clear();
        }
        for (Runnable task : tasks) {
            try {
                task.run();
            } catch (RuntimeException e) {
                LOG.warn("a task at the end of the program failed: {}", e.toString());
            }
        }
    }
}
