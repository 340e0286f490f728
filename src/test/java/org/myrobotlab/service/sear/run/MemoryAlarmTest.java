// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.run;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.Test;

/** One warning reports a nearly full heap. */
public class MemoryAlarmTest {
    private final List<String> told = new CopyOnWriteArrayList<>();
    private final CountDownLatch first = new CountDownLatch(1);

    private long thresholds() {
        return ManagementFactory.getMemoryPoolMXBeans().stream()
            .filter(pool -> pool.isCollectionUsageThresholdSupported())
            .filter(pool -> pool.getCollectionUsageThreshold() > 0).count();
    }

    /** The limit is so low that a few kilobytes fill the heap. */
    @Test
    public void itIsReportedOnceAfterACollection() throws Exception {
        byte[] old = new byte[4 << 20];
        MemoryAlarm alarm = new MemoryAlarm(1e-6, text -> {
            told.add(text);
            first.countDown();
        });
        alarm.open();
        try {
            for (int i = 0; i < 3; i++) {
                System.gc();
            }
            assertTrue("no word", first.await(60, TimeUnit.SECONDS));
            System.gc();
        } finally {
            alarm.close();
        }
        assertNotNull(old);
        assertEquals(told.toString(), 1, told.size());
        assertTrue(told.get(0), told.get(0)
            .matches("Java's memory is nearly full: \\d+ % of \\d+ MB are in use; start Java with more.*"));
        assertEquals("it is as before", 0, thresholds());
    }

    @Test
    public void aHeapWithFreeMemoryIsNotReported() {
        MemoryAlarm alarm = new MemoryAlarm(MemoryAlarm.NEARLY_FULL, told::add);
        alarm.open();
        assertTrue("it watches", thresholds() > 0);
        System.gc();
        alarm.close();
        assertEquals(List.of(), told);
    }
}
