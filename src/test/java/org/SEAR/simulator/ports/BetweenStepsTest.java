// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ports;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import org.SEAR.Bytes;
import org.SEAR.POJOs.Arduino;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.devices.SerialLine;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;

/** Lines and devices between two steps, by the clock and while time stands still. */
public class BetweenStepsTest {
    /** Start, then a query of the mode. */
    private static final String QUERY = "80 8E 23";
    /** Time of three bytes to the device at 115200 baud, and with one byte back, in 1/256 of a step. */
    private static final int PARTS_TO_DEVICE = 4;
    private static final int PARTS_TO_AND_FRO = 6;
    private static final String DIGITAL_WRITE = "AA 03 1B 0D 01";
    /** Length of the board's first line of text, characters. */
    private static final int HELLO = 63;
    /** Length of an LMS200's telegram with 181 values, bytes. */
    private static final int TELEGRAM = 372;
    private static final String ACK = "AA 02 09 1B";

    @Rule
    public final ProjectRule project = new ProjectRule();
    private final ByteArrayOutputStream heard = new ByteArrayOutputStream();
    private Simulation world;
    private SerialLine create;
    private SerialLine uno;

    @Before
    public void start() throws Exception {
        new Floor("floor", 10, 10);
        SEARrobot robot = Robots.create2("rover", "createUart", "createUser");
        Arduino board = new Arduino("uno");
        board.setPorts("unoUart", "unoUser");
        board.setFirmware("MrlComm");
        robot.addComponent(board);
        world = Worlds.start(project);
        uno = line("Arduino");
        create = line("Dynamics");
        world.getLines().forEach(each -> each.setSink((bytes, starts) -> heard.write(bytes, 0, bytes.length)));
        Worlds.run(world, 0.5);
    }

    private SerialLine line(String type) {
        return world.getLines().stream().filter(each -> each.getObjectType().equals(type)).findFirst()
            .orElseThrow(AssertionError::new);
    }

    private String heard() {
        String hex = Bytes.hex(heard.toByteArray());
        heard.reset();
        return hex;
    }

    private String heardIn(double seconds) {
        Worlds.run(world, seconds);
        return heard();
    }

    @Test
    public void byTheClockAnAnswerComesBeforeTheNextStepAndTakesTheTimeOfItsBytes() {
        long step = world.getStep();
        create.write(Bytes.bytes(QUERY));
        int next = world.serviceDevices(100);
        assertEquals("the question is on the line", 100 + PARTS_TO_DEVICE + 1, next, 1);
        assertEquals("", heard());
        world.serviceDevices(100 + PARTS_TO_DEVICE - 1);
        assertEquals("", heard());
        next = world.serviceDevices(next);
        assertEquals("the answer is on the line", 100 + PARTS_TO_AND_FRO, next, 1);
        assertEquals("", heard());
        world.serviceDevices(next);
        assertEquals("01", heard());
        assertEquals(step, world.getStep());
        world.step();
        assertEquals("", heard());
    }

    /** A program that gets part of an answer, and the rest after a delay of a busy machine, loses synchronisation. */
    @Test
    public void byTheClockAnAnswerComesInOnePiece() {
        List<Integer> pieces = new ArrayList<>();
        create.setSink((bytes, starts) -> pieces.add(bytes.length));
        create.write(Bytes.bytes("80 8E 00"));
        int looks = 0;
        for (int next = world.serviceDevices(100); pieces.isEmpty() && next < Simulation.PARTS; looks++) {
            next = world.serviceDevices(next);
        }
        assertEquals(List.of(26), pieces);
        assertEquals("when the question has arrived, and when the answer has left", 2, looks);
    }

    @Test
    public void longAfterTheLastByteNothingIsToBeDone() {
        assertEquals(Simulation.PARTS, world.serviceDevices(10));
        create.write(Bytes.bytes(QUERY));
        assertTrue(world.serviceDevices(20) < Simulation.PARTS);
        Worlds.run(world, 0.2);
        assertEquals(Simulation.PARTS, world.serviceDevices(10));
    }

    /** A real LMS200's telegrams come within 1 ms of a constant interval; a step has 16.7 ms. */
    @Test
    public void byTheClockScansLeaveAtTheirTimesNotAtSteps() throws Exception {
        LIDAR lidar = new LIDAR("lidar");
        lidar.setBaud(500000);
        lidar.setPorts("lidarUart", "lidarUser");
        SEARrobot other = Robots.create2("other");
        other.placeAt(2, 0);
        other.addComponent(lidar);
        world = Worlds.start(project);
        SerialLine scanner = line("LIDAR");
        List<Double> arrivals = new ArrayList<>();
        int[] part = {0};
        int[] length = {0};
        scanner.setSink((bytes, starts) -> {
            List<Integer> begins = Arrays.stream(starts).boxed().collect(Collectors.toList());
            for (int i = 0; i < bytes.length; i++) {
                length[0] = begins.contains(i) ? 1 : length[0] + 1;
                if (length[0] == TELEGRAM) {
                    arrivals.add((world.getStep() + part[0] / (double) Simulation.PARTS) * Simulation.STEP);
                }
            }
        });
        scanner.write(Bytes.bytes("02 00 02 00 20 24 34 08"));
        Worlds.run(world, 0.5);
        arrivals.clear();
        for (int step = 0; step < 60; step++) {
            for (part[0] = world.serviceDevices(1); part[0] < Simulation.PARTS;) {
                part[0] = world.serviceDevices(part[0]);
            }
            part[0] = 0;
            world.step();
        }
        assertEquals("75 a second: " + arrivals, 75, arrivals.size(), 1);
        for (int i = 1; i < arrivals.size(); i++) {
            assertEquals("scan " + i, 0.01332, arrivals.get(i) - arrivals.get(i - 1), 0.0002);
        }
    }

    @Test
    public void timeOfDevicesNeverRunsBackwards() {
        create.write(Bytes.bytes(QUERY));
        world.serviceDevices(200);
        create.write(Bytes.bytes("8E 23"));
        int next = world.serviceDevices(50);
        assertTrue("from part 200 on: " + next, next > 200);
        world.step();
        assertEquals("01 01", heard());
        create.write(Bytes.bytes(QUERY));
        world.serviceDevices(200);
        world.reset();
        create.write(Bytes.bytes("80 8E 07"));
        world.step();
        assertEquals("00", heard());
    }

    @Test
    public void whileTimeStandsStillMrlCommAnswersAtOnceAndOthersWait() {
        long step = world.getStep();
        create.write(Bytes.bytes(QUERY));
        assertFalse(world.hasQueries());
        for (int i = 0; i < 2000; i++) {
            uno.write(Bytes.bytes(DIGITAL_WRITE));
            assertTrue(world.hasQueries());
            world.answer();
            assertFalse(world.hasQueries());
            assertEquals("command " + i, ACK, heard());
        }
        assertEquals(step, world.getStep());
        world.step();
        assertEquals("01", heard());
    }

    @Test(timeout = 60_000)
    public void whileTimeStandsStillTheBoardBootsImmediatelyForAWaitingProgram() throws Exception {
        uno.write(Bytes.bytes("AA 05 04 0E 01 00 00"));
        world.answer();
        heard();
        CountDownLatch goOn = new CountDownLatch(1);
        SynchronousQueue<String> answers = new SynchronousQueue<>();
        Thread user = new Thread(() -> {
            uno.open();
            try {
                goOn.await();
                answers.poll(1, TimeUnit.DAYS);
            } catch (InterruptedException e) {
                throw new IllegalStateException(e);
            }
        });
        user.start();
        while (user.getState() != Thread.State.WAITING) {
            Thread.onSpinWait();
        }
        assertFalse("it goes on and doesn't wait for the board yet", world.hasQueries());
        world.answer();
        assertEquals("", heard());
        goOn.countDown();
        while (!world.hasQueries()) {
            Thread.onSpinWait();
        }
        world.answer();
        String told = heard();
        assertEquals("AA 02 3A 44 AA 09 03 44 02 03 E8 04 00 00 00", told.substring(3 * HELLO));
        assertEquals("it has forgotten the pins", "", heardIn(0.9));
        answers.put("");
        user.join();
    }

    @Test
    public void inPiecesACommandHasTheSameAnswer() {
        uno.write(Bytes.bytes("AA 03"));
        world.answer();
        assertEquals("", heard());
        uno.write(Bytes.bytes("1B 0D 01 " + DIGITAL_WRITE));
        world.answer();
        assertEquals(ACK + " " + ACK, heard());
    }

    @Test
    public void earlierBytesOfTheBoardLeaveTheLineFirst() {
        uno.write(Bytes.bytes("AA 05 04 0E 01 00 00"));
        Worlds.run(world, 0.1);
        heard();
        uno.write(Bytes.bytes(DIGITAL_WRITE));
        world.answer();
        String told = heard();
        assertTrue(told, told.matches("(([0-9A-F]{2} )+)?" + ACK));
        Worlds.run(world, 0.1);
        assertTrue("whole messages", (told + " " + heard()).contains(ACK + " AA 05 20 03 0E"));
    }
}
