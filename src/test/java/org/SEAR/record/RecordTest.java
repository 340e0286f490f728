// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CancellationException;
import java.util.concurrent.TimeUnit;
import org.SEAR.Fuzz;
import org.SEAR.POJOs.Accelerometer;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.ColorSensor;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Cylinder;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.SearObject;
import org.SEAR.Slow;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.DriveCommand;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.SimulationRunner;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/** Records of runs: their content, reruns to the byte, and the handling of invalid files. */
@Category(Slow.class)
public class RecordTest {
    private static final byte[] FULL_MODE = {(byte) 0x80, (byte) 0x84};
    private static final byte[] AHEAD = {(byte) 0x89, 0, (byte) 0xC8, (byte) 0x80, 0};
    private static final byte[] SENSORS = {(byte) 0x8E, 0};
    private static final byte[] STREAM = {(byte) 0x94, 3, 7, 19, 20};
    private static final byte[] DIGITAL_WRITE = {(byte) 0xAA, 3, 0x1B, 13, 1};
    private static final byte[] READ_PIN = {(byte) 0xAA, 5, 4, 14, 1, 0, 0};
    private static final byte[] SCAN = {2, 0, 2, 0, 0x30, 1, 0x31, 0x18};

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path file() {
        return project.getRoot().toPath().resolve("run.searlog");
    }

    private Simulation world(SearObject... more) throws Exception {
        new Floor("floor", 20, 20);
        new Box("wall", 0.1, 6, 0.5).move(3, 0.25, 0);
        new Cylinder("can", 0.05, 0.1, 0.3).move(1, 0.05, 0);
        SEARrobot robot = Robots.create("rover", "/dev/uart", "/dev/user");
        robot.rotate(0, 90, 0);
        Distance ping = new Distance("ping");
        ping.setNoise(new Noise(0.01));
        robot.addComponent(ping);
        LIDAR lidar = new LIDAR("lidar", 8, 180, 1, 0, 0.2, 0);
        lidar.setPorts("/dev/lidarUart", "/dev/lidarUser");
        lidar.setNoise(new Noise(0.01));
        robot.addComponent(lidar);
        GPS gps = new GPS("gps", 33.6, 182.5, -80.8);
        gps.setPorts("/dev/gpsUart", "/dev/gpsUser");
        robot.addComponent(gps);
        robot.addComponent(new Compass("compass"));
        robot.addComponent(new Accelerometer("accel"));
        for (SearObject each : more) {
            robot.addComponent(each);
        }
        return Simulation.of(Project.read(project.folder()), 7);
    }

    private static void run(Simulation world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private static SerialLine line(Simulation world, String object) {
        return world.getLines().stream().filter(line -> line.getObjectName().equals(object)).findFirst()
            .orElseThrow(AssertionError::new);
    }

    /** Drives by bytes and by calls, switches a device off and on, changes the baud rate and resets. */
    private static void drive(Simulation world) {
        run(world, 60);
        line(world, "drive").write(FULL_MODE);
        line(world, "drive").write(STREAM);
        run(world, 10);
        line(world, "drive").write(AHEAD);
        line(world, "lidar").write(SCAN);
        run(world, 90);
        line(world, "drive").setHostBaud(19200);
        line(world, "drive").write(SENSORS);
        run(world, 7);
        line(world, "drive").setHostBaud(57600);
        world.power("gps", false);
        run(world, 60);
        world.power("gps", true);
        line(world, "drive").write(SENSORS);
        run(world, 33);
        world.reset();
        world.post(DriveCommand.circle(0, 0.3, 1));
        run(world, 15);
        Pose there = Pose.ofDegrees(-2, 0, 1.5, 0, 30, 0);
        world.move("rover", there, there);
        world.move("can", there, Pose.ofDegrees(-1, 0.05, 1.5, 0, 0, 0));
        run(world, 15);
        world.post(DriveCommand.wheels(0, -0.1, 0.2));
        line(world, "lidar").write(SCAN);
        run(world, 100);
    }

    private Recorder recorded(Simulation world) throws Exception {
        Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
        drive(world);
        recorder.end();
        return recorder;
    }

    /** Returns the number of steps that the file has at this moment. */
    private int stepsOnDisk() throws IOException {
        if (Files.size(file()) == 0) {
            return -1;
        }
        int[] steps = {0};
        RunRecord.open(file()).read(new RunRecord.Visitor() {
            @Override
            public void step() {
                steps[0]++;
            }
        });
        return steps[0];
    }

    @Test
    public void eventsAreOnTheDiskDuringARecord() throws Exception {
        try (Simulation world = world()) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            long patience = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
            while (stepsOnDisk() < 0 && System.nanoTime() < patience) {
                Thread.yield();
            }
            assertEquals("its header, at once", 0, stepsOnDisk());
            while (stepsOnDisk() < 60 && System.nanoTime() < patience) {
                run(world, 10);
            }
            assertTrue("steps on the disk: " + stepsOnDisk(), stepsOnDisk() >= 60);
            assertTrue("that it is written", RunRecord.open(file()).isBeingWritten());
            String said = assertThrows(IOException.class,
                () -> Recorder.begin(world, file(), Recorder.LIMIT, more -> { })).getMessage();
            assertTrue(said, said.endsWith("is being written by another simulation: end its record, or choose "
                + "another name"));
            recorder.end();
            assertFalse("that it is written", RunRecord.open(file()).isBeingWritten());
        }
    }

    /** Follows a script's waits in lock-step, which may all fall into one moment. */
    @Test(timeout = 120_000)
    public void whileTimeStandsStillAllThatHappenedComesOnTheDisk() throws Exception {
        SimulationRunner runner = new SimulationRunner(world());
        Recorder recorder = Recorder.begin(runner.getSimulation(), file(), Recorder.LIMIT, said -> { });
        runner.setPaused(true);
        Thread thread = new Thread(runner, "simulation under test");
        thread.start();
        try {
            runner.setSpeed(Double.POSITIVE_INFINITY);
            runner.advance(30);
            while (stepsOnDisk() < 30) {
                Thread.yield();
            }
            assertEquals(30, stepsOnDisk());
        } finally {
            runner.stop();
            thread.join();
            recorder.end();
        }
    }

    @Test
    public void runAgainItGivesTheSameBytesOnEveryPort() throws Exception {
        try (Simulation world = world()) {
            assertEquals(390 / 60.0, recorded(world).getSeconds(), 1e-9);
        }
        Rerun.Result result = Rerun.of(RunRecord.open(file()), Project.read(project.folder()));
        assertTrue(result.toString(), result.same);
        assertEquals(390 / 60.0, result.seconds, 1e-9);
        assertEquals(3, result.ports.size());
        result.ports.forEach((port, text) ->
            assertTrue(port + ": " + text, text.matches("[1-9][0-9]{2,} bytes, the same")));
        assertEquals("all is where it was", 0, result.apart, 0);
        Rerun.Result moved = Rerun.of(RunRecord.open(file()), Project.read(project.folder()), world -> {
            if (world.getTime() == 0) {
                world.move("can", new Pose(1, 0.05, 1, 0, 0, 0, 1), new Pose(1, 0.05, 1, 0, 0, 0, 1));
            }
        });
        assertFalse(moved.toString(), moved.same);
        assertEquals(1, moved.apart, 0.01);
    }

    /** Runs as by the clock, where the simulation thread services devices whenever bytes arrive. */
    @Test
    public void bytesBetweenTwoStepsAreRepeatedThere() throws Exception {
        Random random = new Random(Fuzz.SEED);
        Arduino board = new Arduino("uno");
        board.setPorts("/dev/unoUart", "/dev/unoUser");
        try (Simulation world = world(board)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            byte[][] said = {FULL_MODE, AHEAD, SENSORS, STREAM, SCAN, DIGITAL_WRITE, READ_PIN};
            for (int i = 0; i < 3000; i++) {
                byte[] bytes = said[random.nextInt(said.length)];
                String object = bytes == SCAN ? "lidar" : bytes == DIGITAL_WRITE || bytes == READ_PIN ? "uno" : "drive";
                if (random.nextInt(3) == 0) {
                    line(world, object).write(bytes);
                }
                if (random.nextInt(40) == 0) {
                    line(world, "drive").setHostBaud(random.nextBoolean() ? 57600 : 19200);
                    world.power("lidar", random.nextInt(4) > 0);
                }
                if (random.nextInt(4) == 0) {
                    world.answer();
                } else if (random.nextInt(4) > 0) {
                    world.serviceDevices(1 + random.nextInt(255));
                } else {
                    world.step();
                }
            }
            recorder.end();
        }
        Rerun.Result result = Rerun.of(RunRecord.open(file()), Project.read(project.folder()));
        assertTrue(result.toString(), result.same);
        for (String port : new String[] {"drive at /dev/user", "uno at /dev/unoUser"}) {
            assertTrue(result.toString(), result.ports.get(port).matches("[1-9][0-9]{2,} bytes, the same"));
        }
    }

    @Test
    public void differencesOfARerunAreReported() throws Exception {
        try (Simulation world = world()) {
            recorded(world);
        }
        byte[] bytes = Files.readAllBytes(file());
        int at = new String(bytes, StandardCharsets.ISO_8859_1).indexOf(new String(AHEAD, StandardCharsets.ISO_8859_1));
        bytes[at + 2] = 100;
        Files.write(file(), bytes);
        Rerun.Result result = Rerun.of(RunRecord.open(file()), Project.read(project.folder()));
        assertFalse(result.same);
        assertTrue(result.toString(), result.ports.get("drive at /dev/user").endsWith("different"));
        new Box("new", 1, 1, 1).move(5, 5, 5);
        String said = assertThrows(IOException.class,
            () -> Rerun.of(RunRecord.open(file()), Project.read(project.folder()))).getMessage();
        assertTrue(said, said.contains("is of another project than"));
    }

    /** Otherwise Ctrl+C in a Python 3 program would wait for the end of the table. */
    @Test
    public void anInterruptEndsTheWritingOfATable() throws Exception {
        try (Simulation world = world()) {
            recorded(world);
        }
        RunRecord record = RunRecord.open(file());
        Series series = Series.of(record, new ArrayList<>(Series.names(record.getHeader())), 100);
        Thread.currentThread().interrupt();
        try {
            assertThrows(CancellationException.class, series::csv);
        } finally {
            assertTrue(Thread.interrupted());
        }
    }

    @Test
    public void aRecordFromTheMiddleIsNotRunAgain() throws Exception {
        try (Simulation world = world()) {
            run(world, 5);
            recorded(world);
        }
        String said = assertThrows(IOException.class,
            () -> Rerun.of(RunRecord.open(file()), Project.read(project.folder()))).getMessage();
        assertTrue(said, said.contains("begins at step 5 of its run and can't be run again: begin the record "
            + "before the start"));
    }

    @Test
    public void valuesOverTime() throws Exception {
        double[] last = new double[3];
        try (Simulation world = world()) {
            recorded(world);
            last[0] = world.getPose("rover").x;
            last[1] = world.read("compass").numbers()[0];
        }
        Series series = Series.of(RunRecord.open(file()),
            List.of("rover.x", "compass", "accel.x", "can.y", "drive at /dev/user sent", "rover speed wanted"), 10000);
        assertEquals(196, series.times.length);
        assertEquals(390 / 60.0, series.times[195], 1e-9);
        assertEquals(last[0], series.values[0][195], 1e-12);
        assertEquals(last[1], series.values[1][195], 1e-12);
        assertEquals(0.05, series.values[3][195], 0.01);
        assertTrue(series.values[4][195] > 100);
        assertEquals(0.05, series.values[5][195], 1e-12);
        assertTrue(Series.names(RunRecord.open(file()).getHeader()).containsAll(series.names));
        assertEquals("time (s),rover.x", series.csv().split("\n")[0].substring(0, 16));
        assertEquals(197, series.csv().split("\n").length);
        Series few = Series.of(RunRecord.open(file()), List.of("rover.x"), 50);
        assertTrue("" + few.times.length, few.times.length >= 25 && few.times.length <= 50);
        String said = assertThrows(IllegalArgumentException.class,
            () -> Series.of(RunRecord.open(file()), List.of("rover.q"), 50)).getMessage();
        assertTrue(said, said.contains("no value is called \"rover.q\", legal: rover.x, "));
    }

    /** A sensor may share its name with a value of its robot: the record has both. */
    @Test
    public void valuesOfOneNameAreNumbered() throws Exception {
        try (Simulation world = world(new Compass("rover.x"))) {
            recorded(world);
            Series series = Series.of(RunRecord.open(file()), List.of("rover.x", "rover.x 2"), 10000);
            assertEquals(world.getPose("rover").x, series.values[0][195], 1e-12);
            assertEquals(world.read("rover.x").numbers()[0], series.values[1][195], 1e-12);
        }
    }

    @Test
    public void framesForPanelsAreFew() throws Exception {
        try (Simulation world = world()) {
            recorded(world);
        }
        Frames frames = Frames.of(RunRecord.open(file()), 50);
        assertTrue("" + frames.times.size(), frames.times.size() >= 25 && frames.times.size() <= 50);
        assertEquals(7, frames.robots.get(0).get(0).length);
        assertTrue(frames.whole);
        Series series = Series.of(RunRecord.open(file()), List.of("ping", "compass", "rover.speed"), 50);
        RecordHeader header = RunRecord.open(file()).getHeader();
        int ping = header.sizes.subList(0, header.sensors.indexOf("ping")).stream().mapToInt(Integer::intValue).sum();
        int compass = header.sizes.subList(0, header.sensors.indexOf("compass")).stream()
            .mapToInt(Integer::intValue).sum();
        for (int i = 0; i < series.times.length; i++) {
            assertEquals(series.times[i], frames.times.get(i), 1e-9);
            assertEquals(series.values[0][i], frames.readings.get(i)[ping], 0);
            assertEquals(series.values[1][i], frames.readings.get(i)[compass], 0);
            assertEquals(series.values[2][i], frames.speeds.get(i).get(0)[0], 0);
        }
    }

    @Test
    public void lightsAndBumpersAreInTheFrames() throws Exception {
        new Floor("floor", 20, 20);
        SEARrobot robot = Robots.create("rover");
        robot.addComponent(new Led("red"));
        robot.addComponent(new Led("blue"));
        robot.addComponent(new Bumper("touch"));
        robot.addComponent(new ColorSensor("color"));
        try (Simulation world = Simulation.of(Project.read(project.folder()), 7)) {
            world.getLight("red").setBrightness(1);
            world.step();
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            run(world, 10);
            world.getLight("blue").setBrightness(0.5);
            run(world, 10);
            recorder.end();
        }
        Frames frames = Frames.of(RunRecord.open(file()), 50);
        assertEquals(2, frames.lights.size());
        assertArrayEquals(new int[] {0, 1}, frames.lights.get(1));
        assertArrayEquals(new double[] {1, 0}, frames.brightness.get(0), 0);
        assertArrayEquals(new double[] {1, 0}, frames.brightness.get(5), 0);
        assertArrayEquals(new double[] {1, 0.5}, frames.brightness.get(6), 0);
        Series series = Series.of(RunRecord.open(file()), List.of("touch", "color.z"), 50);
        assertEquals("nothing presses it", 0, series.values[0][3], 0);
        assertTrue("the floor's blue: " + series.values[1][3], series.values[1][3] >= 0 && series.values[1][3] <= 255);
    }

    @Test
    public void aRecordEndsAtItsLimit() throws Exception {
        List<String> said = new ArrayList<>();
        try (Simulation world = world()) {
            Recorder recorder = Recorder.begin(world, file(), 20000, said::add);
            run(world, 600);
            recorder.end();
            assertEquals(said.toString(), 1, said.size());
            assertTrue(said.get(0), said.get(0).endsWith("it reached its maximum size, 20000 bytes"));
        }
        assertTrue(Files.size(file()) < 22000);
        assertTrue(RunRecord.open(file()).read(new RunRecord.Visitor() { }));
        assertTrue(Rerun.of(RunRecord.open(file()), Project.read(project.folder())).same);
    }

    @Test
    public void onlyRecordsAreReplaced() throws Exception {
        Files.writeString(file(), "my diary");
        try (Simulation world = world()) {
            String said = assertThrows(IOException.class, () -> Recorder.begin(world, file(), 1000, text -> { }))
                .getMessage();
            assertTrue(said, said.contains("exists and is no record of a run; choose another name"));
        }
        assertEquals("my diary", Files.readString(file()));
        String said = assertThrows(IOException.class, () -> RunRecord.open(file())).getMessage();
        assertTrue(said, said.contains("it does not begin with \"SEARLOG1\""));
    }

    @Test
    public void cutOffFilesAreReadUpToThere() throws Exception {
        try (Simulation world = world()) {
            recorded(world);
        }
        byte[] whole = Files.readAllBytes(file());
        Random random = new Random(3);
        for (int i = 0; i < 60; i++) {
            Files.write(file(), Arrays.copyOf(whole, i < 2 ? 8 + i : random.nextInt(whole.length)));
            try {
                int[] steps = {0};
                boolean complete = RunRecord.open(file()).read(new RunRecord.Visitor() {
                    @Override
                    public void step() {
                        steps[0]++;
                    }
                });
                assertFalse(complete);
                assertTrue(steps[0] <= 390);
            } catch (RecordException e) {
                assertTrue(e.getMessage(), e.getMessage()
                    .matches("(?s).*(it ends in the middle of its header|does not begin with).*"));
            }
        }
    }

    @Test
    public void lyingFilesAreRefusedOrRead() throws Exception {
        try (Simulation world = world()) {
            recorded(world);
        }
        byte[] whole = Files.readAllBytes(file());
        Random random = new Random(5);
        for (int i = 0; i < 200; i++) {
            byte[] broken = whole.clone();
            for (int k = 0; k < 1 + i % 5; k++) {
                broken[random.nextInt(i % 2 == 0 ? 300 : broken.length)] = (byte) random.nextInt(256);
            }
            Files.write(file(), broken);
            try {
                RunRecord record = RunRecord.open(file());
                record.read(new RunRecord.Visitor() { });
                Frames.of(record, 100);
            } catch (RecordException e) {
                assertTrue(e.getMessage(), e.getMessage().contains("can't be read as a record: ") && e.getMessage()
                    .length() < 2000);
            }
        }
    }

    @Test
    public void aReadingWithTooManyNumbersIsRejectedWithTheLimit() {
        String said = assertThrows(IllegalArgumentException.class, () -> Recorder.names("eye", () -> new double[200]))
            .getMessage();
        assertTrue(said, said.contains("sensor eye has 200 numbers and 200 names, legal: as many names as "
            + "numbers, at most 127"));
    }
}
