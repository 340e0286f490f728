// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.life;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import java.util.stream.Stream;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.TestWorld;
import org.myrobotlab.service.config.RuntimeConfig;

/** A MyRobotLab saved during a simulation starts without the simulation's own services and can simulate again. */
public class SavedSimulationTest {
    private static final String SET = "saved-simulation-test";
    private static final String UART = "scanner_LIDARsimulator_Serial_Service";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    @Before
    public void start() {
        System.setProperty("sear.headless", "true");
        System.setProperty("sear.speed", "max");
        TestWorld.build(temporary.getRoot().toPath());
    }

    @After
    public void release() throws Exception {
        for (String name : new String[] {"savedLidar", "savedSear", UART}) {
            Runtime.releaseService(name);
        }
        Runtime.setConfig("default");
        System.clearProperty("sear.project");
        System.clearProperty("sear.speed");
        Path folder = Paths.get(Runtime.ROOT_CONFIG_DIR, SET);
        try (Stream<Path> files = Files.list(folder)) {
            for (Path file : (Iterable<Path>) files::iterator) {
                Files.delete(file);
            }
        }
        Files.delete(folder);
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
