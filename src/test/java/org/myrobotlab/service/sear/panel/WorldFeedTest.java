// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.sear.panel;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.SEAR.POJOs.SearObject;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.Simulation;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Messages to panels about a running world: everything once, then changes. */
public class WorldFeedTest {
    private static final ObjectMapper JSON = new ObjectMapper();
    /** Limit of a message about a world at rest of any size, bytes. */
    private static final int SMALL = 300;
    private static final int MANY = 1500;
    /** Number of boxes that rest by friction; the others are fixed. */
    private static final int MOVABLE = 200;
    private static final int STEPS_BETWEEN = 6;
    private static final int ROBOTS = 10;
    /** 361 beams take 966 bytes, the robot and the reading in words some 200. */
    private static final int SCAN_BYTES = 1200;
    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();
    private final WorldFeed feed = new WorldFeed();

    /** Makes a floor with resting boxes and one box that falls from a height of one metre. */
    private Simulation world(int boxes) throws IOException, ProjectException {
        Path folder = temporary.newFolder().toPath();
        Path environment = Files.createDirectories(folder.resolve("environment"));
        Files.writeString(environment.resolve("floor.xml"),
            "<Floor><name>floor</name><length>200</length><width>200</width></Floor>");
        Files.writeString(environment.resolve("faller.xml"), box("faller", 0.2, -5, 1, -5, 1));
        for (int i = 0; i < boxes; i++) {
            Files.writeString(environment.resolve("box" + i + ".xml"),
                box("box" + i, 0.3, i % 40, 0.15, i / 40, i < MOVABLE ? 1 : 0));
        }
        return Simulation.load(folder, 1);
    }

    private static String box(String name, double edge, double x, double y, double z, double mass) {
        return "<Box><name>" + name + "</name><length>" + edge + "</length><width>" + edge + "</width><height>" + edge
            + "</height><mass>" + mass + "</mass><x>" + x + "</x><y>" + y + "</y><z>" + z + "</z></Box>";
    }

    private Map<String, Object> next(Simulation world) {
        return feed.next(world, new WorldFeed.Message());
    }

    private Map<String, Object> whole(Simulation world) {
        return feed.whole(world, new WorldFeed.Message());
    }

    /** Returns an object's entry in the whole message. */
    private static Map<?, ?> object(Map<String, Object> whole, int at) {
        return (Map<?, ?>) ((List<?>) whole.get("objects")).get(at);
    }

    private static int bytes(Map<String, Object> message) throws JsonProcessingException {
        return JSON.writeValueAsBytes(message).length;
    }

    private static void step(Simulation world, int steps) {
        for (int i = 0; i < steps; i++) {
            world.step();
        }
    }

    private Map<String, Object> resting(Simulation world) {
        step(world, 180);
        next(world);
        step(world, STEPS_BETWEEN);
        return next(world);
    }

    @Test
    public void restingObjectsAreSentOnce() throws Exception {
        try (Simulation few = world(1); Simulation many = world(MANY)) {
            assertEquals(MANY + 2, ((List<?>) next(many).get("objects")).size());
            Map<String, Object> large = resting(many);
            assertFalse(large.containsKey("objects"));
            assertTrue("bytes: " + bytes(large), bytes(large) < SMALL);
            feed.forget();
            next(few);
            assertEquals("it does not depend on the number of things", bytes(resting(few)), bytes(large), 10);
        }
    }

    @Test
    public void movingObjectsAreSentByIndex() throws Exception {
        try (Simulation world = world(3)) {
            Map<String, Object> whole = next(world);
            int faller = world.getProject().getEnvironment().stream().map(SearObject::getName)
                .collect(Collectors.toList()).indexOf("faller");
            assertEquals("faller", object(whole, faller).get("name"));
            step(world, STEPS_BETWEEN);
            Map<String, Object> message = next(world);
            Map<?, ?> objects = (Map<?, ?>) ((Map<?, ?>) message.get("changes")).get("objects");
            assertEquals(List.of(faller), List.copyOf(objects.keySet()));
            double[] pose = (double[]) ((Map<?, ?>) objects.get(faller)).get("pose");
            assertTrue("it falls: " + pose[1], pose[1] < 1);
            assertArrayEquals("a page that comes now gets it too", pose, (double[]) object(whole(world), faller)
                .get("pose"), 0);
        }
    }

    @Test
    public void messagesAreNumberedAndAResetSendsTheWholeWorld() throws Exception {
        try (Simulation world = world(1); Simulation other = world(2)) {
            assertEquals(1L, next(world).get("number"));
            step(world, STEPS_BETWEEN);
            assertEquals(2L, next(world).get("number"));
            assertEquals("a question for the whole counts nothing", 2L, whole(world).get("number"));
            assertTrue(next(world).containsKey("changes"));
            world.reset();
            Map<String, Object> again = next(world);
            assertEquals(4L, again.get("number"));
            assertEquals(3, ((List<?>) again.get("objects")).size());
            assertEquals("another world", 4, ((List<?>) next(other).get("objects")).size());
        }
    }

    /** Panels draw parts on a servo at their present pose and get messages only while it turns. */
    @Test
    public void partsOfAServoAreSentAsItTurns() throws Exception {
        Path folder = temporary.newFolder().toPath();
        Path robot = Files.createDirectories(folder.resolve("robot"));
        Files.writeString(robot.resolve("r.xml"),
            "<SEARrobot><name>r</name><component>d</component><component>s</component>"
            + "<component>head</component><component>lamp</component>"
            + "<wheel><name>w</name><radius>0.1</radius><width>0.1</width></wheel></SEARrobot>");
        Files.writeString(robot.resolve("d.xml"), "<Dynamics><name>d</name><mass>1</mass></Dynamics>");
        Files.writeString(robot.resolve("s.xml"), "<Servo><name>s</name><part>head</part><part>lamp</part></Servo>");
        Files.writeString(robot.resolve("lamp.xml"), "<Led><name>lamp</name><y>0.5</y><z>0.4</z></Led>");
        Files.writeString(robot.resolve("head.xml"), box("head", 0.1, 0, 0.2, 0.3, 0));
        try (Simulation world = Simulation.load(folder, 1)) {
            Map<?, ?> first = (Map<?, ?>) ((List<?>) next(world).get("robots")).get(0);
            assertArrayEquals(new double[] {0, 0.2, 0.3, 0, 0, 0}, ((double[][]) first.get("turned"))[0], 0);
            world.getServo("s").setAngle(90);
            step(world, 60);
            Map<?, ?> changed = (Map<?, ?>) ((Map<?, ?>) ((Map<?, ?>) next(world).get("changes")).get("robots")).get(0);
            assertArrayEquals(new double[] {0.3, 0.2, 0, 0, 90, 0}, ((double[][]) changed.get("turned"))[0], 1e-4);
            assertArrayEquals(new double[] {0.4, 0.5, 0, 0, 90, 0}, ((double[][]) changed.get("turnedLeds"))[0], 1e-4);
            step(world, STEPS_BETWEEN);
            Map<?, ?> still = (Map<?, ?>) ((Map<?, ?>) ((Map<?, ?>) next(world).get("changes")).get("robots")).get(0);
            assertFalse(still.containsKey("turned"));
            assertFalse(still.containsKey("turnedLeds"));
        }
    }

    /** Panels get the list of lights once, then each change of brightness. */
    @Test
    public void lightsAreSentOnChange() throws Exception {
        Path folder = temporary.newFolder().toPath();
        Path robot = Files.createDirectories(folder.resolve("robot"));
        Files.writeString(robot.resolve("r.xml"),
            "<SEARrobot><name>r</name><component>d</component><component>lamp</component></SEARrobot>");
        Files.writeString(robot.resolve("d.xml"), "<Dynamics><name>d</name><mass>1</mass></Dynamics>");
        Files.writeString(robot.resolve("lamp.xml"), "<Led><name>lamp</name><x>0.1</x><color>lime</color></Led>");
        try (Simulation world = Simulation.load(folder, 1)) {
            Map<?, ?> first = (Map<?, ?>) ((List<?>) next(world).get("robots")).get(0);
            Map<?, ?> lamp = (Map<?, ?>) ((List<?>) first.get("leds")).get(0);
            assertEquals("lamp", lamp.get("name"));
            assertEquals("#00ff00", lamp.get("color"));
            assertEquals("#003300", lamp.get("dark"));
            assertEquals(0.01, lamp.get("size"));
            assertArrayEquals(new double[] {0.1, 0, 0, 0, 0, 0}, (double[]) lamp.get("pose"), 0);
            assertEquals(List.of(0.0), first.get("lights"));
            world.getLight("lamp").setBrightness(0.5);
            step(world, STEPS_BETWEEN);
            Map<?, ?> changed = (Map<?, ?>) ((Map<?, ?>) ((Map<?, ?>) next(world).get("changes")).get("robots")).get(0);
            assertEquals(List.of(0.5), changed.get("lights"));
            assertFalse(changed.containsKey("leds"));
            step(world, STEPS_BETWEEN);
            Map<?, ?> still = (Map<?, ?>) ((Map<?, ?>) ((Map<?, ?>) next(world).get("changes")).get("robots")).get(0);
            assertFalse(still.containsKey("lights"));
        }
    }

    /** Panels request its pictures one by one, so a camera without viewers costs next to nothing. */
    @Test
    public void aCameraIsListedWithoutTakingAPicture() throws Exception {
        Path folder = temporary.newFolder().toPath();
        Path robot = Files.createDirectories(folder.resolve("robot"));
        Files.writeString(robot.resolve("r.xml"),
            "<SEARrobot><name>r</name><component>d</component><component>eye</component></SEARrobot>");
        Files.writeString(robot.resolve("d.xml"), "<Dynamics><name>d</name><mass>1</mass></Dynamics>");
        Files.writeString(robot.resolve("eye.xml"),
            "<Camera><name>eye</name><width>1920</width><height>1080</height></Camera>");
        try (Simulation world = Simulation.load(folder, 1)) {
            Map<?, ?> eye = (Map<?, ?>) ((List<?>) next(world).get("sensors")).get(0);
            assertEquals("1920 x 1080", eye.get("words"));
            assertEquals("[.brightness]", eye.get("names").toString());
            assertEquals("[null]", eye.get("numbers").toString());
            assertFalse(eye.containsKey("value") || eye.containsKey("picture"));
            Map<?, ?> form = (Map<?, ?>) eye.get("eye");
            assertEquals("color", form.get("kind"));
            float[] edge = (float[]) form.get("edge");
            assertEquals("to the left by half of 60 degrees", Math.tan(Math.PI / 6), edge[0] / edge[2], 1e-6);
            assertEquals("and up by the share of the rows", edge[0] * 1080 / 1920, edge[1], 1e-6);
            step(world, STEPS_BETWEEN);
            assertFalse(((Map<?, ?>) next(world).get("changes")).toString().contains("eye"));
            CameraImage image = (CameraImage) world.read("eye");
            Map<String, Object> told = CameraPicture.of("eye", image, 1.25, new CameraPicture.Wish(320, 7, 8));
            assertTrue("small: " + told.get("picture").toString().length(), told.get("picture").toString()
                .length() < 40_000);
            assertEquals(1920, told.get("width"));
            assertTrue(told.toString(), told.get("pixel").toString().matches("#[0-9a-f]{6}, .*, 1[.]250 m ahead"));
        }
    }

    /** Panels get the beam directions once, then one range per beam. */
    @Test
    public void panelsGetTheDirectionsOfAScannersBeams() throws Exception {
        Path folder = temporary.newFolder().toPath();
        Path robot = Files.createDirectories(folder.resolve("robot"));
        Files.writeString(robot.resolve("r.xml"),
            "<SEARrobot><name>r</name><component>d</component><component>eye</component></SEARrobot>");
        Files.writeString(robot.resolve("d.xml"), "<Dynamics><name>d</name><mass>1</mass></Dynamics>");
        Files.writeString(robot.resolve("eye.xml"),
            "<LIDAR><name>eye</name><range>8</range><spread>180</spread><resolution>45</resolution></LIDAR>");
        try (Simulation world = Simulation.load(folder, 1)) {
            Map<?, ?> eye = (Map<?, ?>) ((List<?>) next(world).get("sensors")).get(0);
            List<?> fan = (List<?>) eye.get("fan");
            assertEquals(Base64.getDecoder().decode((String) eye.get("ranges")).length, 2 * (1 + fan.size()));
            float half = (float) Math.sqrt(0.5);
            float[][] wanted = {{-1, 0, 0}, {-half, 0, half}, {0, 0, 1}, {half, 0, half}, {1, 0, 0}};
            for (int i = 0; i < wanted.length; i++) {
                assertArrayEquals(wanted[i], (float[]) fan.get(i), 1e-6f);
            }
            step(world, STEPS_BETWEEN);
            assertFalse(((Map<?, ?>) next(world).get("changes")).toString().contains("fan"));
        }
    }

    /**
     * Makes robots with a scanner of 361 beams each that fall beside slanting posts, so that each range changes at each
     * step.
     */
    private Simulation scanners() throws IOException, ProjectException {
        Path folder = temporary.newFolder().toPath();
        Path robot = Files.createDirectories(folder.resolve("robot"));
        for (int i = 0; i < ROBOTS; i++) {
            Files.writeString(robot.resolve("r" + i + ".xml"), "<SEARrobot><name>r" + i + "</name><component>d" + i
                + "</component><component>eye" + i + "</component></SEARrobot>");
            Files.writeString(robot.resolve("d" + i + ".xml"), "<Dynamics><name>d" + i
                + "</name><mass>1</mass><x>" + 2 * i + "</x><y>3</y></Dynamics>");
            Files.writeString(robot.resolve("eye" + i + ".xml"), "<LIDAR><name>eye" + i
                + "</name><range>8</range><spread>180</spread><resolution>0.5</resolution></LIDAR>");
        }
        Path environment = Files.createDirectories(folder.resolve("environment"));
        for (int i = 0; i < 10 * ROBOTS; i++) {
            Files.writeString(environment.resolve("post" + i + ".xml"),
                box("post" + i, 0.3, i % 10 * 2 + 1, 0, i / 10 * 1.3 - 6, 0).replace(
                "<height>0.3", "<rx>25</rx><height>9"));
        }
        return Simulation.load(folder, 1);
    }

    /** 2 bytes per beam in Base64, plus the other data of a falling robot. */
    @Test
    public void tenRobotsWithScannersCostTwelveKilobytesAMessage() throws Exception {
        try (Simulation world = scanners()) {
            assertEquals(ROBOTS, ((List<?>) next(world).get("robots")).size());
            int most = 0;
            for (int i = 0; i < 5; i++) {
                step(world, STEPS_BETWEEN);
                Map<String, Object> message = next(world);
                Map<?, ?> sensors = (Map<?, ?>) ((Map<?, ?>) message.get("changes")).get("sensors");
                assertEquals("a scan of each", ROBOTS,
                    sensors.values().stream().filter(sensor -> ((Map<?, ?>) sensor).containsKey("ranges")).count());
                most = Math.max(most, bytes(message));
            }
            System.out.println("a message about " + ROBOTS + " robots with a scanner each has at most " + most
                + " bytes");
            assertTrue("bytes: " + most, most < ROBOTS * SCAN_BYTES);
        }
    }
}
