// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.TreeSet;
import org.SEAR.Needs;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.SEAR.protocol.scip.HokuyoModel;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.myrobotlab.service.devices.ScannedRoom;

/**
 * Third-party drivers on the exported ports of Hokuyo's scanners and the RPLIDAR in real time read the ranges of
 * {@code sear.getLidarResult}.
 */
@Category(Slow.class)
@Needs("drivers")
public class ThirdPartyScannersTest extends WithPrograms {
    private static final int STARTING = 15;
    private static final int TURNS = 5;

    private double range;

    private void start(String model) throws IOException {
        ScannedRoom.build(model, scanner -> {
            range = scanner.getRange();
            if (model.equals("URG-04LX")) {
                scanner.setBaud(HokuyoModel.USB);
            }
        });
        simulate();
    }

    /** @param rate scans that the driver polls for per second; after ten empty polls it restarts */
    private List<String[]> mrpt(String file, int rate) throws Exception {
        String[] replaced = {"@PORT@", sear.exportPort(ScannedRoom.PORT), "@RATE@", "" + rate};
        return programs.grabScans(grabber(file, "log", replaced), STARTING, Programs.SECONDS);
    }

    @Test
    public void mrptReadsAnUrg04lx() throws Exception {
        start("URG-04LX");
        compare(mrpt("hokuyo-mrpt.ini", 10), 682, 1, 0.00051);
    }

    @Test
    public void mrptReadsAnUtm30lx() throws Exception {
        start("UTM-30LX");
        compare(mrpt("hokuyo-mrpt.ini", 40), 1081, 0, 0.00051);
    }

    /**
     * Compares lines that contain the time, the ranges right to left and their validity; their first value is the
     * sensor's value at {@code offset}.
     */
    private void compare(List<String[]> lines, int values, int offset, double tolerance) {
        float[] expected = sear.getLidarResult("scanner");
        int seen = 0;
        for (String[] line : lines) {
            assertEquals(1 + 2 * values, line.length);
            for (int i = 0; i < values; i++) {
                boolean valid = line[1 + values + i].equals("1");
                assertEquals("beam " + i, expected[i + offset] < range - 0.001, valid);
                if (valid) {
                    assertEquals("beam " + i, expected[i + offset], Double.parseDouble(line[1 + i]), tolerance);
                    seen++;
                }
            }
        }
        assertTrue("only " + seen + " beams hit something", seen > lines.size() * values / 4);
    }

    /**
     * Version 2.5.8 takes the angles of its SDK, 65536 per turn, as units of two 64ths of a degree. It reports an
     * object at 64/45 of its clockwise angle from ahead and drops those beyond a turn. The ranges are right.
     */
    @Test
    public void mrptReadsAnRplidar() throws Exception {
        start("RPLIDAR-A1");
        float[] expected = sear.getLidarResult("scanner");
        List<String[]> lines = mrpt("rplidar-mrpt.ini", 10);
        int seen = 0;
        for (String[] line : lines) {
            assertEquals(1 + 2 * 360, line.length);
            for (int i = 0; i < 360; i++) {
                int before = (int) Math.floor(i * 45 / 64.0);
                float[] around = {beam(expected, before), beam(expected, before + 1), beam(expected, before + 2)};
                Arrays.sort(around);
                if (line[1 + 360 + i].equals("1") && around[2] < range) {
                    double metres = Double.parseDouble(line[1 + i]);
                    boolean near = metres > around[0] - 0.002 && metres < around[2] + 0.002;
                    assertTrue(i + ": " + metres + " of " + Arrays.toString(around), near);
                    seen++;
                }
            }
        }
        assertTrue("only " + seen + " beams hit something", seen > lines.size() * 90);
    }

    /** Returns a beam of a full circle, right to left, one beam per degree. */
    private static float beam(float[] ranges, int clockwise) {
        return ranges[Math.floorMod(180 - clockwise, 360)];
    }

    @Test
    public void roboticiaReadsAnRplidar() throws Exception {
        start("RPLIDAR-A1");
        roboticia("normal", 1);
    }

    @Test
    public void roboticiaReadsAnRplidarsExpressScans() throws Exception {
        start("RPLIDAR-A1");
        roboticia("express", 0.5);
    }

    /**
     * The driver shifts each sample of an express scan by one step of half a degree: between two beams any value is
     * right.
     */
    private void roboticia(String kind, double step) throws Exception {
        float[] expected = sear.getLidarResult("scanner");
        List<String> output = withModemLines("rplidar_scan.py", kind, Integer.toString(TURNS));
        assertTrue(output.get(0), output.get(0).contains("'model': 24, 'firmware': (1, 20), 'hardware': 0"));
        assertTrue(output.get(1), output.get(1).contains("'Good', 0"));
        assertEquals(2 + TURNS, output.size());
        compareTurns(output.subList(3, output.size()), expected, step);
    }

    /** Runs an unchanged driver at a pseudo-terminal by {@code sear modem-lines}, because it sets DTR. */
    private List<String> withModemLines(String script, String... arguments) throws Exception {
        String asOnThePage = DocBlock.commands("docs/other-programs.md", "sear modem-lines").get(0)
            .replace("my.py", SCRIPTS.resolve(script).toString())
            .replace("/dev/pts/3", sear.exportPort(ScannedRoom.PORT));
        List<String> command = SearProcess.command();
        command.addAll(Arrays.asList(asOnThePage.split(" ")).subList(1, asOnThePage.split(" ").length));
        command.addAll(List.of(arguments));
        return programs.run(withDrivers(new ProcessBuilder(command)), new ArrayList<>());
    }

    @Test
    public void pyrplidarReadsAnRplidar() throws Exception {
        start("RPLIDAR-A1");
        float[] expected = sear.getLidarResult("scanner");
        List<String> output = withModemLines("pyrplidar_scan.py", Integer.toString(TURNS));
        output.removeIf(line -> line.startsWith("PyRPlidar Info"));
        assertTrue(output.get(0), output.get(0).contains("'model': 24"));
        assertEquals(2 + TURNS, output.size());
        compareTurns(output.subList(3, output.size()), expected, 1);
    }

    /** Version 0.1.3 drops a bit of the angle: it reports an odd degree as the even one before. */
    @Test
    public void rplidarc1ReadsAnRplidar() throws Exception {
        start("RPLIDAR-A1");
        float[] expected = sear.getLidarResult("scanner");
        List<String> output = withModemLines("rplidarc1_scan.py", "1000");
        String[] samples = output.get(output.size() - 1).split(" ");
        assertEquals(1000, samples.length);
        TreeSet<Integer> degrees = new TreeSet<>();
        for (String each : samples) {
            int even = (int) Math.round(Double.parseDouble(each.split(":")[0]));
            double metres = Double.parseDouble(each.split(":")[1]) / 1000;
            degrees.add(even);
            boolean near = Math.abs(beam(expected, even) - metres) < 0.0007
                || Math.abs(beam(expected, even + 1) - metres) < 0.0007;
            assertTrue(each + " of " + beam(expected, even) + ", " + beam(expected, even + 1), even % 2 == 0 && near);
        }
        assertTrue(degrees.toString(), degrees.size() > 45);
    }

    private static void compareTurns(List<String> lines, float[] expected, double step) {
        for (String line : lines) {
            TreeSet<Integer> degrees = new TreeSet<>();
            for (String each : line.split(" ")) {
                double clockwise = Double.parseDouble(each.split(":")[0]) - (step < 1 ? step : 0);
                double millimetres = Double.parseDouble(each.split(":")[1]);
                int degree = (int) Math.round(clockwise);
                if (Math.abs(clockwise - degree) < 0.05) {
                    degrees.add(Math.floorMod(degree, 360));
                    String where = String.format(Locale.ROOT, "step %s at %s", step, each);
                    assertEquals(where, beam(expected, degree) * 1000.0, millimetres, 0.7);
                }
            }
            assertTrue(degrees.toString(), degrees.size() > 90);
        }
    }
}
