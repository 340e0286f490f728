// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import java.lang.management.ManagementFactory;
import java.lang.management.MemoryNotificationInfo;
import java.lang.management.MemoryPoolMXBean;
import java.lang.management.MemoryType;
import java.lang.management.MemoryUsage;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import javax.management.ListenerNotFoundException;
import javax.management.Notification;
import javax.management.NotificationEmitter;
import javax.management.NotificationListener;

/**
 * Reports once that Java's memory is nearly full after a garbage collection. The warning reaches the user even if a
 * foreign thread catches the later error, as threads of the real MyRobotLab do. Skips collectors without thresholds and
 * thresholds that other code has set. Any thread; calls the listener on a thread of Java.
 */
final class MemoryAlarm implements NotificationListener {
    /** Fraction of the heap that counts as nearly full. */
    static final double NEARLY_FULL = 0.95;
    private static final double MEGABYTE = 1 << 20;
    private static final double PERCENT = 100;

    private final double part;
    private final Consumer<String> listener;
    private final List<MemoryPoolMXBean> pools = new ArrayList<>();
    private boolean reported;

    /** @param part fraction of the heap, 0 to 1 */
    MemoryAlarm(double part, Consumer<String> listener) {
        this.part = part;
        this.listener = listener;
    }

    /** Starts watching. */
    synchronized void open() {
        for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
            // Pools of old objects; pools of young objects support no usage threshold.
            boolean lasting = pool.getType() == MemoryType.HEAP && pool.isUsageThresholdSupported()
                && pool.isCollectionUsageThresholdSupported();
            if (lasting && pool.getUsage().getMax() > 0 && pool.getCollectionUsageThreshold() == 0) {
                pool.setCollectionUsageThreshold((long) (pool.getUsage().getMax() * part));
                pools.add(pool);
            }
        }
        if (!pools.isEmpty()) {
            emitter().addNotificationListener(this, null, null);
        }
    }

    /** Stops watching. */
    synchronized void close() {
        if (pools.isEmpty()) {
            return;
        }
        pools.forEach(pool -> pool.setCollectionUsageThreshold(0));
        pools.clear();
        try {
            emitter().removeNotificationListener(this);
        } catch (ListenerNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    private static NotificationEmitter emitter() {
        return (NotificationEmitter) ManagementFactory.getMemoryMXBean();
    }

    @Override
    public void handleNotification(Notification notification, Object unused) {
        if (!notification.getType().equals(MemoryNotificationInfo.MEMORY_COLLECTION_THRESHOLD_EXCEEDED)) {
            return;
        }
        synchronized (this) {
            if (reported || pools.isEmpty()) {
                return;
            }
            reported = true;
        }
        MemoryUsage heap = ManagementFactory.getMemoryMXBean().getHeapMemoryUsage();
        listener.accept(String.format(Locale.ROOT, "Java's memory is nearly full: %.0f %% of %.0f MB are in use; start "
            + "Java with more (-Xmx), or"
            + " use a smaller world or store less in the script", PERCENT * heap.getUsed() / heap.getMax(),
                heap.getMax() / MEGABYTE));
    }
}
