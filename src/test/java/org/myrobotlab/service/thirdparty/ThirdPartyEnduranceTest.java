// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.SEAR.Needs;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.protocol.scip.HokuyoModel;
import org.junit.Before;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * Three third-party drivers at the same time, for a Create 2, a Hokuyo URG-04LX and a u-blox NEO-M8N on one robot. They
 * are killed at work and started again {@code sear.driverRestarts} times, then run for {@code sear.driverSeconds}: 20
 * and 600 in the long run.
 */
@Category(Slow.class)
@Needs("drivers")
public class ThirdPartyEnduranceTest extends WithPrograms {
    private static final int KILLS = Integer.getInteger("sear.driverRestarts", 2);
    private static final String SCANNER = "/dev/SEAR_LIDAR_01";
    private static final String RECEIVER = "/dev/SEAR_GPS_01";
    private static final String ROBOT = "/dev/SEAR_Robot_01";
    private static final int VALUES = 682;
    private static final int SOLUTIONS_A_SECOND = 5;
    private static final int STARTING = 15;

    @Before
    public void start() {
        new Floor("floor", 40, 40);
        new Box("ahead", 10, 0.2, 1, 0).move(0, 0.5, 4);
        SEARrobot robot = Robots.create2("create", "/dev/my_Robot01", ROBOT);
        LIDAR scanner = new LIDAR("scanner");
        scanner.setModel("URG-04LX");
        scanner.setBaud(HokuyoModel.USB);
        scanner.setPorts("/dev/my_Lidar01", SCANNER);
        scanner.move(0, 0.15, 0);
        robot.addComponent(scanner);
        GPS gps = new GPS("receiver", 35.3, 200, -80.7);
        gps.setModel("NEO-M8N");
        gps.setPorts("/dev/my_GPS_01", RECEIVER);
        robot.addComponent(gps);
        simulate();
    }

    private Path grabber(String log) throws IOException {
        return grabber("hokuyo-mrpt.ini", log, "@PORT@", sear.exportPort(SCANNER), "@RATE@", "10");
    }

    @Test
    public void threeDriversAreKilledReconnectAndLoseNothing() throws Exception {
        for (int kill = 0; kill < KILLS; kill++) {
            Process robot = programs.start(python("pycreate2_drive.py", sear.exportPort(ROBOT), Programs.PATIENCE));
            Process receiver = programs.start(python("pyubx2_read.py", sear.exportPort(RECEIVER), Programs.PATIENCE));
            Process scanner = programs.grabber(grabber("killed" + kill));
            programs.untilItTells(robot, "\\d+ mode .*");
            programs.untilItTells(receiver, "35\\.3.*");
            for (Process driver : new Process[] {robot, receiver, scanner}) {
                driver.destroyForcibly().waitFor();
            }
            // the killed driver left it at another rate without NMEA; a user would press its button
            sear.power("receiver", false);
            sear.power("receiver", true);
        }
        Process robot = programs.start(python("pycreate2_drive.py", sear.exportPort(ROBOT), Programs.SECONDS));
        Process receiver = programs.start(
            python("pyubx2_read.py", sear.exportPort(RECEIVER), SOLUTIONS_A_SECOND * Programs.SECONDS));
        List<String[]> scans = programs.grabScans(grabber("log"), STARTING, 2 * Programs.SECONDS);
        scans.forEach(line -> assertEquals(1 + 2 * VALUES, line.length));
        assertTrue("only " + scans.size() + " scans", scans.size() >= Programs.SECONDS * 5);
        List<String> driven = programs.read(robot, Programs.PATIENCE);
        assertEquals(String.join("\n", driven.subList(Math.max(0, driven.size() - 5), driven.size())), 0,
            robot.waitFor());
        List<String> solved = programs.read(receiver, Programs.PATIENCE);
        assertEquals(solved.get(solved.size() - 1), 0, receiver.waitFor());
        assertEquals(2 + SOLUTIONS_A_SECOND * Programs.SECONDS, solved.size());
    }
}
