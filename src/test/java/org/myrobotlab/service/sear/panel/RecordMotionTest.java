// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertNotEquals;
import static org.junit.Assert.assertNull;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Base64;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Robots;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.POJOs.Servo;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.record.Recorder;
import org.SEAR.record.RunRecord;
import org.SEAR.sensors.LidarScan;
import org.SEAR.simulator.ActuatorOrder;
import org.SEAR.simulator.ActuatorOrder.Kind;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;

/** The rerun of a record has the original wheels, servos and beams, and fits into a message. */
public class RecordMotionTest {
    private static final int TURNED = 40;
    private static final int SECOND = 60;
    /** Limit of a message to a page, characters. */
    private static final int LONGEST = 1 << 20;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path file() {
        return project.getRoot().toPath().resolve("run.searlog");
    }

    /** Makes a car with a LIDAR on a servo and a distance sensor that looks ahead. */
    private Simulation world(double resolution) throws Exception {
        new Floor("floor", 40, 40);
        new Box("wall", 10, 0.2, 1).move(0, 0.5, 3);
        new Box("side", 0.2, 10, 1).move(4, 0.5, 0);
        SEARrobot car = Robots.car("car");
        Servo neck = new Servo("neck", 0, 0.2, 0);
        LIDAR lidar = new LIDAR("lidar", 8, 180, resolution, 0, 0.3, 0);
        neck.mount(lidar);
        car.addComponent(neck);
        car.addComponent(lidar);
        car.addComponent(new Distance("ping", "laser", 0, 0.1, 0.3, 0, 0, 0));
        return Simulation.of(Project.read(project.folder()), 7);
    }

    private static void run(Simulation world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private JsonNode motion() throws IOException {
        return new ObjectMapper().valueToTree(RecordMotion.of("run.searlog", RunRecord.open(file()), project.folder()));
    }

    private static double[] ranges(JsonNode packed) {
        ByteBuffer bytes = ByteBuffer.wrap(Base64.getDecoder().decode(packed.asText())).order(ByteOrder.LITTLE_ENDIAN);
        double[] ranges = new double[bytes.remaining() / 2];
        for (int i = 0; i < ranges.length; i++) {
            int centimetres = bytes.getShort() & 0xffff;
            ranges[i] = centimetres == 0xffff ? Double.POSITIVE_INFINITY : centimetres / 100.0;
        }
        return ranges;
    }

    @Test
    public void wheelsServosAndBeamsAreReproduced() throws Exception {
        double[] seen;
        double hit;
        try (Simulation world = world(1)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            world.order(new ActuatorOrder(Kind.ANGLE, "neck", TURNED));
            world.order(new ActuatorOrder(Kind.STEERING, "car", 20));
            run(world, SECOND);
            world.order(new ActuatorOrder(Kind.SPEED, "engine", 5));
            run(world, SECOND);
            LidarScan scan = world.read("lidar").scan();
            seen = scan.ranges();
            hit = world.read("ping").hits().get(0)[2];
            recorder.end();
        }
        JsonNode motion = motion();
        assertEquals("lidar, ping", motion.at("/sensors/0/name").asText().replaceAll(".*/", "") + ", "
            + motion.at("/sensors/1/name").asText().replaceAll(".*/", ""));
        assertEquals(181, motion.at("/sensors/0/fan").size());
        assertEquals("ten a second", 21, motion.get("frames").size());
        JsonNode first = motion.get("frames").get(0);
        JsonNode last = motion.get("frames").get(20);
        assertEquals(2, last.get("time").asDouble(), 1e-9);
        assertArrayEquals("every beam, to a centimetre", seen, ranges(last.at("/ranges/0")), 0.0051);
        assertTrue("one without beams has none", last.at("/ranges/1").isNull());
        assertEquals(hit, last.at("/hits/1/2").asDouble(), 0.001);
        assertEquals("where the neck turned it", TURNED, last.at("/poses/0/4").asDouble() - last.at("/poses/1/4")
            .asDouble(), 0.01);
        assertNotEquals("a wheel rolls", first.at("/wheels/0/0/3").asDouble(), last.at("/wheels/0/0/3").asDouble(), 1);
        assertNotEquals("and one is steered", first.at("/wheels/0/2").toString(), last.at("/wheels/0/2").toString());
        assertEquals("the parts of a robot with servos", 1, last.get("turned").size());
        assertTrue(last.get("turned").get(0).size() > 0);
    }

    @Test
    public void manyBeamsAndALongRunFitIntoAMessage() throws Exception {
        try (Simulation world = world(0.25)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            world.order(new ActuatorOrder(Kind.SPEED, "engine", 1));
            run(world, 120 * SECOND);
            recorder.end();
        }
        JsonNode motion = motion();
        assertEquals("every fourth of 721", 181, motion.at("/sensors/0/fan").size());
        assertTrue("evenly", motion.get("frames").size() > 300);
        assertEquals(2 * (120.0 / (motion.get("frames").size() - 1)), motion.at("/frames/2/time").asDouble(), 0.05);
        assertTrue(String.valueOf(motion.toString().length()), motion.toString().length() < LONGEST);
    }

    @Test
    public void aFailedRerunReportsItsCause() throws Exception {
        try (Simulation world = world(1)) {
            Recorder recorder = Recorder.begin(world, file(), Recorder.LIMIT, said -> { });
            run(world, SECOND);
            recorder.end();
        }
        new Box("another", 1, 1, 1).move(-5, 0.5, -5);
        JsonNode motion = motion();
        assertNull(motion.get("frames"));
        assertTrue(motion.toString(), motion.get("why").asText().contains("of another project"));
    }
}
