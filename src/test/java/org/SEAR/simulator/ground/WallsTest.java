// SPDX-License-Identifier: Apache-2.0
package org.SEAR.simulator.ground;

import static org.junit.Assert.assertArrayEquals;
import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertThrows;
import static org.junit.Assert.assertTrue;

import java.awt.image.BufferedImage;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.IntStream;
import javax.imageio.ImageIO;
import org.SEAR.POJOs.Floor;
import org.SEAR.POJOs.FloorPlan;
import org.SEAR.POJOs.Maze;
import org.SEAR.POJOs.Sphere;
import org.SEAR.POJOs.Wall;
import org.SEAR.POJOs.WallCorner;
import org.SEAR.physics.RaycastScenes;
import org.SEAR.plan.Outline;
import org.SEAR.project.Project;
import org.SEAR.project.ProjectRule;
import org.SEAR.project.edit.ProjectEditor;
import org.SEAR.project.problems.ProjectException;
import org.SEAR.project.script.ProjectScript;
import org.SEAR.raycast.Hit;
import org.SEAR.simulator.Simulation;
import org.SEAR.simulator.Worlds;
import org.junit.Rule;
import org.junit.Test;

/** Walls from pictures, ROS maps and text are exact for beams and contacts; hostile files are refused in words. */
public class WallsTest {
    private static final double SIDE = 0.05;
    private static final int ROWS = 40;
    private static final int COLUMNS = 60;
    private static final String YAML = "image: map.pgm\nresolution: 0.05\norigin: [1, -2, 0]\nnegate: 0\n"
        + "occupied_thresh: 0.65\nfree_thresh: 0.196\n";

    @Rule
    public final ProjectRule project = new ProjectRule();

    private Path asset(String name) throws Exception {
        return Files.createDirectories(project.folder().resolve("assets")).resolve(name);
    }

    private static boolean[][] random(long seed) {
        Random random = new Random(seed);
        boolean[][] wall = new boolean[ROWS][COLUMNS];
        for (int n = 0; n < 25; n++) {
            int row = random.nextInt(ROWS);
            int column = random.nextInt(COLUMNS);
            boolean along = random.nextBoolean();
            for (int i = 0; i < 1 + random.nextInt(15); i++) {
                wall[Math.min(ROWS - 1, row + (along ? i : 0))][Math.min(COLUMNS - 1, column + (along ? 0 : i))] = true;
            }
        }
        return wall;
    }

    /** Marches from pixel to pixel; returns the distance to the first wall, pixels; infinity for none. */
    private static double march(boolean[][] wall, double row, double column, double down, double right) {
        int r = (int) Math.floor(row);
        int c = (int) Math.floor(column);
        double t = 0;
        while (r >= 0 && c >= 0 && r < ROWS && c < COLUMNS) {
            if (wall[r][c]) {
                return t;
            }
            double nextRow = down == 0 ? Double.POSITIVE_INFINITY : ((down > 0 ? r + 1 : r) - row) / down;
            double nextColumn = right == 0 ? Double.POSITIVE_INFINITY : ((right > 0 ? c + 1 : c) - column) / right;
            t = Math.min(nextRow, nextColumn);
            if (nextRow < nextColumn) {
                r += down > 0 ? 1 : -1;
            } else {
                c += right > 0 ? 1 : -1;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    @Test
    public void beamsEqualThePicturesOwnMarch() throws Exception {
        boolean[][] wall = random(7);
        BufferedImage picture = new BufferedImage(COLUMNS, ROWS, BufferedImage.TYPE_INT_RGB);
        for (int r = 0; r < ROWS; r++) {
            for (int c = 0; c < COLUMNS; c++) {
                picture.setRGB(c, r, wall[r][c] ? 0x202020 : 0xf0f0f0);
            }
        }
        ImageIO.write(picture, "png", asset("plan.png").toFile());
        new FloorPlan("plan", "plan.png", SIDE, 1);
        Simulation world = Worlds.start(project);
        RaycastScenes scenes = Worlds.scenes(world);
        Random random = new Random(8);
        int beams = 0;
        while (beams < 100_000) {
            double row = random.nextDouble() * ROWS;
            double column = random.nextDouble() * COLUMNS;
            if (wall[(int) row][(int) column]) {
                continue;
            }
            beams++;
            double angle = random.nextDouble() * 2 * Math.PI;
            double north = Math.cos(angle);
            double east = Math.sin(angle);
            double expected = SIDE * march(wall, row, column, -north, east);
            double measured = scenes.beams.cast((ROWS / 2.0 - row) * SIDE, 0.5, (column - COLUMNS / 2.0) * SIDE, north,
                0, east, 1e9, -1, new Hit());
            if (measured != expected) {
                assertEquals("row " + row + " column " + column + " angle " + angle, expected, measured, 1e-5);
            }
        }
    }

    private void pgm(String name, int rows, int columns, int... black) throws Exception {
        byte[] pixels = new byte[rows * columns];
        java.util.Arrays.fill(pixels, (byte) 254);
        for (int at : black) {
            pixels[at] = 0;
        }
        byte[] head = ("P5\n# by map_saver\n" + columns + " " + rows + "\n255\n").getBytes(StandardCharsets.US_ASCII);
        byte[] all = new byte[head.length + pixels.length];
        System.arraycopy(head, 0, all, 0, head.length);
        System.arraycopy(pixels, 0, all, head.length, pixels.length);
        Files.write(asset(name), all);
    }

    /** The black pixel is at ROS x 1.15 to 1.2, y -1.95 to -1.9: x is east, y is north. */
    @Test
    public void aRosMapHasItsOriginAndResolution() throws Exception {
        pgm("map.pgm", 10, 20, 8 * 20 + 3);
        Files.writeString(asset("map.yaml"), YAML);
        new FloorPlan("map", "map.yaml");
        Simulation world = Worlds.start(project);
        RaycastScenes scenes = Worlds.scenes(world);
        assertEquals(3.05, scenes.beams.cast(-5, 0.2, 1.17, 1, 0, 0, 1e9, -1, new Hit()), 1e-6);
        assertEquals(1.15, scenes.beams.cast(-1.93, 0.2, 0, 0, 0, 1, 1e9, -1, new Hit()), 1e-6);
        assertEquals(0.5, scenes.beams.cast(-1.93, 1, 1.17, 0, -1, 0, 1e9, -1, new Hit()), 1e-6);
        Files.writeString(asset("map.yaml"), YAML.replace("[1, -2, 0]", "\n- 0\n- 0\n- 1.5707963267948966"));
        scenes = Worlds.scenes(Worlds.start(project));
        assertEquals("turned left: x is north, y is west", 5.15,
            scenes.beams.cast(-5, 0.2, -0.07, 1, 0, 0, 1e9, -1, new Hit()), 1e-6);
        String script = ProjectScript.of(Project.read(project.folder()));
        assertTrue(script, script.contains("FloorPlan(\"map\", \"map.yaml\")"));
    }

    @Test
    public void aBallStopsAtThePixel() throws Exception {
        pgm("map.pgm", 10, 10, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19);
        new FloorPlan("plan", "map.pgm", 0.1, 0.5);
        new Floor("floor", 10, 10);
        Sphere ball = new Sphere("ball", 0.05, 1);
        ball.move(0, 0.05, 0.02);
        ball.setVelocity(1, 0, 0.1);
        Simulation world = Worlds.start(project);
        double most = 0;
        for (int i = 0; i < 240; i++) {
            world.step();
            most = Math.max(most, world.getPose("ball").x);
        }
        assertEquals("the wall begins at 0.3 m", 0.25, most, 1e-3);
    }

    @Test
    public void aMazeIsThatOfEyeSim() throws Exception {
        Maze maze = new Maze("maze", "\n _ _ _\n|    _|\n|S|r _|\n500\n");
        assertEquals(0.5, maze.getCell(), 0);
        assertEquals("2 3", maze.getRows() + " " + maze.getColumns());
        List<double[]> starts = maze.getStarts();
        assertArrayEquals(new double[] {-0.25, -0.5, 90}, starts.get(0), 1e-12);
        assertArrayEquals(new double[] {-0.25, 0, 0}, starts.get(1), 1e-12);
        Simulation world = Worlds.start(project);
        RaycastScenes scenes = Worlds.scenes(world);
        double half = maze.getThickness() / 2;
        assertEquals("to the left edge", 0.25 - half, scenes.beams.cast(-0.25, 0.1, -0.5, 0, 0, -1, 9, -1, new Hit()),
            1e-6);
        assertEquals("the wall between the starts", 0.25 - half,
            scenes.beams.cast(-0.25, 0.1, -0.5, 0, 0, 1, 9, -1, new Hit()), 1e-6);
        assertEquals("up through the gap to the upper edge", 0.75 - half,
            scenes.beams.cast(-0.25, 0.1, -0.5, 1, 0, 0, 9, -1, new Hit()), 1e-6);
        assertEquals("a wall below S", 0.25 - half, scenes.beams.cast(-0.25, 0.1, -0.5, -1, 0, 0, 9, -1, new Hit()),
            1e-6);
        assertEquals("none below r", Double.POSITIVE_INFINITY,
            scenes.beams.cast(-0.25, 0.1, 0, -1, 0, 0, 9, -1, new Hit()), 0);
        assertEquals(" _ _ _", ((Maze) Project.read(project.folder()).getEnvironment().get(0)).getLines().get(0));
        assertTrue(ProjectScript.of(Project.read(project.folder())).contains("Maze"));
        String wrong = assertThrows(IllegalArgumentException.class, () -> new Maze("no", " _\n|#|")).getMessage();
        assertTrue(wrong, wrong.contains("'#' at place 2"));
    }

    @Test
    public void aWallGoesFromCornerToCorner() throws Exception {
        Wall wall = new Wall("wall", List.of(List.of(0, 0), List.of(4, 0), new WallCorner(4, 3)), 0.2, 1.5);
        wall.move(1, 0, 1);
        Sphere ball = new Sphere("ball", 0.05, 1);
        ball.move(3, 0.05, 1.5);
        ball.setVelocity(0, 0, -1);
        new Floor("floor", 20, 20);
        Simulation world = Worlds.start(project);
        RaycastScenes scenes = Worlds.scenes(world);
        assertEquals(0.9, scenes.beams.cast(3, 0.5, 2, 0, 0, -1, 9, -1, new Hit()), 1e-6);
        assertEquals("past the sharp corner", 8.9, scenes.beams.cast(5.05, 0.5, -8, 0, 0, 1, 99, -1, new Hit()), 1e-6);
        assertEquals(0.5, scenes.beams.cast(3, 2, 1, 0, -1, 0, 9, -1, new Hit()), 1e-6);
        assertEquals("over the wall", Double.POSITIVE_INFINITY,
            scenes.beams.cast(3, 1.6, 2, 0, 0, -1, 99, -1, new Hit()), 0);
        double least = 9;
        for (int i = 0; i < 120; i++) {
            world.step();
            least = Math.min(least, world.getPose("ball").z);
        }
        assertEquals("the ball stops at the wall", 1.15, least, 1e-3);
        String script = ProjectScript.of(Project.read(project.folder()));
        assertTrue(script, script.contains("WallCorner(4, 3)"));
        for (List<?> wrong : List.of(List.of(), List.of(List.of(0, 0)), List.of(List.of(0, 0), List.of(0, 0)),
            List.of(List.of(0, 0), "x"), List.of(List.of(0, 0), List.of(1e5, 0)))) {
            String message = assertThrows(IllegalArgumentException.class, () -> wall.setCorners(wrong)).getMessage();
            assertTrue(message, message.contains("Wall \"wall\"") && message.contains("legal: "));
            assertThrows(IllegalArgumentException.class, () -> new Wall("other", wrong));
        }
    }

    @Test
    public void aPlanIsDrawnByItsAreas() throws Exception {
        new Maze("maze", " _\n| |", 1);
        Simulation world = Worlds.start(project);
        double[][][] areas = world.getAreas(world.getProject().getEnvironment().get(0));
        assertEquals("the upper edge, and two sides", 3, areas.length);
        Outline outline = Outline.of(world).get(0);
        assertEquals(3, outline.areas.length);
        assertEquals("its hull", 1.012, outline.points[2][0] - outline.points[0][0], 1e-6);
        new FloorPlan("plan", "chess.pgm", 0.01, 1);
        int[] black = IntStream.range(0, 10_000).filter(i -> (i / 100 + i) % 2 == 0).toArray();
        pgm("chess.pgm", 100, 100, black);
        world = Worlds.start(project);
        areas = world.getAreas(world.getProject().getEnvironment().get(1));
        assertTrue("a coarser grid: " + areas.length, areas.length > 0 && areas.length < 2501);
    }

    @Test
    public void theEditorKeepsTheBlanksOfALine() throws Exception {
        ProjectEditor editor = new ProjectEditor(project.folder());
        String name = editor.apply(Map.of("do", "add", "type", "Maze")).object;
        List<String> lines = List.of(" _ _", "", "| | |", "|_|_|");
        editor.apply(Map.of("do", "set", "object", name, "set", Map.of("line", lines)));
        assertEquals(lines, ((Maze) Project.read(project.folder()).getEnvironment().get(0)).getLines());
        assertEquals(lines, ((Map<?, ?>) editor.object(name).get("values")).get("line"));
        String script = ProjectScript.of(Project.read(project.folder()));
        assertTrue(script, script.contains("| | |"));
    }

    @Test
    public void hostileFilesAreRefusedInWords() throws Exception {
        String[] yaml = {YAML.replace("0.05", "nan"), YAML.replace("0.05", "-1"), YAML.replace("map.pgm", "../x"),
            YAML.replace("map.pgm", "/etc/passwd"), YAML.replace("map.pgm", "map.yaml"), YAML.replace("[1", "[1, 7"),
            "image: map.pgm\n", "", "[[[[", YAML.replace("map.pgm", "none.pgm")};
        String[] pgm = {"P6 1 1 255 ", "P5 99999999999 1 255\n", "P5 65536 65536 255\n", "P5 5 5 255\nab",
            "P5 0 4 255\n", "P2 2 2 255\n1 2 3 999", "P2 2 2", "GIF89a01", "P5 2 2 70000\nabcdefgh",
            "P5 2 2 255\n\u007f\u007f\u007f\u007f"};
        new FloorPlan("map", "map.yaml");
        Files.writeString(asset("map.pgm"), "P5 1 1 255\n\0");
        for (String text : yaml) {
            Files.writeString(asset("map.yaml"), text);
            refused(text);
        }
        Files.writeString(asset("map.yaml"), YAML);
        for (String text : pgm) {
            Files.writeString(asset("map.pgm"), text);
            refused(text);
        }
        Random random = new Random(62);
        for (int i = 0; i < 500; i++) {
            byte[] bytes = (i % 2 == 0 ? YAML : "P5 6 2 255\n0123456789ab").getBytes(StandardCharsets.US_ASCII);
            for (int n = 0; n <= random.nextInt(4); n++) {
                bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
            }
            Files.write(asset("map.yaml"), i % 2 == 0 ? bytes : YAML.getBytes(StandardCharsets.US_ASCII));
            Files.write(asset("map.pgm"), i % 2 == 0 ? "P5 1 1 255\n\0".getBytes(StandardCharsets.US_ASCII) : bytes);
            try {
                Project.read(project.folder()).checkFiles();
            } catch (ProjectException e) {
                assertTrue(e.getMessage(), e.getMessage().contains("environment/map.xml"));
            }
        }
    }

    private void refused(String text) {
        String message = assertThrows(text, ProjectException.class,
            () -> Worlds.start(project)).getMessage();
        assertTrue(text + ": " + message, message.contains("environment/map.xml") && message.contains("legal: "));
    }
}
