// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.SEAR.FreePort;
import org.SEAR.Needs;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.SEAR.geometry.Geoid;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Third-party programs for real u-blox receivers on the exported port of a simulated NEO-M8N. */
@Category(Slow.class)
@Needs("drivers")
public class ThirdPartyGpsTest extends WithPrograms {
    private static final String PORT = "/dev/SEAR_GPS_01";
    private static final double LATITUDE = 35.3;
    private static final double LONGITUDE = -80.7;
    private static final double ALTITUDE = 200;

    @Before
    public void start() {
        new Floor("floor", 20, 20);
        SEARrobot robot = Robots.create2("create");
        GPS gps = new GPS("receiver", LATITUDE, ALTITUDE, LONGITUDE);
        gps.setModel("NEO-M8N");
        gps.setPorts("/dev/my_GPS_01", PORT);
        robot.addComponent(gps);
        simulate();
    }

    /** gpsd switches the receiver to UBX, reports it, and then uses NAV-PVT. */
    @Test
    public void gpsdSwitchesToUbxAndGetsAFix() throws Exception {
        String port = sear.exportPort(PORT, inFolder("ttyGPS"));
        int number = FreePort.find();
        List<String> commands = DocBlock.commands("docs/other-programs.md", "gpsd -N -n -s 9600");
        assertEquals(commands.toString(), 1, commands.size());
        String gpsd = commands.get(0).replace("/dev/pts/3", "-S " + number + " " + port);
        Process daemon = programs.start(new ProcessBuilder(gpsd.split(" ")));
        List<String> output = new ArrayList<>();
        boolean ubx = false;
        String fix = null;
        long deadline = System.nanoTime() + TimeUnit.SECONDS.toNanos(Programs.SECONDS + 60);
        while ((fix == null || !ubx) && System.nanoTime() < deadline) {
            Process pipe = programs.start(new ProcessBuilder("gpspipe", "-w", "-n", "12", "localhost:" + number));
            output.addAll(programs.read(pipe, 20));
            ubx |= output.stream().anyMatch(line -> line.contains("\"driver\":\"u-blox\"")
                && line.contains("PROTVER=18"));
            fix = ubx ? output.stream().filter(ThirdPartyGpsTest::isUbxFix).findFirst().orElse(null) : null;
        }
        assertTrue("gpsd ended: " + programs.read(daemon, 0), daemon.isAlive());
        assertTrue(String.join("\n", output), fix != null);
        assertEquals(LATITUDE, number(fix, "lat"), 1e-6);
        assertEquals(LONGITUDE, number(fix, "lon"), 1e-6);
        double altitude = sear.getGpsResult("receiver")[2];
        assertEquals(altitude, number(fix, "altMSL"), 0.1);
        assertEquals(altitude + Geoid.separation(LATITUDE, LONGITUDE), number(fix, "altHAE"), 0.1);
    }

    /** NMEA has no earth-centred coordinates. */
    private static boolean isUbxFix(String line) {
        return line.matches(".*\"class\":\"TPV\".*\"mode\":3.*\"lat\":.*") && line.contains("\"ecefx\"");
    }

    @Test
    public void pyubx2SetsUpTheReceiverAndReadsItsSolutions() throws Exception {
        List<String> output = programs.run(python("pyubx2_read.py", sear.exportPort(PORT), 5 * Programs.SECONDS),
            new ArrayList<>());
        assertEquals("EXT CORE 3.01 (107900)", output.get(0));
        assertEquals("12", output.get(1));
        assertEquals(2 + 5 * Programs.SECONDS, output.size());
        double[] truth = sear.getGpsResult("receiver");
        for (String line : output.subList(2, output.size())) {
            String[] fields = line.split(" ");
            assertEquals(line, truth[0], Double.parseDouble(fields[0]), 2e-7);
            assertEquals(line, truth[1], Double.parseDouble(fields[1]), 2e-7);
            assertEquals(line, truth[2], Double.parseDouble(fields[2]), 0.02);
            assertEquals(line, truth[2] + Geoid.separation(LATITUDE, LONGITUDE), Double.parseDouble(fields[3]), 0.02);
        }
    }
}
