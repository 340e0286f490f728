// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.FarEnd;
import org.myrobotlab.service.GPS;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.ServiceFolder;
import org.myrobotlab.service.TestWorld;

/**
 * Services at simulated ports reconnect when a simulation has these ports again, unless they were disconnected by a
 * call.
 */
@Category(Slow.class)
public class ReconnectTest {
    private static final String SET = "reconnected";
    private static final long PATIENCE = 60_000_000_000L;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private SEAR sear;
    private LIDAR lidar;
    private GPS gps;
    private Heard heard;

    @Before
    public void start() throws Exception {
        TestWorld.build(temporary.getRoot().toPath());
        heard = (Heard) Runtime.start("backStatus", "Heard");
        sear = (SEAR) Runtime.start("backSear", "SEAR");
        sear.startSimulation();
        lidar = (LIDAR) Runtime.start("backLidar", "LIDAR");
        lidar.addListener("publishStatus", "backStatus", "onStatus");
        lidar.connect(TestWorld.LIDAR_PORT, 38400);
        gps = (GPS) Runtime.start("backGps", "GPS");
        gps.connect(TestWorld.GPS_PORT);
    }

    @After
    public void release() throws Exception {
        ServiceFolder.forgetConfig(SET);
    }

    private void start(boolean lockStep) {
        sear.setLockStep(lockStep);
        sear.setSpeed(Double.POSITIVE_INFINITY);
        sear.startSimulation();
    }

    private void assertBothMeasure() {
        long deadline = System.nanoTime() + PATIENCE;
        while (!(lidar.isConnected() && gps.isConnected()) && System.nanoTime() < deadline) {
            sear.simSleep(0.1);
        }
        long sentences = gps.getSentenceCount();
        long scans = lidar.getScanCount();
        sear.simSleep(3);
        lidar.singleScan();
        do {
            sear.simSleep(1); // by the clock the bytes also take real time
        } while ((lidar.getScanCount() == scans || gps.getSentenceCount() == sentences)
            && System.nanoTime() < deadline);
        assertTrue(lidar.isConnected() && gps.isConnected());
        assertEquals("scans; said: " + heard.getStatuses(), scans + 1, lidar.getScanCount());
        assertTrue(gps.getSentenceCount() > sentences);
    }

    private void saveReleaseAndLoad() {
        assertTrue(Runtime.saveConfig(SET));
        sear.stopSimulation();
        for (String name : new String[] {"backLidar", "backGps", "backSear"}) {
            Runtime.releaseService(name);
        }
        Runtime.startConfig(SET);
        sear = (SEAR) Runtime.getService("backSear");
        lidar = (LIDAR) Runtime.getService("backLidar");
        gps = (GPS) Runtime.getService("backGps");
    }

    @Test
    public void servicesOfARestoredConfigurationConnectAndReportItWhenTheirPortsAppear() throws Exception {
        gps.addListener("publishStatus", "backStatus", "onStatus");
        saveReleaseAndLoad();
        assertFalse(lidar.isConnected() || gps.isConnected());
        assertTrue(heard.awaitStatus("there is no port " + TestWorld.LIDAR_PORT + ": backLidar connects to it as soon "
            + "as a simulation has it"));
        assertTrue(heard.awaitStatus("there is no port " + TestWorld.GPS_PORT + ": backGps connects to it"));
        for (String peer : new String[] {"backLidar.serial", "backGps.serial"}) {
            assertNull(peer + " leaves that to them", Runtime.getService(peer).getLastError());
        }
        sear.startSimulation();
        assertBothMeasure();
    }

    private String unitOfANewDevice() {
        sear.startSimulation();
        sear.simSleep(20);
        lidar.singleScan();
        sear.simSleep(1);
        return lidar.getLastScan().unit;
    }

    @Test
    public void theUnitIsRestoredAndSetOnTheDevice() throws Exception {
        lidar.setToCM();
        sear.simSleep(20);
        assertEquals("cm", lidar.getUnit());
        saveReleaseAndLoad();
        assertEquals("cm", lidar.getConfig().unit);
        assertEquals("cm", unitOfANewDevice());
        sear.stopSimulation();
        lidar.getConfig().unit = null;
        assertEquals("mm", unitOfANewDevice());
        lidar.setToCM();
        sear.simSleep(20);
        lidar.setToMM();
        sear.simSleep(20);
        assertEquals("mm", lidar.getUnit());
        assertEquals("mm", lidar.getConfig().unit);
    }

    @Test
    public void afterStopAndStartAllAreConnectedAgain() throws Exception {
        Serial serial = (Serial) Runtime.start("backSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        for (boolean lockStep : new boolean[] {true, false, true}) {
            sear.stopSimulation();
            long lost = System.nanoTime() + PATIENCE;    // in real time the services' own threads notice it
            while ((lidar.isConnected() || gps.isConnected() || serial.isConnected()) && System.nanoTime() < lost) {
                Thread.yield();
            }
            assertFalse(lidar.isConnected() || gps.isConnected() || serial.isConnected());
            start(lockStep);
            assertBothMeasure();
            assertTrue(serial.isConnected());
            assertEquals(57600, serial.getRate());
            serial.write(FarEnd.bytes("80 83 8E 07"));
            long deadline = System.nanoTime() + PATIENCE;
            do {
                sear.simSleep(1);
            } while (serial.available() == 0 && System.nanoTime() < deadline);
            assertTrue("the Roomba's answer", serial.available() > 0);
            serial.read(serial.available());
        }
    }

    @Test
    public void disconnectedOrReleasedServicesDoNotReconnect() throws Exception {
        Serial serial = (Serial) Runtime.start("backSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        lidar.disconnect();
        sear.stopSimulation();
        gps.disconnect();
        Runtime.releaseService("backSerial");
        sear.startSimulation();
        sear.simSleep(1);
        assertFalse(lidar.isConnected() || gps.isConnected() || serial.isConnected());
        assertNull(Runtime.getService("backSerial"));
    }

    /**
     * In lock-step the first to connect gets the port; by the clock the old services have it again before the script
     * connects.
     */
    @Test
    public void reconnectedServicesYieldToConnectCalls() throws Exception {
        for (boolean lockStep : new boolean[] {true, false}) {
            Serial serial = (Serial) Runtime.start("backSerial", "Serial");
            serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
            lidar.connect(TestWorld.LIDAR_PORT, 38400);
            sear.stopSimulation();
            start(lockStep);
            sear.simSleep(1);
            assertTrue(lidar.isConnected() && serial.isConnected());
            LIDAR other = (LIDAR) Runtime.start("otherLidar", "LIDAR");
            other.connect(TestWorld.LIDAR_PORT, 38400);
            Serial otherSerial = (Serial) Runtime.start("otherSerial", "Serial");
            otherSerial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
            assertFalse(lidar.isConnected() || serial.isConnected());
            LIDAR first = lidar;
            lidar = other;
            assertBothMeasure();
            lidar = first;
            assertThrows("who has connected by a call stays", IOException.class,
                () -> lidar.connect(TestWorld.LIDAR_PORT, 38400));
            Runtime.releaseService("otherLidar");
            Runtime.releaseService("otherSerial");
            Runtime.releaseService("backSerial");
        }
    }

    @Test
    public void servicesDoNotReconnectToAnotherProject() throws Exception {
        sear.stopSimulation();
        sear.newProject();
        TestWorld.build(temporary.newFolder().toPath());
        sear.startSimulation();
        sear.simSleep(1);
        assertFalse(lidar.isConnected() || gps.isConnected());
    }
}
