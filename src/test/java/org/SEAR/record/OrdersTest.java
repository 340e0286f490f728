// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Led;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.devices.SerialLine;
import org.SEAR.geometry.Pose;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.ActuatorOrder.Kind;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** Commands to motors, servos, lights and the steering are in records and have the same effect on a rerun. */
public class OrdersTest {
    private static final byte[] SCAN = {2, 0, 2, 0, 0x30, 1, 0x31, 0x18};
    private static final int TURNED = 60;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path file() {
        return project.getRoot().toPath().resolve("run.searlog");
    }

    /** Makes a car whose bytes contain its position and the direction of its LIDAR. */
    private Simulation world() throws Exception {
        new Floor("floor", 40, 40);
        new Box("wall", 0.1, 6, 0.5).move(3, 0.25, 0);
        SEARrobot car = Robots.car("car");
        GPS gps = new GPS("gps", 33.6, 182.5, -80.8);
        gps.setPorts("/dev/gpsUart", "/dev/gpsUser");
        car.addComponent(gps);
        Servo neck = new Servo("neck", 0, 0.1, 0.2);
        LIDAR lidar = new LIDAR("lidar", 8, 180, 1, 0, 0.2, 0.2);
        lidar.setPorts("/dev/lidarUart", "/dev/lidarUser");
        Led lamp = new Led("lamp", 0, 0.3, 0.2);
        neck.mount(lidar);
        neck.mount(lamp);
        car.addComponent(neck);
        car.addComponent(lidar);
        car.addComponent(lamp);
        return Simulation.of(Project.read(project.folder()), 7);
    }

    private static void run(Simulation world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private static SerialLine lidar(Simulation world) {
        return world.getLines().stream().filter(line -> line.getObjectName().equals("lidar")).findFirst()
            .orElseThrow(AssertionError::new);
    }

    private void record(Simulation world) throws Exception {
        Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
        run(world, 30);
        world.order(new ActuatorOrder(Kind.SPEED, "engine", 10));
        world.order(new ActuatorOrder(Kind.STEERING, "car", 20));
        world.order(new ActuatorOrder(Kind.BRIGHTNESS, "car/lamp", 0.25));
        run(world, 60);
        world.order(new ActuatorOrder(Kind.ANGLE, "neck", TURNED));
        assertThrows(IllegalArgumentException.class, () -> world.order(new ActuatorOrder(Kind.ANGLE, "neck", 91)));
        run(world, 60);
        lidar(world).write(SCAN);
        world.order(new ActuatorOrder(Kind.POWER, "engine", -0.5));
        run(world, 150);
        recorder.end();
    }

    private Rerun.Result again() throws Exception {
        return Rerun.of(RunRecord.open(file()), Project.read(project.folder()));
    }

    @Test
    public void runAgainTheyGiveTheSameBytes() throws Exception {
        try (Simulation world = world()) {
            record(world);
        }
        Rerun.Result result = again();
        assertTrue(result.toString(), result.same);
        result.ports.forEach((port, text) ->
            assertTrue(port + ": " + text, text.matches("[1-9][0-9]{2,} bytes, the same")));
    }

    @Test
    public void theyAreReadInTheirOrderWithTheirValues() throws Exception {
        try (Simulation world = world()) {
            record(world);
        }
        List<String> orders = new ArrayList<>();
        RunRecord.open(file()).read(new RunRecord.Visitor() {
            private int steps;

            @Override
            public void step() {
                steps++;
            }

            @Override
            public void order(ActuatorOrder order) {
                orders.add(String.format(Locale.ROOT, "%d %s %s %s", steps, order.kind, order.name, order.value));
            }
        });
        assertEquals(List.of("30 SPEED engine 10.0", "30 STEERING car 20.0", "30 BRIGHTNESS car/lamp 0.25",
            "90 ANGLE neck 60.0", "150 POWER engine -0.5"), orders);
    }

    /** Returns the offset of the servo's command in the file. */
    private static int place(byte[] bytes) {
        byte[] order = ByteBuffer.allocate(10).put((byte) Kind.ANGLE.ordinal()).putDouble(TURNED).put((byte) 0).array();
        for (int at = 0; at < bytes.length; at++) {
            if (bytes[at] == org.SEAR.record.EventKind.ORDER
                && Arrays.equals(order, Arrays.copyOfRange(bytes, at + 1, at + 1 + order.length))) {
                return at;
            }
        }
        throw new AssertionError("no order");
    }

    @Test
    public void anotherOrderGivesOtherBytesAndAWrongOneIsRefused() throws Exception {
        try (Simulation world = world()) {
            record(world);
        }
        byte[] bytes = Files.readAllBytes(file());
        int at = place(bytes);
        ByteBuffer.wrap(bytes).putDouble(at + 2, 20);
        Files.write(file(), bytes);
        assertFalse("the LIDAR looks elsewhere", again().same);
        bytes[at + 1] = 8;
        Files.write(file(), bytes);
        String said = assertThrows(IOException.class, this::again).getMessage();
        assertTrue(said, said.endsWith("can't be read as a record: after 90 steps it names order 8, legal: below 8"));
    }

    /** Commands of a callback during the delivery of a step's outputs come after that step. */
    private void comesAfterItsStep(Consumer<Simulation> callback) throws Exception {
        try (Simulation world = world()) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            world.getLines().stream().filter(line -> line.getObjectName().equals("gps")).findFirst()
                .orElseThrow(AssertionError::new).setSink((bytes, starts) -> callback.accept(world));
            for (int i = 0; i < 60; i++) {
                run(world, 10);
                lidar(world).write(SCAN);
            }
            recorder.end();
        }
        assertTrue(again().same);
    }

    @Test
    public void aCommandDuringDeliveryBelongsToTheNextStep() throws Exception {
        comesAfterItsStep(world -> world.order(new ActuatorOrder(Kind.ANGLE, "neck", world.getStep() % 90)));
    }

    @Test
    public void aResetDuringDeliveryFollowsItsStep() throws Exception {
        comesAfterItsStep(world -> {
            if (world.getStep() > 200) {
                world.reset();
                assertTrue("not in the middle of a step", world.getStep() > 200);
            }
        });
        List<String> events = new ArrayList<>();
        RunRecord.open(file()).read(new RunRecord.Visitor() {
            @Override
            public void step() {
                events.add("step");
            }

            @Override
            public void reset() {
                events.add("reset");
            }

            @Override
            public void said(int line, byte[] bytes) {
                events.add("said");
            }
        });
        int reset = events.indexOf("reset");
        assertTrue(String.valueOf(reset), reset > 200);
        assertEquals("what the step said, the step, the reset", List.of("said", "step", "reset"),
            events.subList(reset - 2, reset + 1));
    }

    @Test
    public void aMoveDuringDeliveryBelongsToTheNextStep() throws Exception {
        comesAfterItsStep(world -> {
            Pose to = Pose.ofDegrees(world.getStep() * 1e-3, 0.1, 0, 0, 0, 0);
            world.move("car", to, to);
        });
    }

    /** Returns the error for a recorded move with an invalid first letter or an invalid coordinate. */
    private String saidOfMove(int letter, int number, double value) throws Exception {
        byte[] bytes = Files.readAllBytes(file());
        byte[] event = ByteBuffer.allocate(6).put((byte) org.SEAR.record.EventKind.MOVED).putShort((short) 3)
            .put("car".getBytes()).array();
        int at = new String(bytes, StandardCharsets.ISO_8859_1).indexOf(new String(event, StandardCharsets.ISO_8859_1));
        assertTrue("the move", at > 0);
        bytes[at + 3] = (byte) letter;
        ByteBuffer.wrap(bytes).putDouble(at + event.length + (7 + number) * Double.BYTES, value);
        Path copy = file().resolveSibling("changed.record");
        Files.write(copy, bytes);
        String said = assertThrows(IOException.class,
            () -> Rerun.of(RunRecord.open(copy), Project.read(project.folder()))).getMessage();
        return said.substring(said.indexOf("after"));
    }

    @Test
    public void aMoveThatCantBeIsRefused() throws Exception {
        try (Simulation world = world()) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            run(world, 3);
            Pose to = Pose.ofDegrees(1, 0.1, 0, 0, 0, 0);
            world.move("car", to, to);
            run(world, 3);
            recorder.end();
        }
        assertEquals("after 3 steps \"bar\" is moved, legal: a robot or object in its header", saidOfMove('b', 0, 1));
        assertEquals("after 3 steps an object is moved to NaN, legal: a finite number", saidOfMove('c', 0, Double.NaN));
        assertEquals("after 3 steps an object is rotated by a quaternion of length 0.0, legal: 1",
            saidOfMove('c', 6, 0));
    }
}
