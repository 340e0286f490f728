// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.SEAR.Digests;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * Scripts of examples/drive in lock-step: the robot reaches the script's goal, and its record has the listed checksum.
 */
public class DrivingExamplesTest {
    private static final Path EXAMPLES = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath()
        .resolve("examples");

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    @Before
    public void bringBundles() throws IOException {
        Path bundles = folder.newFolder("examples").toPath();
        try (Stream<Path> files = Files.list(EXAMPLES)) {
            for (Path bundle : (Iterable<Path>) files.filter(file -> file.toString().endsWith(".sear"))::iterator) {
                Files.copy(bundle, bundles.resolve(bundle.getFileName()));
            }
        }
    }

    private String run(String script, String... things) throws Exception {
        StringBuilder code = new StringBuilder(Files.readString(EXAMPLES.resolve("drive").resolve(script)));
        for (String thing : things) {
            code.append("print '").append(thing).append(" ends at %.3f %.3f' % (sear.getPose('").append(thing)
                .append("')[0], sear.getPose('").append(thing).append("')[2])\n");
        }
        Path file = folder.getRoot().toPath().resolve(script);
        Files.writeString(file, code);
        Path record = folder.getRoot().toPath().resolve(script + ".searlog");
        String text = ScriptProcess.run(folder.getRoot().toPath(), file, "--record", record.toString());
        Digests.assertSame("drive/" + script, Digests.hex(record));
        return text;
    }

    private static double[] numbers(String text, String pattern) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertTrue("no \"" + pattern + "\" in:\n" + text, matcher.find());
        double[] numbers = new double[matcher.groupCount()];
        for (int i = 0; i < numbers.length; i++) {
            numbers[i] = Double.parseDouble(matcher.group(i + 1));
        }
        return numbers;
    }

    private static double[] end(String text, String thing) {
        return numbers(text, thing + " ends at (-?[0-9.]+) (-?[0-9.]+)");
    }

    @Test
    public void everyScriptIsTriedHere() throws IOException {
        try (Stream<Path> scripts = Files.list(EXAMPLES.resolve("drive"))) {
            assertEquals(List.of("arduino_rover.py", "balance.py", "car_waypoints.py", "follow_ball.py",
                "gps_waypoints.py", "lidar_mapper.py", "line_follower.py",
                "map_driver.py", "maze_solver.py", "mountain_climber.py", "obstacle_avoidance.py", "radar_turret.py",
                    "wall_follower.py"),
                scripts.map(script -> script.getFileName().toString()).sorted().collect(Collectors.toList()));
        }
    }

    @Test
    public void theRobotOnTwoWheelsBalances() throws Exception {
        assertEquals(2.5, numbers(run("balance.py"), "Balances at z = ([0-9.]+)")[0], 0.05);
    }

    @Test
    public void theMazeIsSolved() throws Exception {
        String text = run("maze_solver.py", "maze Roomba", "goal");
        double[] robot = end(text, "maze Roomba");
        double[] goal = end(text, "goal");
        assertEquals("the cone still stands where it stood", 0, Math.hypot(goal[0] + 2, goal[1] - 2), 0.01);
        assertTrue(text, Math.hypot(goal[0] - robot[0], goal[1] - robot[1]) < 0.65);
    }

    @Test
    public void aRosMapIsDrivenThrough() throws Exception {
        double[] drive = numbers(run("map_driver.py"), "x (-?[0-9.]+), z (-?[0-9.]+); (\\d+) of (\\d+) beams");
        assertEquals(0, Math.hypot(drive[0] - 1.6, drive[1] - 2.6), 0.1);
        assertEquals("all beams end on the map's walls", drive[3], drive[2], 0);
        assertTrue(drive[3] > 300);
    }

    @Test
    public void theWallIsFollowedAllAround() throws Exception {
        String text = run("wall_follower.py", "follower");
        double[] robot = end(text, "follower");
        assertEquals(text, 0, Math.hypot(robot[0] + 1.5, robot[1] + 1), 0.35);
        double[] drive = numbers(text, "Once round: ([0-9.]+) m in \\d+ s, the wall never nearer than ([0-9.]+) m");
        assertEquals("the walls are 18 m long", 14.5, drive[0], 1.5);
        assertTrue(text, drive[1] > 0.1);
    }

    @Test
    public void theConeInTheWayIsAvoided() throws Exception {
        String text = run("obstacle_avoidance.py", "office Roomba", "wet floor");
        double[] robot = end(text, "office Roomba");
        assertEquals(text, 0, Math.hypot(robot[0] - 1.9, robot[1] - 1.8), 0.15);
        double[] cone = end(text, "wet floor");
        assertEquals("untouched", 0, Math.hypot(cone[0] - 0.6, cone[1] - 0.9), 0.01);
        assertTrue(text, text.contains("round an obstacle"));
    }

    @Test
    public void theWaypointsAreReached() throws Exception {
        String text = run("gps_waypoints.py", "myRoomba");
        double[][] waypoints = {{1.2, 1.5}, {4, 1.8}, {-1.2, 0.8}, {0, 0}};
        for (int i = 0; i < waypoints.length; i++) {
            double[] at = numbers(text, "Waypoint " + (i + 1) + " after .*, x (-?[0-9.]+) m, z (-?[0-9.]+) m");
            assertEquals(text, 0, Math.hypot(at[0] - waypoints[i][0], at[1] - waypoints[i][1]), 0.6);
        }
    }

    @Test
    public void theSummitIsReached() throws Exception {
        String text = run("mountain_climber.py", "rover", "summit");
        double[] rover = end(text, "rover");
        double[] summit = end(text, "summit");
        assertEquals(text, 0, Math.hypot(rover[0] - summit[0], rover[1] - summit[1]), 3);
        double[] fix = numbers(text, "On the summit after ([0-9.]+) s: latitude ([0-9.]+), longitude (-[0-9.]+), "
            + "([0-9.]+) m above the sea");
        assertEquals(text, 36.485, fix[1], 3e-5);
        assertEquals(text, -84.23083, fix[2], 3e-5);
        assertEquals("the map's summit is 1076 m high", 1076, fix[3], 1.5);
        double[] start = numbers(text, "After \\d+ s: (\\d+) m high, (\\d+) m to go");
        assertTrue("it climbs: " + text, start[0] < 1076 - 15 && start[1] > 150);
    }

    @Test
    public void theMapShowsTheOffice() throws Exception {
        String text = run("lidar_mapper.py", "office Roomba");
        BufferedImage map = ImageIO.read(folder.getRoot().toPath().resolve("map.png").toFile());
        double[] robot = end(text, "office Roomba");
        assertEquals("white where the robot stands", 0xffffff, pixel(map, robot[0], robot[1]));
        assertEquals("grey where nobody has looked", 0xa0a0a0, pixel(map, 4.4, -3.4));
        List<Double> missing = new ArrayList<>();
        for (double z = -2.4; z <= 2.4; z += 0.1) {
            if (pixel(map, 3.98, z) != 0 && pixel(map, 4.02, z) != 0) {
                missing.add(z);
            }
        }
        assertTrue("black where the north wall is, but for what furniture hides: " + missing, missing.size() < 15);
        assertEquals("the ROS map", 15 + map.getWidth() * map.getHeight(),
            Files.size(folder.getRoot().toPath().resolve("map.pgm")));
        assertTrue(Files.readString(folder.getRoot().toPath().resolve("map.yaml")).startsWith(
            "image: map.pgm\nresolution: 0.05\norigin: [-3.5, -4.5, 0]\n"));
        double[] counts = numbers(text, "(\\d+) scans: ([0-9.]+) square metres are free");
        assertEquals(32, counts[0], 0);
        assertEquals("of 48 square metres", 44, counts[1], 4);
    }

    /** Checks that objects stand at the x and z where the scripts of the examples put them. */
    private static void assertUntouched(String text, Map<String, double[]> places) {
        places.forEach((name, place) -> assertArrayEquals(name + "\n" + text, place, end(text, name), 0.001));
    }

    @Test
    public void theRoverTouchesNothing() throws Exception {
        Map<String, double[]> places = Map.of("north wall", at(2, 0), "south wall", at(-2, 0), "east wall", at(0, 1.6),
            "west wall", at(0, -1.6),
            "crate 1", at(0.9, 0.7), "crate 2", at(0.6, -0.9), "crate 3", at(-0.9, 0.8), "crate 4", at(-1.1, -0.5));
        String text = run("arduino_rover.py", places.keySet().toArray(new String[0]));
        assertUntouched(text, places);
        double[] drive = numbers(text, "([0-9.]+) m in \\d+ s, with (\\d+) turns");
        assertEquals(text, 10, drive[0], 0.2);
        assertTrue("the room is 4 m long", drive[1] >= 5);
    }

    @Test
    public void theCarDrivesThroughAllGates() throws Exception {
        double[][] gates = {{6, 0, 0}, {10, 5, 80}, {4, 9, 190}, {-3, 5, 250}, {-1, -4, 330}};
        Map<String, double[]> cones = new TreeMap<>();
        for (int i = 0; i < gates.length; i++) {
            double north = 1.2 * Math.sin(Math.toRadians(gates[i][2]));
            double east = 1.2 * Math.cos(Math.toRadians(gates[i][2]));
            cones.put("gate " + (i + 1) + ", left", at(gates[i][0] + north, gates[i][1] - east));
            cones.put("gate " + (i + 1) + ", right", at(gates[i][0] - north, gates[i][1] + east));
        }
        String text = run("car_waypoints.py", cones.keySet().toArray(new String[0]));
        assertUntouched(text, cones);
        for (int i = 0; i < gates.length; i++) {
            double[] at = numbers(text, "Waypoint " + (i + 1) + " after .*, x (-?[0-9.]+) m, z (-?[0-9.]+) m");
            assertEquals(text, 0, Math.hypot(at[0] - gates[i][0], at[1] - gates[i][1]), 1);
        }
    }

    @Test
    public void theLineIsFollowedAllAround() throws Exception {
        String text = run("line_follower.py", "follower");
        double[] round = numbers(text, "Once round in [0-9.]+ s: ([0-9.]+) m, the line lost (\\d+) times");
        assertEquals("the tape is 4.9 m long", 4.9, round[0], 0.15);
        assertEquals(text, 0, round[1], 0);
        double[] robot = end(text, "follower");
        assertEquals(text, 0, Math.hypot(robot[0] - 0.85, robot[1]), 0.05);
    }

    @Test
    public void theBallIsFollowedByTheCamera() throws Exception {
        String text = run("follow_ball.py", "hunter", "ball");
        double[] sight = numbers(text, "In sight (\\d+) of (\\d+) times; at the end ([0-9.]+) m ahead, (-?[0-9]+) "
            + "degrees to the left");
        assertTrue(text, sight[0] > 0.95 * sight[1]);
        assertEquals(text, 0.7, sight[2], 0.1);
        assertEquals(text, 0, sight[3], 5);
        double[] robot = end(text, "hunter");
        double[] ball = end(text, "ball");
        assertEquals("the camera is 0.1 m ahead", 0.8, Math.hypot(ball[0] - robot[0], ball[1] - robot[1]), 0.15);
        assertTrue("it has gone after it: " + text, Math.hypot(robot[0], robot[1]) > 1);
    }

    @Test
    public void theRadarShowsTheNearestObject() throws Exception {
        String text = run("radar_turret.py", "scout", "bin");
        double[] nearest = numbers(text, "echoes. Nearest: ([0-9.]+) m from the turret, (-?[0-9.]+) "
            + "degrees to the left");
        assertEquals("the bin is 1.22 m away and 0.2 m thick", Math.hypot(1, 0.7) - 0.2, nearest[0], 0.03);
        assertEquals(text, Math.toDegrees(Math.atan2(0.7, 1)), nearest[1], 4);
        List<String> lines = text.lines().collect(Collectors.toList());
        int axis = lines.indexOf(lines.stream().filter(line -> line.length() == 61 && line.charAt(30) == '^')
            .findFirst().orElseThrow());
        assertEquals(text, '#', lines.get(axis - 4).charAt(30 - 6));      // 0.8 m ahead, 0.6 m to the left
        for (int row = 0; row < 4; row++) {
            assertEquals("nothing is nearer\n" + text, -1, lines.get(axis - row).substring(25, 36).indexOf('#'));
        }
    }

    private static double[] at(double x, double z) {
        return new double[] {x, z};
    }

    private static int pixel(BufferedImage map, double x, double z) {
        return map.getRGB((int) ((z + 3.5) / 0.05), (int) ((4.5 - x) / 0.05)) & 0xffffff;
    }
}
