// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.util.List;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;
import org.myrobotlab.service.config.RuntimeConfig;

/** A MyRobotLab saved during a simulation starts without the simulation's own services and can simulate again. */
public class SavedSimulationTest {
    private static final String SET = "saved-simulation-test";
    private static final String UART = "scanner_LIDARsimulator_Serial_Service";

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    @Before
    public void start() {
        TestWorld.build(temporary.getRoot().toPath());
    }

    @After
    public void release() throws Exception {
        ServiceFolder.forgetConfig(SET);
    }

    private static void saveAndReleaseAndLoad() {
        assertTrue(Runtime.saveConfig(SET));
        Runtime.releaseService("savedLidar");
        Runtime.releaseService("savedSear");
        Runtime.startConfig(SET);
    }

    private static void simulateAndScan() throws Exception {
        SEAR sear = (SEAR) Runtime.start("savedSear", "SEAR");
        LIDAR lidar = (LIDAR) Runtime.start("savedLidar", "LIDAR");
        sear.startSimulation();
        lidar.connect(TestWorld.LIDAR_PORT, 38400);
        lidar.singleScan();
        sear.simSleep(1);
        assertNotNull(lidar.getLastScan());
    }

    @Test
    public void theSimulationsOwnServicesAreNotRestoredAndItSimulatesAgain() throws Exception {
        simulateAndScan();
        assertNotNull("it is in the registry all the same", Runtime.getService(UART));
        saveAndReleaseAndLoad();
        assertTrue(Runtime.isStarted("savedSear") && Runtime.isStarted("savedLidar"));
        assertNull(Runtime.getService(UART));
        assertEquals(38400, ((LIDAR) Runtime.getService("savedLidar")).getConfig().baud);
        simulateAndScan();
    }

    @Test
    public void oneThatWasSavedWithThemSimulatesAgainToo() throws Exception {
        simulateAndScan();
        RuntimeConfig runtime = Runtime.getInstance().getConfig();
        List<String> names = runtime.getRegistry();
        assertFalse(names.contains(UART));
        runtime.add(UART);
        saveAndReleaseAndLoad();
        assertNotNull("an old configuration brings it back", Runtime.getService(UART));
        simulateAndScan();
    }
}
