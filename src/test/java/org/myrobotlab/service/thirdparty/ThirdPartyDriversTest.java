// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.SEAR.FreePort;
import org.SEAR.Needs;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Third-party programs for the real hardware on the exported ports of a simulation in real time. The system property
 * {@code sear.driverSeconds} makes each run longer than the default few seconds.
 */
@Category(Slow.class)
@Needs("drivers")
public class ThirdPartyDriversTest extends WithPrograms {
    private static final int SECONDS = Programs.SECONDS;
    private static final double LATITUDE = 35.3;
    private static final double LONGITUDE = -80.7;
    private static final int LMS_NO_RETURN = 8191;
    private static final int TRIES = 3;
    private static final int RESTARTS = Integer.getInteger("sear.driverRestarts", 3);

    @Before
    public void start() {
        room();
        SEARrobot robot = new SEARrobot("create");
        Dynamics dynamics = new Dynamics("drive", 3.6, 60, 0.3, 0.4, 1000, 0.1, 0, 0.1, 0, 0, 0, 0);
        dynamics.setPorts("/dev/my_Robot01", "/dev/SEAR_Robot_01");
        dynamics.setModel("create2");
        dynamics.setBaud(115200);
        robot.addComponent(dynamics);
        robot.addComponent(new Cylinder("body", 0.17, 0.07, 3));
        double[][] wheels = {{-0.1175, 0, 1}, {0.1175, 0, 1}, {0, 0.13, 0}, {0, -0.13, 0}};
        for (double[] at : wheels) {
            Wheel wheel = new Wheel("wheel" + at[0] + at[1], 0.036, 0.02, (int) at[2]);
            wheel.move(at[0], 0, at[1]);
            robot.addWheel(wheel);
        }
        LIDAR lidar = new LIDAR("scanner");
        lidar.setPorts("/dev/my_Lidar01", "/dev/SEAR_LIDAR_01");
        lidar.move(0, 0.15, 0);
        robot.addComponent(lidar);
        GPS gps = new GPS("receiver", LATITUDE, 200, LONGITUDE);
        gps.setPorts("/dev/my_GPS_01", "/dev/SEAR_GPS_01");
        robot.addComponent(gps);
        simulate();
    }

    private List<String> run(String script, Object... arguments) throws Exception {
        return programs.run(python(script, arguments), new ArrayList<>());
    }

    @Test
    public void pycreate2DrivesAndReads() throws Exception {
        String port = sear.exportPort("/dev/SEAR_Robot_01");
        List<String> output = run("pycreate2_drive.py", port, SECONDS);
        assertTrue(output.toString(), output.stream().anyMatch(line -> line.matches("\\d+ readings, \\d+ mm")));
    }

    @Test
    public void pyserialScansAndDrives() throws Exception {
        scanAndDrive(sear.exportPort("/dev/SEAR_Robot_01"), sear.exportPort("/dev/SEAR_LIDAR_01"));
    }

    @Test
    public void pyserialSetsTheBaudRateOverTcp() throws Exception {
        scanAndDrive("rfc2217://localhost:" + sear.exportRfc2217("/dev/SEAR_Robot_01", 0),
            "rfc2217://localhost:" + sear.exportRfc2217("/dev/SEAR_LIDAR_01", 0));
    }

    private void scanAndDrive(String robot, String scanner) throws Exception {
        int[] expected = millimetres(sear.getLidarResult("scanner"));
        List<String> output = run("pyserial_scan.py", robot, 115200, scanner);
        int[] scan = Arrays.stream(output.get(0).split(" ")).mapToInt(Integer::parseInt).toArray();
        assertEquals(expected.length, scan.length);
        for (int i = 0; i < scan.length; i++) {
            assertEquals("beam " + i, expected[i], scan[i], 1);
        }
        assertEquals(400, Integer.parseInt(output.get(1)), 40);
    }

    @Test
    public void theProgramOfThePageDrivesAndReads() throws Exception {
        String program = DocBlock.of("docs/other-programs.md", "python3").get(0);
        assertTrue(program, program.contains("\"/dev/pts/1\", 57600"));
        Path file = folder.newFile("page.py").toPath();
        Files.writeString(file, program.replace("/dev/pts/1", sear.exportPort("/dev/SEAR_Robot_01"))
            .replace("57600", "115200"));
        List<String> output = run(file.toString());
        assertTrue(output.toString(), output.get(0).matches("\\(\\d+,\\)"));
        sear.simSleep(1);
        assertTrue("it drives", sear.getPose("create")[2] > 0.1);
    }

    private Path sick(String port) throws IOException {
        return grabber("sick-mrpt.ini", "log", "@PORT@", port, "@BAUD@", "38400");
    }

    @Test
    public void mrptsDriverSeesTheSameRanges() throws Exception {
        Path config = sick(sear.exportPort("/dev/SEAR_LIDAR_01", inFolder("ttySICK")));
        int[] expected = millimetres(sear.getLidarResult("scanner"));
        for (String[] line : programs.grabScans(config, 15, Programs.SECONDS)) {
            compare(expected, line);
        }
    }

    /**
     * The driver is killed while the scanner streams. The next one must stop the stream and set the scanner up again.
     */
    @Test
    public void mrptsDriverStartsInMidStream() throws Exception {
        Path config = sick(sear.exportPort("/dev/SEAR_LIDAR_01"));
        int streaming = 0;
        int starts = 0;
        List<String> output = List.of();
        while (streaming < RESTARTS && starts < RESTARTS * TRIES) {
            Process grabber = programs.start(new ProcessBuilder("stdbuf", "-oL", "rawlog-grabber", config.toString()));
            starts++;
            if (programs.tells(grabber, Programs.LOGS, SECONDS + Programs.PATIENCE)) {
                streaming++;
            } else {
                output = programs.read(grabber, 0);
                System.out.println("start " + starts + " failed:\n" + String.join("\n", output));
            }
            grabber.destroyForcibly().waitFor();
        }
        System.out.println("MRPT's driver streamed after " + streaming + " of " + starts + " starts");
        assertEquals(starts + " starts: " + output, RESTARTS, streaming);
    }

    /** MRPT requests a value every half degree; the script call returns one per degree. */
    private static void compare(int[] everyDegree, String[] timeThenRangesThenValid) {
        assertEquals(1 + 2 * 361, timeThenRangesThenValid.length);
        String[] metres = Arrays.copyOfRange(timeThenRangesThenValid, 1, 1 + 361);
        for (int i = 0; i < everyDegree.length; i++) {
            double measured = Double.parseDouble(metres[2 * i]) * 1000;
            if (everyDegree[i] != LMS_NO_RETURN) {
                assertEquals("at " + i + " degrees", everyDegree[i], measured, 1.01);
            }
        }
    }

    @Test
    public void gpsdGetsAFix() throws Exception {
        String link = inFolder("ttyGPS");
        String port = sear.exportPort("/dev/SEAR_GPS_01", link);
        assertEquals(link, port);
        int number = FreePort.find();
        programs.start(new ProcessBuilder(
            words(DocBlock.commands("docs/other-programs.md", "gpsd -N -n -b"), "/dev/pts/3",
            "-S " + number + " " + port)));
        String fix = null;
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(SECONDS + 40);
        while (fix == null && System.nanoTime() < deadline) {
            Process pipe = programs.start(
                new ProcessBuilder(words(DocBlock.commands("docs/other-programs.md", "gpspipe "), "localhost",
                "-n 12 localhost:" + number)));
            fix = programs.read(pipe, 20).stream()
                .filter(line -> line.matches(".*\"class\":\"TPV\".*\"mode\":[23].*\"lat\":.*")).findFirst()
                .orElse(null);
        }
        assertTrue("no fix", fix != null);
        assertEquals(LATITUDE, number(fix, "lat"), 1e-5);
        assertEquals(LONGITUDE, number(fix, "lon"), 1e-5);
    }

    /** Returns the words of the page's only such command with one word replaced. */
    private static List<String> words(List<String> commands, String word, String here) {
        assertEquals(commands.toString(), 1, commands.size());
        assertTrue(commands.toString(), commands.get(0).contains(word));
        return Arrays.asList(commands.get(0).replace(word, here).split(" "));
    }

    private static int[] millimetres(float[] metres) {
        int[] values = new int[metres.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = metres[i] >= 8.19 ? LMS_NO_RETURN : Math.round(metres[i] * 1000);
        }
        return values;
    }
}
