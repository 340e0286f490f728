// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.util.HashMap;
import java.util.Map;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.FarEnd;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.Serial;
import org.myrobotlab.service.lidar.RangeScan;

/** The LIDAR service with a device that answers as in the telegram listing. */
@Category(Slow.class)
public class LidarServiceTest {
    private static final String PORT = "/dev/test_lidar";
    private static final String CONFIGURATION = "02 80 24 00 F4 00 00 70 00 00 00 01 00 00 02 02" + " 00".repeat(21)
        + " 02 00 10 3C FB";
    private static final String CM_WRITTEN = "02 80 25 00 F7 01 00 00 70 00 00 00 00 00 00 02 02" + " 00".repeat(21)
        + " 02 00 10 65 1A";
    private static final String STATUS = status("25", "8A 56");
    private static final String MODE_TAKEN = "06 02 80 03 00 A0 00 10 16 0A";
    private static final String SCAN = "06 02 80 0E 00 B0 05 40 00 00 01 00 E8 83 F7 1F FF 1F 10 D4 58";

    private final Map<String, String> answers = new HashMap<>();
    private FarEnd device;
    private LIDAR lidar;
    private Heard raw;

    @Before
    public void start() throws Exception {
        answers.put("02 00 01 00 74 50 12", "06 " + CONFIGURATION);
        answers.put("02 00 01 00 31 15 12", STATUS);
        answers.put("02 00 02 00 30 01 31 18", SCAN);
        device = new FarEnd(PORT, answers::get);
        lidar = (LIDAR) Runtime.start("testLidar", "LIDAR");
        raw = (Heard) Runtime.start("rawScans", "Heard");
        lidar.addListener("publishLidarData", "rawScans", "onValue");
        lidar.addListener("publishStatus", "rawScans", "onStatus");
    }

    /** Returns the status of a device with 180 degrees by 0.5 in an operating mode. */
    private static String status(String mode, String crc) {
        return "06 02 80 9A 00 B1" + " 00".repeat(7) + " " + mode + " 00".repeat(98) + " B4 00 32 00" + " 00".repeat(11)
            + " 01" + " 00".repeat(30) + " 10 " + crc;
    }

    @After
    public void release() {
        Runtime.releaseService("testLidar");
        Runtime.releaseService("rawScans");
        device.close();
    }

    @Test
    public void aSingleScanIsPublishedRightToLeft() throws Exception {
        lidar.connect(PORT);
        lidar.singleScan();
        assertArrayEquals(new int[] {0, 1, 1000, 8183, 8191}, (int[]) raw.await(1).get(0));
        assertEquals("mm", lidar.getUnit());
        assertEquals(1.0, lidar.getLastScan().metres[2], 0);
        assertTrue(lidar.getLastScan().toString(), lidar.getLastScan().toString().startsWith("scan of "));
        assertEquals(PORT, lidar.getConfig().port);
    }

    /** Another scanner may be at the other end. */
    @Test
    public void aNewConnectionKnowsNothingOfTheFormer() throws Exception {
        lidar.connect(PORT);
        lidar.singleScan();
        raw.await(1);
        answers.clear();
        lidar.connect(PORT);
        assertNull(lidar.getLastScan());
        assertEquals(0, lidar.getScanCount());
        assertEquals(0, lidar.getSpread(), 0);
        assertEquals(0, lidar.getResolution(), 0);
    }

    @Test
    public void theScanWithAnglesIsPublishedBesideIt() throws Exception {
        lidar.addListener("publishScan", "rawScans", "onValue");
        lidar.removeListener("publishLidarData", "rawScans", "onValue");
        lidar.connect(PORT);
        lidar.singleScan();
        RangeScan scan = (RangeScan) raw.await(1).get(0);
        assertEquals(5, scan.angles.length);
        assertEquals(90, scan.angles[2], 1e-9);
    }

    @Test
    public void streamsUntilStopped() throws Exception {
        answers.put("02 00 02 00 20 24 34 08", MODE_TAKEN);
        answers.put("02 00 02 00 20 25 35 08", MODE_TAKEN);
        lidar.connect(PORT);
        lidar.startStreaming();
        device.await(3);
        for (int i = 0; i < 10; i++) {
            device.send(FarEnd.bytes(SCAN.substring(3)));
        }
        assertEquals(10, raw.await(10).size());
        lidar.stopStreaming();
        assertEquals("02 00 02 00 20 25 35 08", device.await(4).get(3));
    }

    @Test
    public void theBaudRateFollowsTheDevice() throws Exception {
        answers.put("02 00 02 00 20 40 50 08", MODE_TAKEN);
        lidar.connect(PORT);
        lidar.setBaud(38400);
        lidar.singleScan();
        raw.await(1);
        assertEquals(38400, lidar.getConfig().baud);
    }

    @Test
    public void theUnitIsSetThroughInstallationMode() throws Exception {
        answers.put("02 00 0A 00 20 00 53 49 43 4B 5F 4C 4D 53 BE C5", MODE_TAKEN);
        answers.put("02 00 02 00 20 25 35 08", MODE_TAKEN);
        answers.put("02 00 23 00 77 00 00 70 00 00 00 00 00 00 02 02" + " 00".repeat(21) + " 02 00 41 B8",
            "06 " + CM_WRITTEN);
        lidar.connect(PORT);
        lidar.setToCM();
        assertEquals("02 00 02 00 20 25 35 08", device.await(6).get(5));
    }

    @Test
    public void unitAndFanAreReadFromTheDevice() throws Exception {
        lidar.connect(PORT);
        lidar.singleScan();
        raw.await(1);
        assertEquals(180, lidar.getSpread(), 0);
        assertEquals(0.5, lidar.getResolution(), 0);
        assertFalse(lidar.isStreaming());
    }

    @Test
    public void anAlreadyStreamingDeviceIsRecognised() throws Exception {
        answers.put("02 00 01 00 31 15 12", status("24", "B6 4E"));
        answers.put("02 00 02 00 20 25 35 08", MODE_TAKEN);
        lidar.connect(PORT);
        lidar.setBaud(9600);
        device.await(3);
        assertTrue(lidar.isStreaming());
    }

    @Test
    public void aNewScanModeIsPublished() throws Exception {
        answers.put("02 00 05 00 3B 64 00 64 00 1D 0F", "06 02 80 07 00 BB 01 64 00 64 00 10 4F BD");
        lidar.connect(PORT);
        lidar.setScanMode(100, 1);
        lidar.singleScan();
        raw.await(1);
        assertEquals(100, lidar.getSpread(), 0);
        assertEquals(1, lidar.getResolution(), 0);
    }

    @Test
    public void aRefusedScanModeIsAnError() throws Exception {
        answers.put("02 00 05 00 3B 64 00 19 00 E7 72", "06 02 80 07 00 BB 00 B4 00 32 00 10 23 8D");
        lidar.connect(PORT);
        lidar.setScanMode(100, 0.25);
        assertTrue(raw.getStatuses().toString(), raw.awaitStatus("rejected scan mode 100, 0.25 and stays at 180, 0.5"));
        assertEquals(0.5, lidar.getResolution(), 0);
    }

    @Test
    public void unsupportedScanModesAreRejectedImmediately() throws Exception {
        lidar.connect(PORT);
        try {
            lidar.setScanMode(180, 0.25);
            fail("taken");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("legal: 100 with 1, 0.5 or 0.25; 180 with 1 or 0.5"));
        }
    }

    @Test
    public void anUnknownPortIsReportedWithTheExistingOnes() throws Exception {
        try {
            lidar.connect("/dev/nothing_here");
            fail("connected to nothing");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("can't connect to port \"/dev/nothing_here\""));
            assertTrue(e.getMessage(), e.getMessage().contains(PORT));
        }
        assertFalse(lidar.isConnected());
        lidar.connect(PORT);
        assertTrue(lidar.isConnected());
    }

    @Test
    public void aPortInUseNamesItsUser() throws Exception {
        Serial other = (Serial) Runtime.start("otherSerial", "Serial");
        other.connect(PORT, 9600, 8, 1, 0);
        try {
            lidar.connect(PORT);
            fail("two owners");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("is in use by [otherSerial]"));
        } finally {
            Runtime.releaseService("otherSerial");
        }
        lidar.connect(PORT);
        lidar.singleScan();
        assertEquals(1, raw.await(1).size());
    }

    @Test
    public void anIllegalBaudRateNamesTheLegalOnes() throws Exception {
        try {
            lidar.connect(PORT, 57600);
            fail("connected");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("is 57600, legal: 9600, 19200, 38400, 500000"));
        }
    }

    @Test
    public void scanningWithoutConnectionIsReported() {
        try {
            lidar.singleScan();
            fail("scanned");
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("connect(port) first"));
        }
    }

    @Test
    public void aPortClosedByAnotherIsNoticed() throws Exception {
        lidar.connect(PORT);
        lidar.addListener("publishState", "rawScans", "onState");
        ((Serial) Runtime.getService("testLidar.serial")).disconnect();
        assertTrue(raw.awaitStatus("port " + PORT + " was closed: testLidar reconnects"));
        assertFalse(lidar.isConnected());
        assertTrue(raw.awaitState("\"connected\":false"));
        scanningWithoutConnectionIsReported();
        lidar.reconnectSerial();
        lidar.singleScan();
        assertEquals(1, raw.await(1).size());
    }

    @Test
    public void aRemovedVirtualPortIsNoticed() throws Exception {
        lidar.connect(PORT);
        device.close();
        scanningWithoutConnectionIsReported();
        assertTrue(raw.awaitStatus("port " + PORT + " was closed"));
    }

    @Test
    public void anUnopenablePortIsReportedWithTheExistingOnes() throws Exception {
        lidar.connect(PORT);
        try {
            lidar.connect("/dev/nothing_here");
            fail("connected to nothing");
        } catch (IOException e) {
            assertTrue(e.getMessage(), e.getMessage()
                .matches("testLidar can't connect to port \"/dev/nothing_here\": .*; available ports: .*"
                + PORT + ".*"));
            assertFalse(e.getMessage(), e.getMessage().matches(".*available ports: .*nothing_here.*"));
        }
        assertTrue("MyRobotLab's table keeps it", Serial.listPorts().contains("/dev/nothing_here"));
        assertFalse("the old port was closed first", lidar.isConnected());
    }

    @Test
    public void reconnectingTakesTheSamePort() throws Exception {
        lidar.connect(PORT);
        lidar.disconnect();
        assertFalse(lidar.isConnected());
        lidar.reconnectSerial();
        lidar.singleScan();
        assertEquals(1, raw.await(1).size());
        assertTrue(lidar.isConnected());
    }
}
