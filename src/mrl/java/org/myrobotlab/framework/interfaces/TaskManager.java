// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.framework.interfaces;

import java.util.Map;
import java.util.Timer;

/** Calls its own methods at intervals. */
public interface TaskManager {
    /** Calls a method at intervals; the task has the method's name. */
    void addTask(long intervalMs, String method);

    /** Calls a method at intervals; the task has the method's name. */
    void addTask(long intervalMs, String method, Object... params);

    /** Calls a method at intervals. */
    void addTask(String taskName, long intervalMs, long delayMs, String method, Object... params);

    /** Calls a method once or at intervals. */
    void addTask(String taskName, boolean oneShot, long intervalMs, long delayMs, String method, Object... params);

    /** Calls a method once. */
    void addTaskOneShot(long delayMs, String method, Object... params);

    /** Whether there is a task of that name. */
    boolean containsTask(String taskName);

    /** All tasks. */
    Map<String, Timer> getTasks();

    /** Ends a task. */
    void purgeTask(String taskName);

    /** Ends all tasks. */
    void purgeTasks();
}
