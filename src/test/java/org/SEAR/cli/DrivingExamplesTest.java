package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The scripts in examples/drive, each in lock-step: the robot gets where the script wants it to be. */
public class DrivingExamplesTest {
    private static final Path EXAMPLES = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath().resolve("examples");

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

    /**
     * Runs a script.
     *
     * @param things whose poses are asked for when it has ended
     * @return what it printed, and x and z of each of these
     */
    private String run(String script, String... things) throws Exception {
        StringBuilder code = new StringBuilder(Files.readString(EXAMPLES.resolve("drive").resolve(script)));
        for (String thing : things) {
            code.append("print '").append(thing).append(" ends at %.3f %.3f' % (sear.getPose('").append(thing).append("')[0], sear.getPose('")
                .append(thing).append("')[2])\n");
        }
        Path file = folder.getRoot().toPath().resolve(script);
        Files.writeString(file, code);
        return ScriptProcess.run(folder.getRoot().toPath(), file);
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
            assertEquals(List.of("gps_waypoints.py", "lidar_mapper.py", "maze_solver.py", "mountain_climber.py", "obstacle_avoidance.py",
                "wall_follower.py"),
                scripts.map(script -> script.getFileName().toString()).sorted().collect(Collectors.toList()));
        }
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
    public void theWallIsFollowedOnceRound() throws Exception {
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
        double[] fix = numbers(text, "On the summit after ([0-9.]+) s: latitude ([0-9.]+), longitude (-[0-9.]+), ([0-9.]+) m above the sea");
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
        double[] counts = numbers(text, "(\\d+) scans: ([0-9.]+) square metres are free");
        assertEquals(32, counts[0], 0);
        assertEquals("of 48 square metres", 44, counts[1], 4);
    }

    private static int pixel(BufferedImage map, double x, double z) {
        return map.getRGB((int) ((z + 3.5) / 0.05), (int) ((4.5 - x) / 0.05)) & 0xffffff;
    }
}
