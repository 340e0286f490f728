// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.clocks;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.atomic.AtomicInteger;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.framework.Message;
import org.myrobotlab.framework.Outbox;
import org.myrobotlab.framework.interfaces.MessageListener;
import org.myrobotlab.service.GPS;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;

/**
 * As fast as possible without lock-step, MyRobotLab's outboxes, which report more than 1024 messages, don't overrun. No
 * byte is lost, and no device counts as silent.
 */
@Category(Slow.class)
public class FullSpeedTest {
    private static final int OVERRUN = 1024;
    private static final double SECONDS = 20;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private final AtomicInteger most = new AtomicInteger();
    private SEAR sear;
    private Heard heard;

    @Before
    public void start() {
        System.setProperty("sear.headless", "true");
        TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("fastSear", "SEAR");
        heard = (Heard) Runtime.start("fastStatus", "Heard");
        sear.addListener("publishStatus", "fastStatus", "onStatus");
        sear.setLockStep(false);
        sear.setSpeed(Double.POSITIVE_INFINITY);
        sear.startSimulation();
    }

    @After
    public void release() {
        for (String name : new String[] {"fastLidar", "fastGps", "fastSear", "fastStatus"}) {
            Runtime.releaseService(name);
        }
        System.clearProperty("sear.project");
    }

    private void watch(String service) {
        Outbox outbox = Runtime.getService(service).getOutbox();
        outbox.addMessageListener(new MessageListener() {
            @Override
            public String getName() {
                return "watch of " + service;
            }

            @Override
            public void onMessage(Message msg) {
                most.accumulateAndGet(outbox.size(), Math::max);
            }
        });
    }

    @Test
    public void aReceiverIsNotReportedAsSilent() throws Exception {
        GPS gps = (GPS) Runtime.start("fastGps", "GPS");
        gps.addListener("publishStatus", "fastStatus", "onStatus");
        gps.connect(TestWorld.GPS_PORT);
        for (int i = 0; i < 20; i++) {
            sear.simSleep(50);
        }
        assertTrue(gps.getSentenceCount() + " sentences", gps.getSentenceCount() > 1000);
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString().contains("no data"));
    }

    @Test
    public void aScannerAtItsHighestRateOverrunsNoOutbox() throws Exception {
        LIDAR lidar = (LIDAR) Runtime.start("fastLidar", "LIDAR");
        lidar.addListener("publishStatus", "fastStatus", "onStatus");
        watch("fastLidar.serial");
        watch("scanner_LIDARsimulator_Serial_Service");
        lidar.connect(TestWorld.LIDAR_PORT, 38400);
        lidar.setBaud(500000);
        lidar.startStreaming();
        long deadline = System.nanoTime() + 60_000_000_000L;
        while (!lidar.isStreaming() && System.nanoTime() < deadline) {
            sear.simSleep(1);
        }
        assertTrue(heard.getStatuses().toString(), lidar.isStreaming());
        double start = sear.getTime();
        long before = lidar.getScanCount();
        sear.simSleep(SECONDS);
        double passed = sear.getTime() - start;
        assertTrue(most.get() + " messages waited", most.get() <= OVERRUN);
        assertTrue("some did wait, or this shows nothing", most.get() > 0);
        double scans = lidar.getScanCount() - before;
        assertTrue(scans + " scans in " + passed + " s", scans > 30 * SECONDS);
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString().contains("error"));
        assertEquals(181, lidar.getLastScan().raw.length);
    }
}
