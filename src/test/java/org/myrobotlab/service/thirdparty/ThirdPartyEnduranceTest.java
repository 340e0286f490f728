package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.Slow;
import org.SEAR.protocol.scip.HokuyoModel;
import org.junit.After;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;
import org.myrobotlab.service.Runtime;
import org.myrobotlab.service.SEAR;

/**
 * Three drivers of others at once, for a Create 2, a Hokuyo URG-04LX and a u-blox NEO-M8N on one robot. They are killed in the middle of their work
 * and come back, {@code sear.driverRestarts} times, and then run for {@code sear.driverSeconds}: 20 and 600 for the long run.
 */
@Category(Slow.class)
public class ThirdPartyEnduranceTest {
    private static final Path SCRIPTS = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("src/test/drivers");
    private static final int KILLS = Integer.getInteger("sear.driverRestarts", 2);
    private static final String SCANNER = "/dev/SEAR_LIDAR_01";
    private static final String RECEIVER = "/dev/SEAR_GPS_01";
    private static final String ROBOT = "/dev/SEAR_Robot_01";
    private static final int VALUES = 682;
    private static final int SOLUTIONS_A_SECOND = 5;
    private static final int STARTING = 15;

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();
    private Programs programs;
    private SEAR sear;

    @Before
    public void start() {
        programs = new Programs(folder);
        System.setProperty("sear.project", folder.getRoot().toPath().resolve("SEARproject").toString());
        System.setProperty("sear.headless", "true");
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
        sear = (SEAR) Runtime.start("sear", "SEAR");
        sear.startSimulation();
        sear.simSleep(1);
    }

    @After
    public void stop() {
        programs.end();
        sear.stopSimulation();
        Runtime.releaseService("sear");
        System.clearProperty("sear.project");
        System.clearProperty("sear.headless");
    }

    private Process python(String script, String port, int count) throws IOException {
        ProcessBuilder builder = new ProcessBuilder("python3", "-u", SCRIPTS.resolve(script).toString(), port, Integer.toString(count));
        builder.environment().put("PYTHONPATH", System.getProperty("sear.drivers"));
        return programs.start(builder);
    }

    private Path grabber(String log) throws IOException {
        String text = Files.readString(SCRIPTS.resolve("hokuyo-mrpt.ini")).replace("@PORT@", sear.exportPort(SCANNER)).replace("@RATE@", "10")
            .replace("@OUTPUT@", folder.getRoot().toPath().resolve(log).toString());
        return Files.writeString(folder.newFile().toPath(), text);
    }

    @Test
    public void threeDriversAreKilledComeBackAndLoseNothing() throws Exception {
        for (int kill = 0; kill < KILLS; kill++) {
            Process robot = python("pycreate2_drive.py", sear.exportPort(ROBOT), Programs.PATIENCE);
            Process receiver = python("pyubx2_read.py", sear.exportPort(RECEIVER), Programs.PATIENCE);
            Process scanner = programs.start(new ProcessBuilder("rawlog-grabber", grabber("killed" + kill).toString()));
            programs.untilItTells(robot, "\\d+ mode .*");
            programs.untilItTells(receiver, "35\\.3.*");
            programs.untilItTells(scanner, ".*Saved [1-9].*");
            for (Process driver : new Process[] {robot, receiver, scanner}) {
                driver.destroyForcibly().waitFor();
            }
            sear.power("receiver", false);      // it was left at another rate, without NMEA: a user presses its button
            sear.power("receiver", true);
        }
        Process robot = python("pycreate2_drive.py", sear.exportPort(ROBOT), Programs.SECONDS);
        Process receiver = python("pyubx2_read.py", sear.exportPort(RECEIVER), SOLUTIONS_A_SECOND * Programs.SECONDS);
        List<String[]> scans = programs.grabScans(grabber("log"), STARTING);
        scans.forEach(line -> assertEquals(1 + 2 * VALUES, line.length));
        assertTrue("only " + scans.size() + " scans", scans.size() >= Programs.SECONDS * 5);
        List<String> driven = programs.read(robot, Programs.PATIENCE);
        assertEquals(String.join("\n", driven.subList(Math.max(0, driven.size() - 5), driven.size())), 0, robot.waitFor());
        List<String> solved = programs.read(receiver, Programs.PATIENCE);
        assertEquals(solved.get(solved.size() - 1), 0, receiver.waitFor());
        assertEquals(2 + SOLUTIONS_A_SECOND * Programs.SECONDS, solved.size());
    }
}
