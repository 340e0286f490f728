// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.PortListener;
import org.myrobotlab.service.Python;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/**
 * Lock-step waits for threads without CPU time for many seconds, as on a busy machine, and continues without hanging
 * ones.
 */
@Category(Slow.class)
public class PatienceTest {
    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Python python;
    private SEAR sear;
    private LIDAR lidar;
    private Heard heard;

    /**
     * Blocks the thread that delivers bytes until lock-step reports that it waits, like a machine without CPU time for
     * that thread.
     */
    public static class Starved extends PortListener {
        private static final long serialVersionUID = 1L;
        private transient volatile Heard heard;
        private transient volatile boolean held;

        public Starved(String name, String id) {
            super(name, id);
        }

        @Override
        public void onBytes(byte[] bytes) {
            if (heard == null || held) {
                return;
            }
            try {
                held = heard.awaitStatus("within 5 s: lock-step waits for it");
            } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
            }
        }
    }

    @Before
    public void start() throws Exception {
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("python", "Python");
        sear = (SEAR) Runtime.start("patientSear", "SEAR");
        heard = (Heard) Runtime.start("patienceStatus", "Heard");
        sear.addListener("publishStatus", "patienceStatus", "onStatus");
        lidar = (LIDAR) Runtime.start("patienceLidar", "LIDAR");
    }

    private void connect() throws Exception {
        sear.setLockStep(true);
        sear.startSimulation();
        lidar.connect(TestWorld.LIDAR_PORT, 38400);
        sear.simSleep(3);
    }

    @Test
    public void aScanIsNotLostWhileItsThreadGetsNoCpuTime() throws Exception {
        Starved starved = (Starved) Runtime.start("starved", Starved.class.getName());
        ((Serial) Runtime.getService("patienceLidar.serial")).addByteListener(starved);
        connect();
        starved.heard = heard;
        lidar.singleScan();
        sear.simSleep(10);
        assertTrue("the thread was kept", starved.held);
        assertEquals("one question, one scan", 1, lidar.getScanCount());
        assertNull(lidar.getLastError());
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString().contains("continues without it"));
    }

    @Test
    public void aHangingCallbackIsSkippedAndAwaitedAgainAfterItsEnd() throws Exception {
        CountDownLatch hang = new CountDownLatch(1);
        python.set("hang", hang);
        python.set("seen", new ArrayList<>());
        assertTrue(python.exec("def hangingScan(data):\n    hang.await()\n    seen.append(len(data))"));
        connect();
        lidar.addListener("publishLidarData", "python", "hangingScan");
        lidar.singleScan();
        sear.simSleep(1);
        assertTrue(heard.awaitStatus("warn: a callback has been busy for more than 5 s: lock-step waits for it, "
            + "60 s at most"));
        assertTrue(heard.awaitStatus("warn: a callback has been busy for more than 60 s: lock-step continues"));
        assertEquals("[]", String.valueOf(python.get("seen")));
        hang.countDown();
        assertTrue(String.valueOf(python.getLastError()), python.exec(String.join("\n",
            "import time",
            "end = time.time() + 60",
            "while not seen and time.time() < end: time.sleep(0.01)")));
        for (int scans = 2; scans < 5; scans++) {
            lidar.singleScan();
            sear.simSleep(1);
            assertEquals(scans, ((List<?>) python.get("seen")).size());
        }
    }
}
