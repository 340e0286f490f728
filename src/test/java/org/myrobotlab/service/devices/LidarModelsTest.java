// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.devices;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.util.List;
import org.SEAR.Slow;
import org.junit.After;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Heard;
import org.myrobotlab.service.LIDAR;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;
import org.myrobotlab.service.lidar.LidarChoice;
import org.myrobotlab.service.lidar.RangeScan;

/** One script reads each model of simulated LIDAR: the service publishes the sensor's measurements. */
@Category(Slow.class)
public class LidarModelsTest {
    private static final String PORT = ScannedRoom.PORT;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private SEAR sear;
    private LIDAR lidar;
    private Heard heard;

    private void start(String model) throws IOException {
        System.setProperty("sear.project", folder.getRoot().toPath().resolve("SEARproject").toString());
        System.setProperty("sear.headless", "true");
        ScannedRoom.build(model, scanner -> { });
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        lidar = (LIDAR) Runtime.start("modelLidar", "LIDAR");
        heard = (Heard) Runtime.start("heardScans", "Heard");
        lidar.addListener("publishScan", "heardScans", "onValue");
        lidar.addListener("publishStatus", "heardScans", "onStatus");
        lidar.setModel(model);
    }

    @After
    public void stop() {
        Runtime.releaseService("modelLidar");
        Runtime.releaseService("heardScans");
        sear.stopSimulation();
        Runtime.releaseService("sear");
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
    }

    /** Runs the part that all models share. */
    private void scanAndStream() throws Exception {
        lidar.connect(PORT);
        lidar.setScanMode(180, 1);
        lidar.singleScan();
        RangeScan scan = (RangeScan) heard.await(1).get(0);
        assertEquals(180, scan.spread, 2);
        assertEquals(1, scan.resolution, 0.06);
        assertEquals(scan.spread, lidar.getSpread(), 1);
        assertEquals(ScannedRoom.WALL, ahead(scan), 0.02);
        assertNull("nothing to the right", scan.metres[0]);
        lidar.startStreaming();
        heard.await(4);
        assertTrue(heard.await(0).size() + " scans, " + heard.getStatuses(), lidar.isStreaming());
        assertEquals(ScannedRoom.WALL, ahead(lidar.getLastScan()), 0.02);
        lidar.stopStreaming();
        for (int i = 0; i < 20 && lidar.isStreaming(); i++) {
            sear.simSleep(0.1);
        }
        assertFalse(heard.getStatuses().toString(), lidar.isStreaming());
        long count = lidar.getScanCount();
        sear.simSleep(1);
        assertEquals(count, lidar.getScanCount());
        assertTrue(heard.getStatuses().toString(), heard.getStatuses().stream()
            .noneMatch(status -> status.toString().contains("error")));
    }

    private static double ahead(RangeScan scan) {
        for (int i = 0; i < scan.angles.length; i++) {
            if (Math.abs(scan.angles[i] - 90) <= scan.resolution / 2) {
                return scan.metres[i];
            }
        }
        throw new AssertionError("no value ahead");
    }

    /** Checks that each value of a scan with one beam per value equals the sensor's beam at its angle. */
    private void compare(RangeScan scan, double nearest, double tolerance) {
        float[] expected = sear.getLidarResult("scanner");
        double[] fan = {(expected.length - 1) * scan.resolution / 2, scan.resolution};
        for (int i = 0; i < scan.angles.length; i++) {
            int beam = (int) Math.round((scan.angles[i] - 90 + fan[0]) / fan[1]);
            boolean hit = expected[beam] < range() - 0.001 && expected[beam] > nearest;
            assertEquals("at " + scan.angles[i], hit, scan.metres[i] != null);
            if (hit) {
                assertEquals("at " + scan.angles[i], expected[beam], scan.metres[i], tolerance);
            }
        }
    }

    private double range() {
        return org.SEAR.protocol.lidar.LidarModel.of(lidar.getConfig().model).getRange();
    }

    @Test
    public void lms200() throws Exception {
        start("LMS200");
        scanAndStream();
        compare(lidar.getLastScan(), 0, 0.00051);
    }

    @Test
    public void urg04lx() throws Exception {
        start("URG-04LX");
        scanAndStream();
        lidar.setScanMode(240, 0.35);
        lidar.setBaud(115200);
        lidar.singleScan();
        sear.simSleep(2);
        RangeScan scan = lidar.getLastScan();
        assertEquals(682, scan.raw.length);
        assertEquals("mm", scan.unit);
        assertEquals(115200, lidar.getConfig().baud);
        compare(scan, 0.02, 0.00051);
        try {
            lidar.setToCM();
            fail("centimetres");
        } catch (IllegalArgumentException e) {
            assertEquals("a URG-04LX measures in millimetres, legal: setToMM()", e.getMessage());
        }
        try {
            lidar.setScanMode(270, 0.25);
            fail("too wide");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(),
                e.getMessage().startsWith("scan mode is spread 270, resolution 0.25, legal: spread 1 to 240, "
                    + "resolution 0.35"));
        }
    }

    @Test
    public void utm30lx() throws Exception {
        start("UTM-30LX");
        scanAndStream();
        lidar.setScanMode(270, 0.25);
        lidar.startStreaming();
        int before = heard.await(1).size();
        sear.simSleep(1);
        assertEquals(before + 30, heard.await(before + 30).size(), 30);
        compare(lidar.getLastScan(), 0.023, 0.00051);
        lidar.disconnect();
        lidar.connect(PORT);
        sear.simSleep(1);
        assertTrue("it streams on", lidar.isStreaming());
    }

    @Test
    public void rplidarA1() throws Exception {
        start("RPLIDAR-A1");
        scanAndStream();
        lidar.setScanMode(360, 1);
        int before = heard.await(1).size();
        lidar.singleScan();
        RangeScan scan = (RangeScan) heard.await(before + 1).get(before);
        assertEquals(360, scan.raw.length);
        assertEquals(-90, scan.angles[0], 1e-9);
        compare(scan, 0.15, 0.00064);
        lidar.setScanMode(360, 0.5);
        lidar.singleScan();
        scan = (RangeScan) heard.await(before + 2).get(before + 1);
        assertEquals(720, scan.raw.length);
        assertEquals(0.5, lidar.getResolution(), 0);
        assertEquals(ScannedRoom.WALL, ahead(scan), 0.001);
        assertTrue(heard.awaitStatus("the LIDAR is an RPLIDAR of model 24, firmware 1.20, hardware 0"));
        try {
            lidar.setScanMode(361, 1);
            fail("more than a circle");
        } catch (IllegalArgumentException e) {
            assertEquals("scan mode is spread 361, resolution 1.0, legal: spread 1 to 360, resolution 1 (standard) or "
                + "0.5 (express)", e.getMessage());
        }
    }

    @Test
    public void theModelIsChosenBeforeConnecting() throws Exception {
        start("URG-04LX");
        assertEquals("that of power-on", 19200, lidar.getConfig().baud);
        lidar.setModel("URG-04LX");
        lidar.connect(PORT);
        try {
            lidar.setModel("LMS200");
            fail("changed");
        } catch (IllegalStateException e) {
            assertEquals("modelLidar is connected to a URG-04LX: disconnect() before setModel(\"LMS200\")",
                e.getMessage());
        }
        try {
            lidar.setModel("URG");
            fail("unknown");
        } catch (IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().startsWith("LIDAR model is \"URG\", legal: [LMS200, "));
        }
        try {
            lidar.setBaud(9600);
            fail("no such rate");
        } catch (IllegalArgumentException e) {
            assertEquals("LIDAR baud rate is 9600, legal: 19200, 38400, 57600, 115200, 250000, 500000, 750000",
                e.getMessage());
        }
        lidar.disconnect();
        lidar.setModel("LMS200");
        assertEquals(9600, lidar.getConfig().baud);
        List<LidarChoice> choices = lidar.getModels();
        assertNotNull(choices.stream().filter(choice -> choice.name.equals("UTM-30LX")).findFirst().get());
    }

    @Test
    public void aHokuyoLeftAtAnotherRateIsFound() throws Exception {
        start("URG-04LX");
        lidar.connect(PORT);
        lidar.setBaud(57600);
        lidar.singleScan();
        heard.await(1);
        lidar.disconnect();
        lidar.connect(PORT, 19200);
        lidar.singleScan();
        heard.await(2);
        assertEquals(57600, lidar.getConfig().baud);
    }
}
