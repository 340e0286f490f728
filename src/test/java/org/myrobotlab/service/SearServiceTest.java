// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNotNull;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertSame;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;
import static org.junit.Assert.fail;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Dynamics;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Wheel;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.myrobotlab.serial.PortClock;
import org.myrobotlab.serial.SerialDeviceFactory;
import org.myrobotlab.serial.VirtualSerialPort;
import org.myrobotlab.service.sear.SensorReading;

/** The SEAR service on a small world in lock-step. */
public class SearServiceTest {
    private static final double STRAIGHT = Double.POSITIVE_INFINITY;

    @Rule
    public final ServiceFolder temporary = new ServiceFolder();

    private Path folder;
    private SEAR sear;
    private Heard heard;

    @Before
    public void start() {
        folder = TestWorld.build(temporary.getRoot().toPath());
        sear = (SEAR) Runtime.start("testSear", "SEAR");
        heard = (Heard) Runtime.start("searStatus", "Heard");
        sear.addListener("publishStatus", "searStatus", "onStatus");
    }

    private void assertFails(String message, Runnable call) throws InterruptedException {
        try {
            call.run();
            fail("no error: " + message);
        } catch (IllegalStateException | IllegalArgumentException e) {
            assertTrue(e.getMessage(), e.getMessage().contains(message));
        }
        assertTrue(heard.getStatuses().toString(), heard.awaitStatus(message.split("\n")[0]));
    }

    @Test
    public void inLockStepTimePassesOnlyInSimSleepAndStep() {
        sear.startSimulation();
        assertEquals(0, sear.getTime(), 0);
        sear.simSleep(1);
        assertEquals(1, sear.getTime(), 1e-6);
        sear.step(6);
        assertEquals(1.1, sear.getTime(), 1e-6);
        for (int i = 0; i < 100; i++) {
            sear.simSleep(0.01);
        }
        assertEquals(2.1, sear.getTime(), 0.02);
    }

    @Test
    public void theRobotFollowsDriveCalls() {
        sear.startSimulation();
        sear.simSleep(1);
        double start = sear.getOdomResult();
        sear.drive(0.3, STRAIGHT);
        sear.simSleep(3);
        sear.drive(0, STRAIGHT);
        sear.simSleep(1);
        assertEquals(0.9, sear.getOdomResult() - start, 0.03);
        assertEquals(0.9, sear.getPose("roomba")[2], 0.05);
        assertEquals(sear.getOdomResult(), sear.getOdomResult("roomba"), 0);
        assertArrayEquals("a Dynamics is where its robot is", sear.getPose("roomba"), sear.getPose("drive"), 1e-9);
        assertEquals(sear.getPose("roomba")[2] + TestWorld.LIDAR_Z, sear.getPose("scanner")[2], 1e-3);
    }

    /** As at the end of MyRobotLab, which releases services one by one and the simulation last. */
    @Test
    public void aDeviceWhoseUartIsClosedFirstIsSilent() throws Exception {
        sear.startSimulation();
        Serial uart = (Serial) Runtime.getService("receiver_GPSsimulator_Serial_Service");
        uart.addListener("publishStatus", "searStatus", "onStatus");
        uart.disconnect();
        sear.simSleep(3);
        uart.info("after three fixes");
        assertTrue(heard.awaitStatus("after three fixes"));
        assertFalse(heard.getStatuses().toString(), heard.getStatuses().toString()
            .matches("(?s).*(closed port|did not reach).*"));
    }

    @Test
    public void anOdometerObjectIsClearedWhenRead() throws Exception {
        TestWorld.write(folder, "robot/counter.xml", "<Odometer><name>counter</name></Odometer>");
        Path robot = folder.resolve("robot/roomba.xml");
        Files.writeString(robot, Files.readString(robot).replace("<component>gyro</component>",
            "<component>gyro</component><component>counter</component>"));
        sear.startSimulation();
        sear.simSleep(1);
        sear.getOdomResult();
        sear.drive(0.3, STRAIGHT);
        sear.simSleep(3);
        sear.drive(0, STRAIGHT);
        sear.simSleep(1);
        assertEquals(0.9, sear.getOdomResult(), 0.03);
        assertEquals(0, sear.getOdomResult(), 0);
    }

    @Test
    public void theRobotDrivesByTheRoombaProtocol() throws Exception {
        sear.startSimulation();
        sear.simSleep(1);
        Serial serial = (Serial) Runtime.start("testSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        serial.write(FarEnd.bytes("80 83 89 00 C8 80 00"));
        sear.simSleep(2);
        serial.write(FarEnd.bytes("89 00 00 00 00"));
        sear.simSleep(1);
        assertEquals(0.4, sear.getPose("roomba")[2], 0.04);
    }

    @Test
    public void sensorsAnswerInTheDissertationsTypesAndUnits() {
        sear.startSimulation();
        sear.simSleep(1);
        assertEquals(TestWorld.WALL - 0.15, sear.getDistanceResult("ping"), 0.02);
        assertEquals(90, sear.getCompassResult("compass"), 0.5);
        assertEquals(3, sear.getAccelResult("accel").split(",").length);
        assertEquals(0, Double.parseDouble(sear.getGyroResult("gyro").split(",")[1]), 0.01);
        assertArrayEquals(new double[] {33.61, -80.865, 182.5}, sear.getGpsResult("receiver"), 0.2);
        float[] scan = sear.getLidarResult("scanner");
        assertEquals(181, scan.length);
        assertEquals(TestWorld.WALL - TestWorld.LIDAR_Z, scan[90], 0.01);
        assertEquals(8.191, scan[0], 1e-3);
        assertTrue(sear.getSensorNames()
            .containsAll(Arrays.asList("accel", "compass", "gyro", "ping", "receiver", "scanner")));
    }

    @Test
    public void aScanIsThereWhenSimSleepReturns() throws Exception {
        sear.startSimulation();
        sear.simSleep(1);
        LIDAR lidar = (LIDAR) Runtime.start("testLidar", "LIDAR");
        lidar.connect(TestWorld.LIDAR_PORT, 38400);
        lidar.setScanMode(180, 1);
        lidar.singleScan();
        sear.simSleep(2);
        assertNotNull(heard.getStatuses().toString(), lidar.getLastScan());
        assertEquals(181, lidar.getLastScan().raw.length);
        assertEquals(TestWorld.WALL - TestWorld.LIDAR_Z, lidar.getLastScan().metres[90], 0.011);
        assertNull(lidar.getLastScan().metres[0]);
    }

    @Test
    public void aLidarLeftAtAnotherRateIsFoundInSimulatedTime() throws Exception {
        sear.startSimulation();
        LIDAR lidar = (LIDAR) Runtime.start("testLidar", "LIDAR");
        lidar.connect(TestWorld.LIDAR_PORT, 9600);
        lidar.singleScan();
        sear.simSleep(30);
        assertNotNull(heard.getStatuses().toString(), lidar.getLastScan());
        assertFalse("probing is not the user's: " + heard.getStatuses(), heard.getStatuses().toString()
            .contains("was set to"));
    }

    @Test
    public void anotherBaudRateThanTheDevicesIsReported() throws Exception {
        sear.startSimulation();
        Serial serial = (Serial) Runtime.start("testSerial", "Serial");
        serial.connect(TestWorld.LIDAR_PORT, 9600, 8, 1, 0);
        assertTrue(heard.awaitStatus("warn: LIDAR scanner talks at 38400 baud, but port " + TestWorld.LIDAR_PORT
            + " was set to 9600"));
    }

    @Test
    public void connectingToTheDevicesEndReportsTheRightPort() {
        sear.startSimulation();
        LIDAR lidar = (LIDAR) Runtime.start("testLidar", "LIDAR");
        IOException e = assertThrows(IOException.class, () -> lidar.connect("/dev/my_Lidar01"));
        assertTrue(e.getMessage(), e.getMessage().endsWith("it is the simulated device's own end, connect to "
            + TestWorld.LIDAR_PORT));
    }

    @Test
    public void theBaudRateFollowsTheSimulatedDevice() throws Exception {
        sear.startSimulation();
        LIDAR lidar = (LIDAR) Runtime.start("testLidar", "LIDAR");
        lidar.connect(TestWorld.LIDAR_PORT, 38400);
        lidar.setBaud(9600);
        lidar.setToCM();
        lidar.singleScan();
        sear.simSleep(20);
        assertNotNull(heard.getStatuses().toString(), lidar.getLastScan());
        assertEquals("cm", lidar.getUnit());
        assertEquals(9600, lidar.getConfig().baud);
    }

    @Test
    public void onlyOneSimulationRunsAtATime() {
        sear.startSimulation();
        SEAR other = (SEAR) Runtime.start("otherSear", "SEAR");
        try {
            other.startSimulation();
            fail("two simulations");
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("service testSear runs a simulation"));
        } finally {
            Runtime.releaseService("otherSear");
        }
        assertTrue(sear.isSimulating());
        sear.simSleep(0.1);
    }

    @Test
    public void aReleaseDuringASleepRaisesInTheScript() throws Exception {
        System.setProperty("sear.speed", "1");
        sear.startSimulation();
        String[] end = new String[1];
        Thread script = new Thread(() -> {
            try {
                sear.simSleep(1000);
            } catch (IllegalStateException e) {
                end[0] = e.getMessage();
            }
        });
        script.start();
        sear.startPublishing("ping", 10);
        sear.addListener("publishReading", "searStatus", "onValue");
        heard.await(2);
        Runtime.releaseService("testSear");
        script.join(60_000);
        assertEquals("the simulation was stopped", end[0]);
    }

    @Test
    public void thePositionComesFromTheSimulatedReceiver() throws Exception {
        sear.startSimulation();
        org.myrobotlab.service.GPS gps = (org.myrobotlab.service.GPS) Runtime.start("testGps", "GPS");
        gps.connect(TestWorld.GPS_PORT, 38400);
        sear.simSleep(3);
        assertNotNull(gps.getLastFix());
        assertEquals(33.61, gps.getLastFix().latitude, 1e-5);
        assertTrue(gps.getLastFix().tokens[4], gps.getLastFix().tokens[4].matches("-08051[.](8999|9000)\\d*"));
    }

    @Test
    public void theDevicesSerialServicesAreInTheRegistry() {
        sear.startSimulation();
        for (String name : new String[] {"scanner_LIDARsimulator_Serial_Service",
            "receiver_GPSsimulator_Serial_Service", "drive_ROBOTsimulator_Serial_Service"}) {
            assertNotNull(name, Runtime.getService(name));
        }
        sear.stopSimulation();
        assertNull(Runtime.getService("scanner_LIDARsimulator_Serial_Service"));
    }

    @Test
    public void stoppingLeavesNeitherThreadNorPort() throws Exception {
        sear.startSimulation();
        Serial serial = (Serial) Runtime.start("testSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        sear.simSleep(0.5);
        sear.stopSimulation();
        assertFalse(serial.isConnected());
        assertNull(SerialDeviceFactory.get(TestWorld.ROOMBA_PORT));
        Runtime.releaseService("testSear");
        TestWorld.assertNoThreads();
    }

    @Test
    public void itCanBeStartedAgain() throws Exception {
        for (int round = 0; round < 3; round++) {
            sear.startSimulation();
            Serial serial = (Serial) Runtime.start("testSerial", "Serial");
            serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
            serial.write(FarEnd.bytes("80 83 89 00 C8 80 00"));
            sear.simSleep(1);
            assertTrue(sear.getOdomResult() > 0.1);
            sear.stopSimulation();
        }
    }

    @Test
    public void resetIsAFreshStart() throws Exception {
        sear.startSimulation();
        sear.simSleep(1);
        sear.drive(0.2, STRAIGHT);
        sear.simSleep(1);
        double[] first = sear.getPose("roomba");
        sear.reset();
        assertEquals(0, sear.getTime(), 0);
        PortClock ofPort = ((VirtualSerialPort) SerialDeviceFactory.get(TestWorld.GPS_PORT)).getClock();
        assertSame("time-outs of drivers go on with the steps", PortClock.current(), ofPort);
        sear.simSleep(1);
        sear.drive(0.2, STRAIGHT);
        sear.simSleep(1);
        assertArrayEquals(first, sear.getPose("roomba"), 0);
    }

    @Test
    public void warningsAreRepeatedAfterAReset() throws Exception {
        sear.startSimulation();
        Serial serial = (Serial) Runtime.start("testSerial", "Serial");
        serial.connect(TestWorld.ROOMBA_PORT, 57600, 8, 1, 0);
        serial.write(FarEnd.bytes("80 01"));
        sear.simSleep(0.5);
        assertTrue(heard.awaitStatus("opcode 1 does not exist"));
        sear.reset();
        serial.write(FarEnd.bytes("80 01 01"));
        sear.simSleep(0.5);
        assertTrue(heard.awaitStatus("opcode 1 does not exist", 2));
        assertEquals("those of one cause are counted", 2, heard.getStatuses().stream().filter(status ->
            status.contains("opcode 1 does not exist")).count());
    }

    @Test
    public void mistakesAreErrorsAndTheSimulationContinues() throws Exception {
        assertFails("no simulation runs", sear::stopSimulation);
        assertFails("no simulation runs", () -> sear.getDistanceResult("ping"));
        sear.startSimulation();
        assertFails("the simulation runs already", sear::startSimulation);
        assertFails("pong", () -> sear.getDistanceResult("pong"));
        assertFails("ping", () -> sear.getDistanceResult("pong"));
        assertFails("sensor compass is a Compass, not a Distance", () -> sear.getDistanceResult("compass"));
        assertFails("nothing is named \"nobody\"", () -> sear.getPose("nobody"));
        assertFails("there is no robot \"nobody\"", () -> sear.drive("nobody", 1, 1));
        assertFails("speed is 0.0, legal: 0.001 or more", () -> sear.setSpeed(0));
        assertFails("speed is 1.0E-9, legal: 0.001 or more", () -> sear.setSpeed(1e-9));
        assertFails("the path is \"a?b.searlog\", legal: a valid file name on this system (Nul character not allowed)",
            () -> sear.recordRun("a\0b"));
        assertFails("simSleep of -1", () -> sear.simSleep(-1));
        assertFails("newProject needs the simulation to be stopped", sear::newProject);
        assertFails("there is no template \"mine.py\"", () -> sear.copyTemplate("mine.py", "."));
        assertFails("the folder is missing", () -> sear.copyTemplate("controller.py", null));
        assertFails("the name is missing", () -> sear.getDistanceResult(null));
        assertFails("the name is missing", () -> sear.getPose(null));
        assertFails("the path is missing", () -> sear.saveProject(null));
        sear.simSleep(0.5);
        assertTrue(sear.isSimulating());
        assertEquals(0.5, sear.getTime(), 1e-6);
    }

    @Test
    public void aMissingProjectFolderIsNamed() throws Exception {
        sear.newProject();
        assertFails("there is no project folder " + folder, sear::startSimulation);
        assertFalse(sear.isSimulating());
    }

    @Test
    public void allProblemsOfAProjectAreListed() throws Exception {
        TestWorld.write(folder, "environment/cut.xml", "<Box name=\"cut\"><mass>1");
        TestWorld.write(folder, "environment/bad.xml", "<Nonsense/>");
        try {
            sear.startSimulation();
            fail("started");
        } catch (IllegalStateException e) {
            assertTrue(e.getMessage(), e.getMessage().contains("cut.xml"));
            assertTrue(e.getMessage(), e.getMessage().contains("bad.xml"));
        }
        assertEquals(2, sear.getProblems().stream().map(problem -> problem.file).distinct().count());
        assertEquals(sear.getProblems().toString(), sear.checkProject().get("problems").toString());
    }

    @Test
    public void theRequestedNumberOfReadingsIsPublished() throws Exception {
        sear.startSimulation();
        sear.addListener("publishReading", "searStatus", "onValue");
        sear.startPublishing("ping", 10);
        sear.simSleep(1);
        sear.stopPublishing("ping");
        sear.simSleep(1);
        List<Object> readings = heard.await(10);
        assertEquals(10, readings.size(), 1);
        assertEquals("ping", ((SensorReading) readings.get(0)).name);
        assertEquals(TestWorld.WALL - 0.15, (Double) ((SensorReading) readings.get(5)).value, 0.05);
    }

    @Test
    public void panelsGetTheStateOfTheWorld() throws Exception {
        assertEquals(Boolean.FALSE, sear.publishSimulation().get("running"));
        sear.startSimulation();
        sear.simSleep(0.5);
        sear.addListener("publishSimulation", "searStatus", "onValue");
        Map<?, ?> state = (Map<?, ?>) heard.await(1).get(0);
        assertEquals(0.5, (Double) state.get("time"), 1e-6);
        assertEquals(2, ((List<?>) state.get("objects")).size());
        assertEquals(6, ((List<?>) state.get("sensors")).size());
        assertEquals("roomba", ((Map<?, ?>) ((List<?>) state.get("robots")).get(0)).get("name"));
    }

    @Test
    public void panelsGetThePreviewAndItsChanges() throws Exception {
        Map<String, Object> first = sear.getPreview("");
        Map<?, ?> world = (Map<?, ?>) first.get("world");
        assertEquals(2, ((List<?>) world.get("objects")).size());
        assertEquals(6, ((List<?>) world.get("sensors")).size());
        assertSame("nothing is made anew as long as nothing has changed", first, sear.getPreview(""));
        assertEquals(Map.of("stamp", first.get("stamp")), sear.getPreview((String) first.get("stamp")));
        TestWorld.write(folder, "environment/bad.xml", "<Nonsense/>");
        Map<String, Object> broken = sear.getPreview((String) first.get("stamp"));
        assertNotEquals(first.get("stamp"), broken.get("stamp"));
        assertNull(broken.get("world"));
        assertEquals(1, ((List<?>) broken.get("problems")).size());
        Files.delete(folder.resolve("environment/bad.xml"));
        sear.startSimulation();
        assertEquals("a running world is published another way", Map.of(), sear.getPreview(""));
        sear.stopSimulation();
        sear.newProject();
        assertEquals(List.of(), ((Map<?, ?>) sear.getPreview("").get("world")).get("objects"));
    }

    @Test
    public void projectsAreSavedAndLoaded() throws Exception {
        Path bundle = temporary.getRoot().toPath().resolve("test.sear");
        sear.saveProject(bundle.toString());
        assertTrue(Files.size(bundle) > 0);
        Path longest = Files.createFile(bundle.resolveSibling("y".repeat(250) + ".sear"));
        assertEquals("a name beside it is too long", false, sear.saveProjectAs(longest.toString(), false).get("saved"));
        String backup = sear.newProject();
        assertTrue(backup, Files.isDirectory(Path.of(backup)));
        assertFalse(Files.exists(folder.resolve("environment/wall.xml")));
        sear.loadProject(bundle.toString());
        sear.startSimulation();
        assertTrue(sear.getSensorNames().contains("ping"));
    }

    @Test
    public void aWarningReportsADroppedBackup() throws Exception {
        for (int i = 0; i < 2; i++) {
            Path map = Files.createDirectories(folder.resolve("assets")).resolve("map.tif");
            try (RandomAccessFile file = new RandomAccessFile(map.toFile(), "rw")) {
                file.setLength((600 << 20) + i);
            }
            assertTrue(Files.isDirectory(Path.of(sear.newProject())));
        }
        assertTrue(heard.getStatuses().toString(),
            heard.awaitStatus("was removed: SEAR keeps the last 10 backups of a project, at most 1024 MB"));
    }

    @Test
    public void aRobotIsPlacedTwiceAndAFolderIsLoaded() throws Exception {
        Path bundle = temporary.getRoot().toPath().resolve("rover.sear");
        sear.saveProject(bundle.toString());
        assertEquals("roomba_2", sear.importRobot(bundle.toString(), "roomba"));
        assertTrue(heard.getStatuses().toString(), heard.awaitStatus("imported \"roomba\" as \"roomba_2\""));
        assertTrue(sear.importEnvironment(bundle.toString()).contains("wall_2"));
        sear.startSimulation();
        assertTrue(sear.getSensorNames().toString(), sear.getSensorNames()
            .containsAll(List.of("roomba/ping", "roomba_2/ping")));
        assertEquals(sear.getReading("roomba_2/ping"), sear.getDistanceResult("roomba_2/ping"));
        assertEquals("m", sear.getSensorUnit("roomba/ping"));
        assertEquals(6, sear.getPose("roomba_2/drive").length);
        String choices = "\"ping\" is on roomba and roomba_2: use \"roomba/ping\" or \"roomba_2/ping\"";
        assertFails(choices, () -> sear.getReading("ping"));
        assertFails(choices, () -> sear.getPose("ping"));
        assertFails(choices, () -> sear.startPublishing("ping", 10));
        assertFails("no sensor is called \"nobody/ping\", legal: ", () -> sear.startPublishing("nobody/ping", 10));
        sear.startPublishing("roomba/ping", 10);
        sear.stopPublishing("roomba/ping");
        for (String device : List.of("roomba_scanner_LIDAR", "roomba_2_scanner_LIDAR")) {
            assertNotNull(device, Runtime.getService(device + "simulator_Serial_Service"));
        }
        sear.stopSimulation();
        String backup = sear.newProject();
        sear.loadProject(backup);
        assertTrue(Files.exists(folder.resolve("robot/roomba_2.xml"))
            && Files.exists(folder.resolve("environment/wall_2.xml")));
        assertFails("robot is \"nobody\"", () -> sear.importRobot(bundle.toString(), "nobody"));
    }

    /** Two robots have a "scanner" and a third has a "roomba_scanner": each port leads to its own device. */
    @Test
    public void aPartNamedLikeRobotAndPartHasItsOwnService() throws Exception {
        Path bundle = temporary.getRoot().toPath().resolve("rover.sear");
        sear.saveProject(bundle.toString());
        sear.importRobot(bundle.toString(), "roomba");
        SEARrobot third = new SEARrobot("third");
        Dynamics drive = new Dynamics("third drive", 4);
        third.addComponent(drive);
        drive.move(5, 0.1, 0);
        third.addWheel(new Wheel("third wheel", 0.0381, 0.03));
        org.SEAR.POJOs.LIDAR lidar = new org.SEAR.POJOs.LIDAR("roomba_scanner");
        lidar.setPorts("/dev/my_third", "/dev/third_scanner");
        third.addComponent(lidar);
        sear.startSimulation();
        for (String device : List.of("roomba_scanner_LIDAR", "roomba_scanner_2_LIDAR", "roomba_2_scanner_LIDAR")) {
            assertNotNull(device, Runtime.getService(device + "simulator_Serial_Service"));
        }
        String uart = ((Serial) Runtime.getService("roomba_scanner_LIDARsimulator_Serial_Service")).lastPortName;
        assertEquals("a name without a slash stays as it is", "/dev/my_third", uart);
        assertEquals("/dev/my_Lidar01",
            ((Serial) Runtime.getService("roomba_scanner_2_LIDARsimulator_Serial_Service")).lastPortName);
    }

    @Test
    public void savingAndLoadingALargeProjectReportProgress() throws Exception {
        Path bundle = temporary.getRoot().toPath().resolve("large.sear");
        Files.createDirectories(folder.resolve("assets"));
        Files.write(folder.resolve("assets/large.dat"), new byte[20 << 20]);
        sear.saveProject(bundle.toString());
        sear.loadProject(bundle.toString());
        for (String what : new String[] {"saving", "loading"}) {
            assertTrue(heard.getStatuses().toString(), heard.awaitStatus(what + " large.sear: 100 % of 20 MB ("));
            long told = heard.getStatuses().stream().filter(status -> status.contains(what + " large.sear: ")).count();
            assertTrue(heard.getStatuses().toString(), told >= 4 && told <= 10);
        }
    }

    @Test
    public void beamsPassThroughTheGroundWhenAskedTo() throws Exception {
        new Floor("floor", 40, 40, true);
        Distance low = new Distance("low", "PING)))");
        SEARrobot other = new SEARrobot("other");
        other.addComponent(new Dynamics("otherDrive", 4, 3, 0.1, -3, 0, 180, 0));
        other.addComponent(low);
        sear.startSimulation();
        assertTrue(heard.awaitStatus("sensor low sees the ground (floor) at 0.1"));
        assertEquals(0.17, sear.getDistanceResult("low"), 0.01);
        assertFails("setGroundVisible needs the simulation to be stopped", () -> sear.setGroundVisible(false));
        sear.stopSimulation();
        sear.setGroundVisible(false);
        sear.startSimulation();
        assertEquals(3, sear.getDistanceResult("low"), 1e-9);
    }

    @Test
    public void sensorsMeasureOnTheRequestedNumberOfThreads() throws Exception {
        for (int threads : new int[] {0, 257}) {
            assertFails("threads is " + threads + ", legal: 1 to 256", () -> sear.setThreads(threads));
        }
        sear.setThreads(1);
        sear.startSimulation();
        assertEquals(0, sear.getTime(), 1);
        sear.setThreads(3);
        sear.stopSimulation();
        System.setProperty("sear.threads", "all");
        try {
            assertFails("sear.threads is \"all\", legal: 1 to 256", () -> sear.startSimulation());
        } finally {
            System.clearProperty("sear.threads");
        }
    }

    @Test
    public void templatesAreCopiedOnce() throws Exception {
        String copy = sear.copyTemplate("controller.py", folder.toString());
        assertTrue(Files.readString(Path.of(copy)).startsWith("# controller.py"));
        assertFails("already exists", () -> sear.copyTemplate("controller.py", folder.toString()));
    }

    @Test
    public void anotherProgramDrivesTheRobotOverAnExportedPort() throws Exception {
        System.setProperty("sear.speed", "5");
        sear.startSimulation();
        int number = sear.exportTcp(TestWorld.ROOMBA_PORT, 0);
        try (java.net.Socket client = new java.net.Socket(java.net.InetAddress.getLoopbackAddress(), number)) {
            client.getOutputStream().write(FarEnd.bytes("80 83 89 00 C8 80 00"));
            sear.simSleep(3);
            client.getOutputStream().write(FarEnd.bytes("8E 13"));
            byte[] distance = client.getInputStream().readNBytes(2);
            assertTrue((distance[0] & 0xFF) * 256 + (distance[1] & 0xFF) > 100);
        }
        assertTrue(sear.getOdomResult() > 0.1);
    }

    @Test
    public void anUnchangedExampleNeedsNoBackup() {
        assertNotNull(sear.newProject());
        sear.loadProject("examples/office.sear");
        sear.startSimulation();
        sear.simSleep(0.1);
        sear.stopSimulation();
        assertNull(sear.newProject());
    }
}
