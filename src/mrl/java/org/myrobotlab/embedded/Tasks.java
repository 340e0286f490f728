// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.embedded;

import java.util.Map;
import java.util.Timer;
import java.util.TimerTask;
import java.util.concurrent.ConcurrentHashMap;
import org.myrobotlab.framework.Message;

/** Timed messages of a service to itself. Any thread. */
final class Tasks {
    private final MessagedService service;
    private final Map<String, Timer> timers = new ConcurrentHashMap<>();

    Tasks(MessagedService service) {
        this.service = service;
    }

    Map<String, Timer> timers() {
        return timers;
    }

    void add(String name, boolean oneShot, long intervalMs, long delayMs, String method, Object... params) {
        if (timers.containsKey(name)) {
            service.info("already have task %s", name);
            return;
        }
        Timer timer = new Timer(service.getName() + "." + name, true);
        timers.put(name, timer);
        TimerTask task = new TimerTask() {
            @Override
            public void run() {
                if (oneShot) {
                    purge(name);
                }
                service.in(Message.createMessage(service.getName(), service.getName(), method, params));
            }
        };
        if (oneShot) {
            timer.schedule(task, delayMs);
        } else {
            timer.schedule(task, delayMs, intervalMs);
        }
    }

    void purge(String name) {
        Timer timer = timers.remove(name);
        if (timer != null) {
            timer.cancel();
        }
    }

    void purgeAll() {
        timers.keySet().forEach(this::purge);
    }
}
