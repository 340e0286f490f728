// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.util.concurrent.TimeUnit;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.framework.Service;
import org.myrobotlab.service.config.ServiceConfig;
import org.myrobotlab.service.lidar.RangeScan;

/**
 * In lock-step, simSleep returns after all callbacks have run, regardless of their threads' names and the number of
 * services in their chain.
 */
public class FenceTest {
    private static final String LIDAR_SCRIPT = String.join("\n",
        "sear = Runtime.start('sear', 'SEAR')",
        "sear.startSimulation()",
        "lidar = Runtime.start('fenceLidar', 'LIDAR')",
        "lidar.connect('" + TestWorld.LIDAR_PORT + "', 38400)",
        "seen = []", "");

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Python python;
    private Heard heard;

    /** Forwards received values from its message thread to its listeners. */
    public static class Relay extends Service<ServiceConfig> {
        private static final long serialVersionUID = 1L;

        public Relay(String name, String id) {
            super(name, id);
        }

        public void onScan(RangeScan scan) {
            Thread.yield();
            invoke("publishLength", scan.raw.length);
        }

        public Integer publishLength(Integer length) {
            return length;
        }
    }

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
        python = (Python) Runtime.start("python", "Python");
        SEAR sear = (SEAR) Runtime.start("sear", "SEAR");
        heard = (Heard) Runtime.start("fenceStatus", "Heard");
        sear.addListener("publishStatus", "fenceStatus", "onStatus");
    }

    private void run(String... lines) {
        boolean ran = python.exec(LIDAR_SCRIPT + String.join("\n", lines));
        assertTrue(String.valueOf(python.getLastError()), ran);
    }

    private static void renameThreads(String part) {
        int count = 0;
        for (Thread thread : Thread.getAllStackTraces().keySet()) {
            if (thread.getName().startsWith(part)) {
                thread.setName("anonymous " + count++);
            }
        }
        assertTrue(part, count > 0);
    }

    @Test
    public void aSlowCallbackHasRunRegardlessOfItsThreadsName() {
        renameThreads("python");
        run("import time",
            "def fenceSlow(data):",
            "    time.sleep(0.05)",
            "    seen.append(len(data))",
            "lidar.addListener('publishLidarData', python.getName(), 'fenceSlow')",
            "for i in range(5):",
            "    lidar.singleScan()",
            "    sear.simSleep(1)",
            "    assert seen == [181] * (i + 1), seen");
    }

    @Test
    public void aCallbackAtTheEndOfAChainOfServicesHasRun() {
        Runtime.start("relay", Relay.class.getName());
        run("relay = Runtime.getService('relay')",
            "lidar.addListener('publishScan', 'relay')",
            "def fenceLength(n):",
            "    seen.append(n)",
            "relay.addListener('publishLength', python.getName(), 'fenceLength')",
            "for i in range(20):",
            "    lidar.singleScan()",
            "    sear.simSleep(0.5)",
            "    assert seen == [181] * (i + 1), (i, seen)");
    }

    @Test
    public void callbacksMaySleepInSimulatedTimeAndAskTheSimulation() throws Exception {
        run("def fenceSleeper(data):",
            "    before = sear.getTime()",
            "    sear.getPose('roomba')",
            "    sear.simSleep(0.5)",
            "    sear.step(3)",
            "    seen.append(round(60 * (sear.getTime() - before)))",
            "lidar.addListener('publishLidarData', python.getName(), 'fenceSleeper')",
            "lidar.singleScan()",
            "sear.simSleep(3)",
            "assert seen == [33], seen");
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString().contains("no longer waits"));
    }

    @Test
    public void itLeavesNoEntriesInMyRobotLabsLists() throws Exception {
        run("lidar.addListener('publishLidarData', python.getName(), 'fenceQuiet')",
            "def fenceQuiet(data): seen.append(1)",
            "lidar.singleScan()",
            "sear.simSleep(1)",
            "assert seen == [1]");
        SEAR sear = (SEAR) Runtime.getService("sear");
        assertEquals("[fenceStatus]", sear.getAttached().toString());
        assertEquals("[python]", Runtime.getService("fenceLidar").getAttached().toString().replaceAll("@\\w+", ""));
        assertTrue(TimeUnit.SECONDS.toMillis(1) > python.getInbox().size());
    }
}
