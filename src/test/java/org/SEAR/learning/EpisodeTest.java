// SPDX-License-Identifier: Apache-2.0
package org.SEAR.learning;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.List;
import org.SEAR.POJOs.Box;
import org.SEAR.POJOs.Bumper;
import org.SEAR.POJOs.Camera;
import org.SEAR.POJOs.Compass;
import org.SEAR.POJOs.Distance;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.GPS;
import org.SEAR.POJOs.Hinge;
import org.SEAR.POJOs.LIDAR;
import org.SEAR.POJOs.Noise;
import org.SEAR.POJOs.SEARrobot;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.sensors.CameraImage;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Episodes of reinforcement learning. */
public class EpisodeTest {
    private static final int BEAMS = 181;
    private static final double RANGE = 8;
    /** Index of a number in the state. */
    private static final int TIME = 0;
    private static final int X = 1;
    private static final int Z = 3;
    private static final int HEADING = 4;
    private static final int SPEED = 6;
    private static final int PATH = 8;
    private static final int TURNED = 9;
    private static final int LEFT = 10;
    private static final int RIGHT = 11;
    private static final int TOUCHED = 12;

    @Rule
    public final ProjectRule project = new ProjectRule();

    private ByteBuffer memory;

    /** Makes a robot at the origin that looks east, and a wall 2 m ahead. */
    private SEARrobot room() {
        new Floor("floor", 20, 20, false);
        Box wall = new Box("wall", 6, 0.2, 1, 0);
        wall.move(0, 0.5, 2.1);
        return Worlds.roomba("roomba", 0, 0, 0);
    }

    private LIDAR lidar(SEARrobot robot) {
        LIDAR lidar = new LIDAR("lidar", RANGE, BEAMS - 1, 1, 0, 0.2, 0);
        robot.addComponent(lidar);
        return lidar;
    }

    private Episode episode(List<String> sensors, String... things) throws Exception {
        return watched(new Episode(Project.read(project.folder()), "", sensors, List.of(things), 1, 7));
    }

    private Episode watched(Episode episode) {
        memory = ByteBuffer.allocateDirect(episode.getBytes());
        episode.setMemory(memory);
        return episode;
    }

    private double state(int number) {
        return memory.getDouble(number * Double.BYTES);
    }

    private double seen(Episode episode, int number) {
        return memory.getFloat(episode.getStateBytes() + number * Float.BYTES);
    }

    private byte[] bytes() {
        byte[] bytes = new byte[memory.capacity()];
        memory.duplicate().get(bytes);
        return bytes;
    }

    @Test
    public void readingsAreInTheOrderOfTheirNames() throws Exception {
        SEARrobot robot = room();
        lidar(robot);
        robot.addComponent(new Distance("ping", "PING)))", 0, 0.2, 0.1, 0, 0, 0));
        robot.addComponent(new Bumper("bumper"));
        robot.addComponent(new Camera("eye", 0, 0.2, 0.1));
        Episode all = episode(null);
        assertEquals("all but the camera", List.of("lidar", "ping", "bumper"), all.getNames());
        assertArrayEquals(new int[] {BEAMS, 1, 1}, all.getSizes());
        assertArrayEquals(new double[] {0, 0, 0}, all.getLows(), 0);
        assertEquals(RANGE, all.getHighs()[0], 0);
        assertEquals(1, all.getHighs()[2], 0);
        assertEquals("straight ahead", 2, seen(all, BEAMS / 2), 1e-3);
        assertEquals("to the right there is nothing", RANGE, seen(all, 0), 0);
        assertEquals("the PING)))", 1.9, seen(all, BEAMS), 1e-3);

        Episode some = episode(List.of("ping", "lidar"));
        assertEquals(List.of("ping", "lidar"), some.getNames());
        assertEquals(1.9, seen(some, 0), 1e-3);
        assertEquals(2, seen(some, 1 + BEAMS / 2), 1e-3);
    }

    @Test
    public void aCameraGivesItsPictureBehindTheNumbers() throws Exception {
        SEARrobot robot = room();
        Camera eye = new Camera("eye", 0, 0.2, 0.1);
        eye.setSize(8, 6);
        robot.addComponent(eye);
        assertEquals("the only sensor", List.of("eye"), episode(null, "wall").getPictureNames());
        robot.addComponent(new Bumper("bumper"));
        Episode episode = episode(List.of("eye", "bumper"));
        assertArrayEquals(new int[] {8, 6}, episode.getPictureSizes());
        assertEquals(List.of("bumper"), episode.getNames());
        assertEquals(episode.getStateBytes() + Float.BYTES + 8 * 6 * 3, episode.getBytes());
        int[] seen = ((CameraImage) episode.getSimulation().read("eye")).picture().getPixels();
        int at = episode.getStateBytes() + Float.BYTES + 3 * 20;
        assertEquals(seen[20] & 0xffffff, (memory.get(at) & 0xff) << 16 | (memory.get(at + 1) & 0xff) << 8
            | memory.get(at + 2) & 0xff);
    }

    @Test
    public void aGpsGivesMetresFromTheOrigin() throws Exception {
        room().addComponent(new GPS("gps", 47.5, 300, 11.25, 0, 0.2, 0.1));
        Episode episode = episode(null);
        assertArrayEquals(new int[] {3}, episode.getSizes());
        assertEquals("north", 0, seen(episode, 0), 1e-3);
        assertEquals("up, above the axle", 0.3, seen(episode, 1), 0.01);
        assertEquals("east", 0.1, seen(episode, 2), 1e-3);
    }

    @Test
    public void anObjectIsWhereABeaconWouldReportIt() throws Exception {
        room();
        Box dock = new Box("dock", 0.2, 0.2, 0.2, 0);
        dock.move(1, 0.1, -3);
        dock.rotate(0, 90, 0);
        Episode episode = episode(List.of(), "dock");
        assertArrayEquals(new int[] {4}, episode.getSizes());
        assertEquals("ahead", -3, seen(episode, 0), 1e-3);
        assertEquals("to the left, north", 1, seen(episode, 1), 1e-3);
        assertEquals("it looks to the left", 0, seen(episode, 2), 1e-3);
        assertEquals(1, seen(episode, 3), 1e-3);
    }

    @Test
    public void anActionLastsItsNumberOfSteps() throws Exception {
        room();
        Episode episode = episode(null, "floor");
        episode.step(0.5, 0.5, 60);
        assertEquals(1, state(TIME), 1e-9);
        assertEquals("east", 0.45, state(Z), 0.06);
        assertEquals(0, state(X), 0.01);
        assertEquals(90, state(HEADING), 1);
        assertEquals(0.5, state(SPEED), 0.02);
        assertEquals(state(Z), state(PATH), 0.01);
        episode.step(-0.2, 0.2, 60);
        assertTrue("to the left: " + state(TURNED), state(TURNED) > 20);
        assertEquals("and so to the north", 90 - state(TURNED), state(HEADING), 1);
        assertEquals(0, state(TOUCHED), 0);
    }

    @Test
    public void aBumpDuringAnActionIsReported() throws Exception {
        room();
        Episode episode = episode(null, "floor");
        episode.step(0.5, 0.5, 180);
        assertEquals(0, state(LEFT) + state(RIGHT), 0);
        episode.step(0.5, 0.5, 60);
        assertEquals("left, right, any part", 3, state(LEFT) + state(RIGHT) + state(TOUCHED), 0);
        episode.step(-0.5, -0.5, 60);
        assertEquals("it stood at the wall when the action began", 3, state(LEFT) + state(RIGHT) + state(TOUCHED), 1);
        episode.step(-0.5, -0.5, 60);
        assertEquals(0, state(LEFT) + state(RIGHT) + state(TOUCHED), 0);
    }

    /** Drives a fixed sequence and returns the observations. */
    private byte[] drive(Episode episode) {
        watched(episode);
        byte[] all = bytes();
        for (int i = 0; i < 20; i++) {
            episode.step(0.1 + 0.02 * i, 0.3, 6);
            int at = all.length;
            all = Arrays.copyOf(all, at + memory.capacity());
            System.arraycopy(bytes(), 0, all, at, memory.capacity());
        }
        return all;
    }

    @Test
    public void aSeedGivesTheSameBytesIndependentlyOfEarlierEpisodes() throws Exception {
        SEARrobot robot = room();
        lidar(robot).setNoise(new Noise().setWhite(0.02).setDrift(0.05).setDropout(0.1));
        Compass compass = new Compass("compass");
        compass.setNoise(new Noise().setWhite(1));
        robot.addComponent(compass);
        new Box("crate", 0.3, 0.3, 0.3, 2).move(0.1, 0.15, 0.6);
        Episode episode = episode(null);
        byte[] seven = drive(episode);
        episode.reset(8);
        byte[] eight = drive(episode);
        assertFalse("another seed", Arrays.equals(seven, eight));
        episode.reset(7);
        assertArrayEquals("again", seven, drive(episode));
        Episode other = new Episode(Project.read(project.folder()), "", null, List.of(), 1, 1);
        other.reset(8);
        assertArrayEquals("in another world that had another seed", eight, drive(other));
        assertArrayEquals("in a new one", eight,
            drive(new Episode(Project.read(project.folder()), "", null, List.of(), 1, 8)));
        other.reset(8, 1, -1, 0);
        byte[] elsewhere = drive(other);
        assertFalse(Arrays.equals(eight, elsewhere));
        episode.reset(8, 1, -1, 0);
        assertArrayEquals("from another place", elsewhere, drive(episode));
        episode.reset(8);
        assertArrayEquals("and back", eight, drive(episode));
    }

    @Test
    public void anEpisodeStartsAtTheGivenPlace() throws Exception {
        room();
        Box hill = new Box("hill", 2, 2, 0.2, 0);
        hill.move(-3, 0.1, -3);
        hill.setMass(0);
        Episode episode = episode(null, "floor");
        double level = memory.getDouble(2 * Double.BYTES);
        episode.reset(1, 1, -2, 30);
        assertEquals(1, state(X), 1e-6);
        assertEquals(-2, state(Z), 1e-6);
        assertEquals(30, state(HEADING), 1e-4);
        assertEquals("on the floor", level, memory.getDouble(2 * Double.BYTES), 0.05);
        episode.step(0, 0, 60);
        assertEquals("it stays there", 1, state(X), 0.01);
        episode.reset(1, -3, -3, 0);
        assertEquals("on the hill", level + 0.2, memory.getDouble(2 * Double.BYTES), 0.05);
        episode.reset(1);
        assertEquals("at its own place", 0, state(X), 1e-6);
        assertEquals(90, state(HEADING), 1e-4);
    }

    @Test
    public void aDroppedBeamKeepsItsIndex() throws Exception {
        SEARrobot robot = room();
        Compass compass = new Compass("compass");
        compass.setNoise(new Noise().setWhite(0.5).setDropout(0.5));
        robot.addComponent(compass);
        Episode episode = episode(null);
        int same = 0;
        double before = seen(episode, 0);
        for (int i = 0; i < 100; i++) {
            episode.step(0, 0, 1);
            double now = seen(episode, 0);
            assertFalse("step " + i, Double.isNaN(now));
            same += now == before ? 1 : 0;
            before = now;
        }
        assertEquals("of 100 readings as the one before", 50, same, 25);
    }

    private void assertRefused(String message, org.junit.function.ThrowingRunnable call) {
        assertEquals(message, assertThrows(IllegalArgumentException.class, call).getMessage());
    }

    @Test
    public void errorsAreReported() throws Exception {
        SEARrobot robot = room();
        robot.addComponent(new Camera("eye", 0, 0.2, 0.1));
        robot.addComponent(new Bumper("bumper"));
        Project read = Project.read(project.folder());
        assertRefused("robot is \"rover\", legal: roomba", () -> new Episode(read, "rover", null, List.of(), 1, 1));
        assertRefused("no sensor is called \"ping\", legal: bumper, eye",
            () -> new Episode(read, "", List.of("ping"), List.of(), 1, 1));
        assertRefused("robot roomba observes nothing: sensors and things are empty, legal: sensors of eye, bumper, or "
            + "names of objects in things", () -> new Episode(read, "", List.of(), List.of(), 1, 1));
        Episode episode = new Episode(read, "roomba", null, List.of(), 0.5, 1);
        assertRefused("robot roomba: wheel speeds are 0.6 and NaN m/s, legal: -0.5 to 0.5",
            () -> episode.step(0.6, Double.NaN, 1));
        assertRefused("steps of an action are 0, legal: 1 to 216000", () -> episode.step(0.1, 0.1, 0));
        assertRefused("robot roomba: start is x NaN, z 0.0, heading 0.0, legal: finite numbers",
            () -> episode.reset(1, Double.NaN, 0, 0));
        assertRefused("the buffer has 8 bytes, legal: " + episode.getBytes() + " or more",
            () -> episode.setMemory(ByteBuffer.allocate(8)));
        assertRefused("picture is 8 x 100 pixels, legal: 16 to 4096", () -> episode.draw(8, 100));
    }

    @Test
    public void aWorldWithoutARobotOrWithTwoIsRefused() throws Exception {
        new Floor("floor", 20, 20);
        Project none = Project.read(project.folder());
        assertRefused("the project has no robot; legal: one with a robot that drives",
            () -> new Episode(none, "", null, List.of(), 1, 1));
        Worlds.roomba("one", 0, 0, 0);
        Worlds.roomba("two", 2, 0, 0);
        Project two = Project.read(project.folder());
        assertRefused("robot is not given, legal: one, two", () -> new Episode(two, "", null, List.of(), 1, 1));
        assertEquals("two", new Episode(two, "two", null, List.of("floor"), 1, 1).getRobot());
    }

    @Test
    public void jointsAreObservedAndDriven() throws Exception {
        room();
        Hinge hinge = new Hinge("gate", null, new Box("leaf", 0.8, 0.04, 1, 5, 2, 1, -2), 2, 1, -2);
        hinge.setMotor(20, 90);
        hinge.setLimits(0, 60);
        try (Episode episode = episode(List.of("gate"))) {
            assertArrayEquals(new int[] {3}, episode.getSizes());
            episode.setControls(List.of("gate", "left", "right"));
            episode.act(new double[] {50, 0, 0}, 120);
            assertEquals("position", 50, memory.getFloat(episode.getStateBytes()), 0.1);
            assertRefused("robot roomba: gate is 61, legal: 0 to 60", () -> episode.check(61, 0, 0));
            episode.setControls(List.of("gate.power"));
            episode.act(new double[] {-1}, 6);
            assertTrue("speed", memory.getFloat(episode.getStateBytes() + Float.BYTES) < -10);
            assertRefused("robot roomba has no motor or servo \"gate.torque\" for actions, legal: gate, left and "
                + "right, speed, steering", () -> episode.setControls(List.of("gate.torque")));
        }
    }

    @Test
    public void thePictureShowsTheWorldNorthUp() throws Exception {
        new Floor("floor", 10, 10);
        Box red = new Box("red", 2, 2, 1, 0);
        red.setColor("#ff0000");
        red.move(3, 0.5, 0);
        Box blue = new Box("blue", 2, 2, 1, 0);
        blue.setColor("#0000ff");
        blue.move(0, 0.5, 3);
        Worlds.roomba("roomba", 0, 0, 0);
        Episode episode = episode(null, "floor");
        byte[] pixels = episode.draw(100, 100);
        assertEquals(3 * 100 * 100, pixels.length);
        assertEquals("in the north", 0xff0000, color(pixels, 50, 22));
        assertEquals("in the east", 0x0000ff, color(pixels, 78, 50));
        assertEquals("the floor is white", 0xffffff, color(pixels, 22, 78));
        assertEquals("what is no floor is not", 0xf4f4f0, color(pixels, 0, 0));
        byte[] before = pixels.clone();
        episode.step(0.5, 0.5, 60);
        assertFalse("the robot has driven", Arrays.equals(before, episode.draw(100, 100)));
        episode.close();
    }

    private static int color(byte[] pixels, int x, int y) {
        int at = 3 * (100 * y + x);
        return (pixels[at] & 0xff) << 16 | (pixels[at + 1] & 0xff) << 8 | pixels[at + 2] & 0xff;
    }
}
