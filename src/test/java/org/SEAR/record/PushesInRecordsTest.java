// SPDX-License-Identifier: Apache-2.0
package org.SEAR.record;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.orders.BodyOrder;
import org.SEAR.simulator.orders.BodyOrder.Kind;
import org.SEAR.simulator.orders.DragSpring;
import org.junit.Rule;
import org.junit.Test;

/** Pushes and velocities are in records and have the same effect on a rerun. */
public class PushesInRecordsTest {
    private static final double FORCE = 123.5;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path file() {
        return project.getRoot().toPath().resolve("run.searlog");
    }

    /** Records a car whose bytes contain its position, and a box thrown at it. */
    private void record() throws Exception {
        new Floor("floor", 40, 40);
        new Box("box", 0.2, 0.2, 0.2, 5, 0, 0.1, 4);
        SEARrobot car = Robots.car("car");
        GPS gps = new GPS("gps", 33.6, 182.5, -80.8);
        gps.setPorts("/dev/gpsUart", "/dev/gpsUser");
        car.addComponent(gps);
        try (Simulation world = Simulation.of(Project.read(project.folder()), 7)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            run(world, 30);
            world.order(new BodyOrder(Kind.VELOCITY, "box", 0, 1, -6, 0));
            world.order(new BodyOrder(Kind.SPIN, "box", 0, 90, 0, 0));
            run(world, 60);
            world.order(new BodyOrder(Kind.PUSH, "car", FORCE, 0, 80, 0.5));
            assertThrows(IllegalArgumentException.class,
                () -> world.order(new BodyOrder(Kind.PUSH, "floor", 1, 0, 0, 1)));
            run(world, 210);
            recorder.end();
        }
    }

    private static void run(Simulation world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private Rerun.Result again() throws Exception {
        return Rerun.of(RunRecord.open(file()), Project.read(project.folder()));
    }

    /** Changes the force of the push in the file. */
    private void change(double force) throws IOException {
        byte[] bytes = Files.readAllBytes(file());
        byte[] wanted = ByteBuffer.allocate(8).putDouble(FORCE).array();
        for (int at = 0; at + 8 <= bytes.length; at++) {
            if (ByteBuffer.wrap(bytes, at, 8).equals(ByteBuffer.wrap(wanted))
                && bytes[at - 2] == org.SEAR.record.EventKind.BODY_ORDER) {
                ByteBuffer.wrap(bytes).putDouble(at, force);
                Files.write(file(), bytes);
                return;
            }
        }
        throw new AssertionError("no push");
    }

    @Test
    public void runAgainTheyGiveTheSameBytesAndAnotherPushGivesOthers() throws Exception {
        record();
        Rerun.Result result = again();
        assertTrue(result.toString(), result.same && result.whole);
        change(-3000);
        assertFalse("another push, the same bytes", again().same);
    }

    @Test
    public void aChangeOfGravityIsRepeatedOnARerun() throws Exception {
        new Floor("floor", 40, 40);
        new Box("box", 0.2, 0.2, 0.2, 5, 0, 3, 0);
        try (Simulation world = Simulation.of(Project.read(project.folder()), 7)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            run(world, 10);
            world.order(BodyOrder.gravity(1.62));
            run(world, 10);
            world.order(BodyOrder.gravity(0));
            run(world, 60);
            recorder.end();
            assertEquals(0, world.getGravity(), 0);
        }
        Rerun.Result result = again();
        assertTrue(result.toString(), result.same && result.whole);
        List<String> orders = new ArrayList<>();
        RunRecord.open(file()).read(new RunRecord.Visitor() {
            @Override
            public void order(BodyOrder order) {
                orders.add(order.kind + " " + order.name + " " + order.y);
            }
        });
        assertEquals(List.of("GRAVITY world -1.62", "GRAVITY world 0.0"), orders);
    }

    @Test
    public void aDragIsRepeatedOnARerun() throws Exception {
        new Floor("floor", 40, 40);
        SEARrobot car = Robots.car("car");
        GPS gps = new GPS("gps", 33.6, 182.5, -80.8);
        gps.setPorts("/dev/gpsUart", "/dev/gpsUser");
        car.addComponent(gps);
        try (Simulation world = Simulation.of(Project.read(project.folder()), 7)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            DragSpring hand = new DragSpring("car", () -> false, () -> 0);
            hand.moveTo(FORCE, 2, 5);
            world.hold(hand, "car");
            run(world, 100);
            hand.letGo();
            run(world, 100);
            recorder.end();
        }
        Rerun.Result result = again();
        assertTrue(result.toString(), result.same && result.whole);
    }

    @Test
    public void theyAreReadWithTheirValuesAndWrongOnesAreRefused() throws Exception {
        record();
        List<String> orders = new ArrayList<>();
        RunRecord.Visitor visitor = new RunRecord.Visitor() {
            @Override
            public void order(BodyOrder order) {
                orders.add(String.format(Locale.ROOT, "%s %s %s %s %s %s", order.kind, order.name, order.x, order.y,
                    order.z, order.seconds));
            }
        };
        RunRecord.open(file()).read(visitor);
        assertEquals(List.of("VELOCITY box 0.0 1.0 -6.0 0.0", "SPIN box 0.0 90.0 0.0 0.0",
            "PUSH car 123.5 0.0 80.0 0.5"), orders);
        change(Double.NaN);
        IOException e = assertThrows(IOException.class, () -> RunRecord.open(file()).read(visitor));
        assertTrue(e.getMessage(), e.getMessage().contains("push is NaN along an axis"));
    }
}
