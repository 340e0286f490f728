// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab.service.thirdparty;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.SEAR.web.MyRobotLab;
import org.junit.After;
import org.junit.AfterClass;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** The OpenCV programs of examples/python3 drive a robot of the embedded MyRobotLab to their goals. */
@Category(Slow.class)
@Needs("opencv")
public class OpencvExamplesTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Path EXAMPLES = ROOT.resolve("examples/python3");
    /**
     * Timeout, seconds. Time passes only while a program waits for its pictures, so a busy machine only takes longer.
     */
    private static final int PATIENCE = 900;
    /** Position of the dock's marker in examples/dock.py. */
    private static final double DOCK_Z = -0.4;
    private static final double DOCK_X = 2.997;
    /** Distance from the robot's middle to its front, metres. */
    private static final double FRONT = 0.17;
    /** Distance from the robot's middle back to its camera, metres. */
    private static final double EYE = 0.1;

    private static MyRobotLab robotLab;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();
    private final Programs programs = new Programs(folder);

    @BeforeClass
    public static void start() throws IOException, InterruptedException {
        robotLab = new MyRobotLab("sear = Runtime.start('sear', 'SEAR')");
    }

    @AfterClass
    public static void end() {
        robotLab.close();
    }

    @After
    public void stop() {
        programs.end();
        robotLab.run("sear.setLockStep(False)\nif sear.isSimulating(): sear.stopSimulation()");
    }

    /** @param modules folder of OpenCV for Python */
    private Process start(Path modules, List<String> arguments) throws IOException {
        List<String> command = new ArrayList<>(List.of("python3", "-u"));
        command.addAll(arguments);
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put("PYTHONPATH", modules.toString());
        return programs.start(builder);
    }

    /** Returns the output of a program, which must end with status 0; its command is on the page. */
    private String run(String program, String... more) throws Exception {
        List<String> commands = DocBlock.commands("docs/cameras.md", "python3 examples/python3/" + program);
        assertEquals(1, commands.size());
        List<String> arguments = new ArrayList<>(
            List.of(ROOT.resolve(commands.get(0).split(" ")[1]).toString(), "--fast", "--server", server()));
        arguments.addAll(Arrays.asList(more));
        Process process = start(Path.of(System.getProperty("sear.opencv")), arguments);
        String text = String.join("\n", programs.read(process, PATIENCE));
        assertFalse("it has not ended: " + text, process.isAlive());
        assertEquals(text, 0, process.exitValue());
        assertFalse("time passes by itself again", robotLab.call("sear", "isLockStep").asBoolean());
        return text;
    }

    private static String server() {
        return robotLab.url().replaceAll("/$", "");
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

    @Test
    public void everyProgramIsTriedHere() throws IOException {
        try (Stream<Path> files = Files.list(EXAMPLES)) {
            assertEquals("learn_wall_follower.py is looked at by GymnasiumTest, maze_sweep.py by SweepTest",
                List.of("docking.py", "learn_wall_follower.py", "maze_sweep.py", "opencv_lines.py", "robotlab.py",
                    "simulated.py"),
                files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".py")).sorted()
                    .collect(Collectors.toList()));
        }
        assertEquals("the client of the page", DocBlock.of("docs/python3-http.md", "python3").get(0),
            Files.readString(EXAMPLES.resolve("robotlab.py")));
    }

    /** Follows once a line at a radius of 0.7 + 0.15 cos 3a metres. */
    @Test
    public void theLineIsFollowedAllAround() throws Exception {
        robotLab.run("sear.recordRun('lines.searlog')");
        Path picture = folder.getRoot().toPath().resolve("lines.png");
        String text = run("opencv_lines.py", "--save", picture.toString());
        robotLab.run("sear.endRecord()");
        double[] told = numbers(text, "Followed the line for ([0-9.]+) m: it was lost in (\\d+) of (\\d+) pictures");
        assertEquals(text, 0, told[1], 0.02 * told[2]);
        assertTrue(Files.size(picture) > 0);
        JsonNode values = robotLab.call("sear", "getRecordValues", "lines.searlog", List.of("follower.x", "follower.z"))
            .get("values");
        double turned = 0;
        double before = Double.NaN;
        for (int i = 0; i < values.get(0).size(); i++) {
            double x = values.get(0).get(i).asDouble();
            double z = values.get(1).get(i).asDouble();
            double around = Math.atan2(z, x);
            assertEquals("off the line at " + x + ", " + z, 0.7 + 0.15 * Math.cos(3 * around), Math.hypot(x, z), 0.03);
            turned += Double.isNaN(before) ? 0 : Math.IEEEremainder(around - before, 2 * Math.PI);
            before = around;
        }
        assertTrue(text + ", " + Math.toDegrees(turned) + " degrees around the middle", Math.abs(turned) > 2 * Math.PI);
    }

    private static void assertDocked(String text) {
        double[] told = numbers(text, "Docked: ([0-9.]+) m before the dock, ([0-9.]+) m beside its middle, turned by "
            + "([0-9.]+) degrees");
        JsonNode pose = robotLab.call("sear", "getPose", "docker");
        double gap = DOCK_X - pose.get(0).asDouble() - FRONT;
        assertEquals(text, 0.04, gap, 0.02);
        assertEquals(text, DOCK_Z, pose.get(2).asDouble(), 0.03);
        assertEquals(text, 90, pose.get(4).asDouble(), 5);
        assertEquals("what it measured", gap, told[0], 0.005);
        double turn = pose.get(4).asDouble() - 90;
        double beside = pose.get(2).asDouble() - DOCK_Z + EYE * Math.sin(Math.toRadians(turn));
        assertEquals("what it measured: " + text, Math.abs(turn), told[2], 0.3);
        assertEquals("what it measured: " + text, Math.abs(beside), told[1], 0.003);
        robotLab.run("sear.simSleep(0.5)");
        assertEquals("it stands", pose.get(0).asDouble(), robotLab.call("sear", "getPose", "docker").get(0)
            .asDouble(), 0.001);
    }

    @Test
    public void theRobotDocks() throws Exception {
        assertDocked(run("docking.py"));
    }

    /** Drives the robot to the other side of the dock first. */
    @Test
    public void theRobotDocksFromAnotherPlaceInARunningSimulation() throws Exception {
        robotLab.run("sear.loadProject('examples/dock.sear')\nsear.startSimulation()\nsear.setLockStep(True)\n"
            + "sear.simSleep(0.5)\n"
            + "sear.driveStraight(-0.5)\nsear.simSleep(5)\nsear.driveStraight(0)\nsear.simSleep(1)\n"
                + "sear.setLockStep(False)");
        assertTrue("on the other side", robotLab.call("sear", "getPose", "docker").get(2).asDouble() < -1);
        assertDocked(run("docking.py", "--running"));
    }

    private void assertRefused(Path modules, String expected, String... more) throws Exception {
        for (String program : new String[] {"opencv_lines.py", "docking.py"}) {
            List<String> arguments = new ArrayList<>(List.of(EXAMPLES.resolve(program).toString()));
            arguments.addAll(Arrays.asList(more));
            Process process = start(modules, arguments);
            String text = String.join("\n", programs.read(process, PATIENCE));
            assertTrue(text, text.contains(expected));
            assertFalse(text, text.contains("Traceback"));
            assertEquals(text, 1, process.exitValue());
        }
    }

    @Test
    public void missingRequirementsAreReported() throws Exception {
        Path without = folder.newFolder("without").toPath();
        Files.writeString(without.resolve("cv2.py"), "raise ImportError('there is no OpenCV here')\n");
        assertRefused(without, "OpenCV is missing. Install it: python3 -m pip install opencv-python");
        Path opencv = Path.of(System.getProperty("sear.opencv"));
        assertRefused(opencv, "There is no SEAR at http://localhost:1 (", "--server", "http://localhost:1");
        robotLab.run("sear.loadProject('examples/office.sear')\nsear.startSimulation()");
        assertRefused(opencv, "SEAR: ", "--server", server(), "--running");
    }
}
