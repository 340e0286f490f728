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
 * Says once that Java's memory is nearly full after a collection of what nobody needs. So a user hears of it where somebody else's thread catches the
 * error that follows, as threads of the real MyRobotLab do. Collectors that can't be asked are left alone, and so are thresholds that another part of
 * the program has set. Any thread; the listener is called on a thread of Java's.
 */
final class MemoryAlarm implements NotificationListener {
    /** Part of the heap that is nearly all. */
    static final double NEARLY_FULL = 0.95;
    private static final double MEGABYTE = 1 << 20;
    private static final double PERCENT = 100;

    private final double part;
    private final Consumer<String> listener;
    private final List<MemoryPoolMXBean> pools = new ArrayList<>();
    private boolean reported;

    /** @param part of the heap, 0 to 1 */
    MemoryAlarm(double part, Consumer<String> listener) {
        this.part = part;
        this.listener = listener;
    }

    /** Begins to watch. */
    synchronized void open() {
        for (MemoryPoolMXBean pool : ManagementFactory.getMemoryPoolMXBeans()) {
            // where objects grow old: pools of young ones have no threshold of usage
            boolean lasting = pool.getType() == MemoryType.HEAP && pool.isUsageThresholdSupported() && pool.isCollectionUsageThresholdSupported();
            if (lasting && pool.getUsage().getMax() > 0 && pool.getCollectionUsageThreshold() == 0) {
                pool.setCollectionUsageThreshold((long) (pool.getUsage().getMax() * part));
                pools.add(pool);
            }
        }
        if (!pools.isEmpty()) {
            emitter().addNotificationListener(this, null, null);
        }
    }

    /** Ends it. */
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
        listener.accept(String.format(Locale.ROOT, "Java's memory is nearly full: %.0f %% of %.0f MB are in use; start Java with more (-Xmx), or"
            + " make the world or what the script keeps smaller", PERCENT * heap.getUsed() / heap.getMax(), heap.getMax() / MEGABYTE));
    }
}
