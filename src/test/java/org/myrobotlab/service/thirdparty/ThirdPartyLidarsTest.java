// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Third-party drivers on the exported ports of each model of LIDAR in real time read the ranges of
 * {@code sear.getLidarResult}.
 */
@Category(Slow.class)
public class ThirdPartyLidarsTest extends WithPrograms {
    private static final String PORT = "/dev/SEAR_LIDAR_01";

    private void start(String model, double spread, double resolution) throws IOException {
        room();
        new Box("far to the right", 0.2, 60, 6, 0).move(-40, 0, 0);
        SEARrobot robot = new SEARrobot("stand");
        robot.addComponent(new Dynamics("drive", 4, 0, 0.1, 0, 0, 0, 0));
        double[][] wheels = {{-0.2, 0, 1}, {0.2, 0, 1}, {0, 0.2, 0}, {0, -0.2, 0}};
        for (double[] at : wheels) {
            robot.addWheel(new Wheel("wheel" + at[0] + at[1], 0.1, 0.03, (int) at[2], at[0], 0, at[1]));
        }
        LIDAR lidar = new LIDAR("scanner");
        lidar.setModel(model);
        lidar.setSpread(spread);
        lidar.setResolution(resolution);
        lidar.setPorts("/dev/my_Lidar01", PORT);
        lidar.move(0, 0.3, 0);
        robot.addComponent(lidar);
        simulate();
    }

    @Test
    public void mrptReadsAnLms291() throws Exception {
        start("LMS291", 180, 0.5);
        mrptReadsCentimetres("180", "50");
    }

    /** Frames with a resolution of 0.25 are too long for this driver. */
    @Test
    public void mrptReadsAnLms221WithAHundredDegrees() throws Exception {
        start("LMS221", 100, 0.5);
        mrptReadsCentimetres("100", "50");
    }

    private void mrptReadsCentimetres(String spread, String hundredths) throws Exception {
        Path config = grabber("sick-mrpt.ini", "log", "@PORT@", sear.exportPort(PORT), "@BAUD@", "38400", "mm_mode = 1",
            "mm_mode = 0", "FOV = 180", "FOV = " + spread, "resolution = 50", "resolution = " + hundredths);
        compare(programs.grabScans(config, 15, Programs.SECONDS), sear.getLidarResult("scanner"), 80, 0.0101);
    }

    @Test
    public void mrptReadsAnLms111OverTcp() throws Exception {
        start("LMS111", 270, 0.25);
        Path config = grabber("sick-lms1xx-mrpt.ini", "log", "@PORT@", Integer.toString(sear.exportTcp(PORT, 0)));
        compare(inTime(programs.grabScans(config, 25, Programs.SECONDS)), sear.getLidarResult("scanner"), 20, 0.00101);
    }

    /** The driver of the LMS1xx also accepts a TiM and keeps its resolution. */
    @Test
    public void mrptReadsATim561OverTcp() throws Exception {
        start("TiM561", 270, 1 / 3.0);
        Path config = grabber("sick-lms1xx-mrpt.ini", "log", "@PORT@", Integer.toString(sear.exportTcp(PORT, 0)));
        compare(inTime(programs.grabScans(config, 25, Programs.SECONDS)), sear.getLidarResult("scanner"), 10, 0.00101);
    }

    /** The driver logs all ranges of a scan for any fan. */
    @Test
    public void mrptReadsAnArbitraryFan() throws Exception {
        start("CoLa", 231, 5.5);
        Path config = grabber("sick-lms1xx-mrpt.ini", "log", "@PORT@", Integer.toString(sear.exportTcp(PORT, 0)));
        compare(inTime(programs.grabScans(config, 20, Programs.SECONDS)), sear.getLidarResult("scanner"), 30, 0.00101);
    }

    /** If an answer takes more than 40 ms, as on a busy computer, this driver logs a scan without values. */
    private static List<String[]> inTime(List<String[]> lines) {
        List<String[]> full = lines.stream().filter(line -> line.length > 1).collect(Collectors.toList());
        System.out.println("MRPT's driver logged " + full.size() + " scans, and " + (lines.size() - full.size())
            + " without values");
        assertTrue("only " + full.size() + " of " + lines.size() + " scans in time", full.size() > Programs.SECONDS);
        return full;
    }

    /** Compares lines that contain the time, the ranges and their validity. */
    private static void compare(List<String[]> lines, float[] expected, double farthest, double tolerance) {
        int seen = 0;
        for (String[] line : lines) {
            assertEquals(1 + 2 * expected.length, line.length);
            String[] metres = Arrays.copyOfRange(line, 1, 1 + expected.length);
            for (int i = 0; i < expected.length; i++) {
                if (expected[i] < farthest) {
                    assertEquals("beam " + i, expected[i], Double.parseDouble(metres[i]), tolerance);
                    assertEquals("beam " + i, "1", line[1 + expected.length + i]);
                    seen++;
                }
            }
        }
        assertTrue("only " + seen + " beams hit something", seen > lines.size() * expected.length / 4);
    }
}
