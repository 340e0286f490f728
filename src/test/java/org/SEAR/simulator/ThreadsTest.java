// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Collectors;
import org.SEAR.Digests;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.SEAR.record.Recorder;
import org.SEAR.sensors.LidarScan;
import org.SEAR.sensors.Reading;
import org.junit.Rule;
import org.junit.Test;

/** The results do not depend on the number of measuring threads. */
public class ThreadsTest {
    private static final int LIDARS = 4;
    private static final int STEPS = 150;
    /** LMS200: send all scans. */
    private static final byte[] ALL_SCANS = {0x02, 0x00, 0x02, 0x00, 0x20, 0x24, 0x34, 0x08};
    private static final byte[] COLA_SCANS = "\2sEN LMDscandata 1\3".getBytes(StandardCharsets.US_ASCII);
    private static final byte[] SCIP_SCANS = "BM\nMS0044072501000\n".getBytes(StandardCharsets.US_ASCII);
    private static final byte[] RPLIDAR_SCANS = {(byte) 0xA5, 0x20};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private static LIDAR lidar(SEARrobot robot, String name, double resolution) {
        LIDAR lidar = new LIDAR(name, 8, 180, resolution, 0, 0.3, 0);
        lidar.setNoise(new Noise().setWhite(0.01).setDropout(0.05).setDrift(0.01));
        robot.addComponent(lidar);
        return lidar;
    }

    private static void scanner(SEARrobot robot, String model) {
        LIDAR scanner = new LIDAR(model);
        scanner.setModel(model);
        scanner.move(0, 0.25, 0.1);
        scanner.setNoise(new Noise().setWhite(0.01));
        scanner.setPorts(model + "Uart", model + "User");
        robot.addComponent(scanner);
    }

    private static void camera(SEARrobot robot, String name, String kind) {
        Camera camera = new Camera(name, 0, 0.3, 0);
        camera.setKind(kind);
        camera.setSize(64, 48);
        camera.setNoise(new Noise().setWhite(0.5).setDropout(0.01));
        robot.addComponent(camera);
    }

    private static void world() {
        new Floor("floor", 50, 50);
        for (int i = 0; i < 12; i++) {
            new Box("box" + i, 0.3, 0.6, 0.3, i % 2).move(2.5 * Math.sin(i), 0.3, 2.5 * Math.cos(i));
        }
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 20);
        for (int i = 0; i < LIDARS; i++) {
            lidar(robot, "lidar" + i, 0.25 + 0.05 * i);
        }
        LIDAR lms = lidar(robot, "LMS200", 0.5);
        lms.setPorts("lmsUart", "lmsUser");
        scanner(robot, "LMS111");
        scanner(robot, "URG-04LX");
        scanner(robot, "RPLIDAR-A1");
        robot.addComponent(new Distance("ping", "PING)))"));
        GPS gps = new GPS("gps", 48, 300, 11, "gpsUart", "gpsUser");
        gps.setNoise(new Noise().setWhite(1));
        robot.addComponent(gps);
        camera(robot, "eye", Camera.COLOR);
        camera(robot, "depth", Camera.DEPTH);
    }

    private static void ask(SerialLine line) {
        switch (line.getObjectName()) {
            case "roomba/LMS200":
            case "LMS200":
                line.write(ALL_SCANS);
                break;
            case "LMS111":
                line.write(COLA_SCANS);
                break;
            case "URG-04LX":
                line.write(SCIP_SCANS);
                break;
            case "RPLIDAR-A1":
                line.write(RPLIDAR_SCANS);
                break;
            default:
                assertEquals("gps", line.getObjectName());
        }
    }

    /**
     * Returns digests of the readings, of each line's telegrams and of the record, then the number of shared pieces of
     * work.
     */
    private List<String> run(int threads) throws Exception {
        Path record = project.getRoot().toPath().resolve("run" + threads + ".searlog");
        MessageDigest readings = Digests.sha256();
        List<MessageDigest> telegrams = new ArrayList<>();
        List<String> found = new ArrayList<>();
        try (Simulation simulation = Worlds.start(project)) {
            simulation.setThreads(threads);
            long[] bytes = new long[simulation.getLines().size()];
            for (SerialLine line : simulation.getLines()) {
                MessageDigest digest = Digests.sha256();
                int number = telegrams.size();
                telegrams.add(digest);
                line.setSink((each, starts) -> {
                    digest.update(each);
                    bytes[number] += each.length;
                });
            }
            simulation.getSensorNames().stream().filter(name -> name.startsWith("lidar"))
                .forEach(name -> simulation.watch(name, true));
            Recorder recorder = Recorder.begin(simulation, record, 100_000_000, 10, message -> { });
            simulation.post(world -> world.getRobots().get(0).drive(0.4, 1));
            for (int step = 0; step < STEPS; step++) {
                if (step == 10) {
                    simulation.getLines().forEach(ThreadsTest::ask);
                }
                simulation.step();
                if (step % 7 == 0) {
                    simulation.read(simulation.getSensorNames()).forEach(reading -> Digests.put(readings, reading));
                }
                simulation.snapshot().readings.values().forEach(reading -> Digests.put(readings, reading));
            }
            recorder.end();
            for (int i = 0; i < bytes.length; i++) {
                assertTrue(simulation.getLines().get(i).getObjectName() + " sends", bytes[i] > 100);
            }
            assertEquals(threads + " threads", threads > 1, simulation.getWorld().getWorkers().getShared() > STEPS);
        }
        found.add("readings " + Digests.hex(readings));
        telegrams.forEach(digest -> found.add("telegrams " + Digests.hex(digest)));
        found.add("record " + Digests.hex(record));
        return found;
    }

    @Test
    public void theSameComesOutOfOneTwoAndFourThreads() throws Exception {
        world();
        List<String> expected = run(1);
        assertEquals(1 + 5 + 1, expected.size());
        assertEquals(expected, run(2));
        assertEquals(expected, run(4));
    }

    /** Scanners that send all the time, enough of them for threads to pay off. */
    @Test
    public void scansOfDevicesAreMeasuredInParallel() throws Exception {
        new Floor("floor", 50, 50);
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        for (int i = 0; i < 5; i++) {
            lidar(robot, "lidar" + i, 0.5).setPorts("uart" + i, "user" + i);
        }
        try (Simulation simulation = Worlds.start(project)) {
            simulation.setThreads(2);
            for (SerialLine line : simulation.getLines()) {
                line.setSink((bytes, starts) -> { });
                line.write(ALL_SCANS);
            }
            Worlds.run(simulation, 2);
            long before = simulation.getWorld().getWorkers().getShared();
            Worlds.run(simulation, 5);
            long scans = simulation.getWorld().getWorkers().getShared() - before;
            assertTrue(scans + " scans of 5 scanners in 5 s, each of 722 bytes at 960 a second", scans >= 5 * 5
                && scans <= 5 * 8);
        }
    }

    @Test
    public void fewBeamsAreNotShared() throws Exception {
        SEARrobot robot = Worlds.roomba("roomba", 0, 0, 0);
        new Floor("floor", 50, 50);
        lidar(robot, "right", 1);
        lidar(robot, "left", 1);
        try (Simulation simulation = Worlds.start(project)) {
            simulation.setThreads(4);
            simulation.step();
            assertEquals(2, simulation.read(List.of("left", "right")).size());
            assertEquals(0, simulation.getWorld().getWorkers().getShared());
        }
    }

    @Test
    public void aSensorThatIsAskedForTwiceMeasuresOnce() throws Exception {
        world();
        try (Simulation simulation = Worlds.start(project)) {
            simulation.setThreads(2);
            simulation.step();
            List<Reading> readings = simulation.read(List.of("lidar0", "lidar1", "lidar2", "lidar0", "lidar2"));
            assertEquals(5, readings.size());
            assertEquals(3, simulation.getWorld().getWorkers().getShared());
            assertTrue(readings.get(0) == readings.get(3) && readings.get(2) == readings.get(4)
                && readings.get(0) == simulation.read("lidar0"));
            simulation.read(List.of("lidar0", "lidar1", "lidar2"));
            assertEquals("they are measured already", 3, simulation.getWorld().getWorkers().getShared());
        }
    }

    @Test
    public void anUnknownSensorAmongOthersIsNamed() throws Exception {
        world();
        try (Simulation simulation = Worlds.start(project)) {
            String one = assertThrows(IllegalArgumentException.class, () -> simulation.read("nobody")).getMessage();
            assertEquals(one, assertThrows(IllegalArgumentException.class,
                () -> simulation.read(List.of("lidar0", "nobody"))).getMessage());
            LidarScan scan = (LidarScan) simulation.read(List.of("lidar0")).get(0);
            assertArrayEquals(scan.ranges(), ((LidarScan) simulation.read("lidar0")).ranges(), 0);
        }
    }

    @Test(timeout = 600_000)
    public void noThreadIsLeftBehind() throws Exception {
        world();
        Set<Thread> others = workers();
        Set<Thread> own;
        try (Simulation simulation = Worlds.start(project)) {
            simulation.setThreads(4);
            simulation.step();
            simulation.read(simulation.getSensorNames());
            own = workers();
            own.removeAll(others);
            assertEquals(own.toString(), 3, own.size());
        }
        while (own.stream().anyMatch(Thread::isAlive)) {
            LockSupport.parkNanos(1000);
        }
    }

    private static Set<Thread> workers() {
        return Thread.getAllStackTraces().keySet().stream().filter(thread -> thread.getName().startsWith("SEAR worker"))
            .collect(Collectors.toSet());
    }
}
