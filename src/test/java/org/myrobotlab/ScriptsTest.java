// SPDX-License-Identifier: Apache-2.0
package org.myrobotlab;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.concurrent.TimeUnit;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.experimental.categories.Category;
import org.junit.Rule;
import org.junit.rules.TemporaryFolder;
import org.junit.Test;
import org.SEAR.SearProcess;
import org.SEAR.Slow;

/**
 * The listings of the dissertation run in order on the command line with the described results, and so does the demo.
 */
@Category(Slow.class)
public class ScriptsTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final long PATIENCE_SECONDS = 240;
    private static final double DEGREE_LENGTH = 92_700;

    /** The robot of the listings facing a wall, and the two templates that come with SEAR. */
    private static final String TEMPLATES = String.join("\n",
        "from org.SEAR.POJOs import Accelerometer, Box, Compass, Distance, Gyroscope",
        "sear = Runtime.start('SEAR', 'SEAR')",
        "wall = Box('wall', 4, 0.1, 1, 0)",
        "wall.move(0, 0.5, -1.5)",
        "python.execFile(r'%s')",
        "for (name, x) in (('testPing1', 0.05), ('MyNewestSONAR', -0.05)):",
        "    ping = Distance(name, 'laser')",
        "    ping.move(x, 0.1, 0.15)",
        "    robot.addComponent(ping)",
        "for sensor in (Accelerometer('accel'), Gyroscope('gyro1'), Compass('comp1')): robot.addComponent(sensor)",
        "for template in ('controller.py', 'userCode.py'): sear.copyTemplate(template, 'SEARproject')",
        "python.execFile('SEARproject/userCode.py')",
        "sear.stopSimulation()", "");

    private static final int LISTINGS = 10;
    private static final String LISTING = "listing%02d.py";
    /** Sleep function of a service named SEAR. */
    private static final String SLEEP = "def sleep(seconds):\n    one = Runtime.getService('SEAR')\n"
        + "    if one is not None and one.isSimulating(): one.simSleep(seconds)";

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    /**
     * Runs a script in the folder of this test.
     * @return its output
     */
    private String run(String script) throws IOException, InterruptedException {
        File folder = temporary.getRoot();
        File output = new File(folder, Paths.get(script).getFileName() + ".txt");
        List<String> command = SearProcess.command("-Xmx512m");
        command.addAll(List.of(ROOT.resolve(script).toString(), "--headless", "--speed", "max", "--port", "none"));
        Process process = new ProcessBuilder(command).directory(folder).redirectErrorStream(true).redirectOutput(output)
            .redirectInput(ProcessBuilder.Redirect.from(new File(folder, "nothing"))).start();
        boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        String text = Files.readString(output.toPath(), StandardCharsets.UTF_8);
        assertTrue(script + " did not end:\n" + text, ended);
        assertEquals(script + ":\n" + text, 0, process.exitValue());
        return text;
    }

    /**
     * Runs a listing. Its waits by the computer's clock pass no simulated time in lock-step, so simulated waits replace
     * them.
     */
    private String listing(int number) throws IOException, InterruptedException {
        Path folder = temporary.getRoot().toPath();
        for (int one = 1; one <= LISTINGS; one++) {    // some run others in the same folder
            String name = String.format(LISTING, one);
            String text = Files.readString(ROOT.resolve("scripts").resolve(name));
            Files.writeString(folder.resolve(name),
                text.replace("from time import sleep", SLEEP)
                    .replaceAll("roomba\\.sleep\\( ?(\\d+) ?\\)", "sleep($1 / 1000.0)"));
        }
        return run(folder.resolve(String.format(LISTING, number)).toString());
    }

    private static double number(String text, String pattern) {
        Matcher matcher = Pattern.compile(pattern).matcher(text);
        assertTrue("no \"" + pattern + "\" in:\n" + text, matcher.find());
        return Double.parseDouble(matcher.group(1));
    }

    private static int count(String text, String part) {
        return text.split(Pattern.quote(part), -1).length - 1;
    }

    private boolean exists(String file) {
        return Files.exists(temporary.getRoot().toPath().resolve("SEARproject").resolve(file));
    }

    @Test
    public void theListingsDoAsTheDissertationDescribes() throws Exception {
        temporary.newFile("nothing");
        assertTrue(listing(1).contains("Done creating Environment"));
        assertTrue(exists("environment/Box1_name.xml") && exists("environment/trash Can.xml")
            && exists("environment/Tree1_name.xml"));
        listing(2);
        assertTrue(exists("robot/robotDynamics1.xml") && exists("robot/myRoomba.xml"));
        String drive = listing(3);
        assertEquals(0.2, number(drive, "after a second forward: (-?[0-9.]+) m"), 0.03);
        assertEquals(0, number(drive, "after a second backward: (-?[0-9.]+) m"), 0.03);
        listing(4);
        String scans = listing(5);
        assertEquals(3, count(scans, "received 101 readings"));
        assertEquals("the trunk of the tree, 3 m from the robot's middle", 2650,
            number(scans, "the nearest at (\\d+)"), 30);
        String points = listing(6);
        assertEquals(2, count(points, "received 101readings:"));
        assertTrue("the trunk is dead ahead:\n" + points, Pattern.compile("(?m)^-?0\\.0\\d+\t26[0-9]{2}\\.")
            .matcher(points).find());
        listing(7);
        String positions = listing(8);
        assertTrue(positions, count(positions, "Lat: 3336.6") >= 4);
        Matcher longitudes = Pattern.compile("Long: -080(51\\.\\d+)").matcher(positions);
        assertTrue(longitudes.find());
        double first = Double.parseDouble(longitudes.group(1));
        double last = first;
        while (longitudes.find()) {
            last = Double.parseDouble(longitudes.group(1));
        }
        assertEquals("metres driven west, where the start pose looks", 0.6, (last - first) / 60 * DEGREE_LENGTH, 0.3);
    }

    @Test
    public void theControllerListingsWorkTogether() throws Exception {
        temporary.newFile("nothing");
        String answers = listing(9);
        assertTrue(answers, answers.contains("Done creating Environment") && answers.contains("listening to: serial"));
        assertEquals(270, number(answers, "Sonar 1 value received = (\\d+)"), 3);
        assertEquals(270, number(answers, "Sonar 2 value received = (\\d+)"), 3);
        assertTrue(answers, answers.contains("Back in Main, AccelX = 465 AccelY = 465 AccelZ = 465"));
        assertTrue(answers, answers.contains("Back in Main, GyroX = 418 GyroY = 418 GyroZ = 418"));
        assertEquals(270, number(answers, "Compass heading \\(out of 360 degrees\\) = (\\d+\\.\\d)"), 0.5);
        assertTrue(listing(10).contains("user should connect to port named: /dev/user_CONTROLLER_01"));
    }

    @Test
    public void theTemplatesWorkTogether() throws Exception {
        temporary.newFile("nothing");
        Path script = temporary.getRoot().toPath().resolve("templates.py");
        Files.writeString(script, "from org.SEAR.POJOs import Floor\nFloor('floor', 50, 50)\n"
            + String.format(TEMPLATES, ROOT.resolve("scripts/listing02.py")));
        String answers = run(script.toString());
        assertEquals(130, number(answers, "Sonar 1: (\\d+) cm"), 2);
        assertEquals(130, number(answers, "Sonar 2: (\\d+) cm"), 2);
        assertTrue(answers, answers.contains("Acceleration x, y, z: 0.0, 0.0, 0.0 m/s^2"));
        assertTrue("nothing turns, so the gyroscope says 0:\n" + answers,
            answers.contains("Rotation x, y, z: 0, 0, 0 degrees/s"));
        assertEquals(270, number(answers, "Heading: (-?[0-9.]+) degrees"), 0.5);
    }

    /** The robot with two sensors, two motor drivers and an 8-bit board turns away from the walls of its room. */
    @Test
    public void theArduinoTemplateAvoidsObstacles() throws Exception {
        temporary.newFile("nothing");
        File script = temporary.newFile("rover.py");
        Files.writeString(script.toPath(), String.join("\n", "sear = Runtime.start('sear', 'SEAR')",
            "for run in range(2):", "    kept = sear.newProject()",
            "    sear.copyTemplate('arduino.py', 'SEARproject')", "    python.execFile('SEARproject/arduino.py')",
            "    x, y, z = sear.getPose('rover')[:3]", "    print 'in the room:', abs(x) < 1.9 and abs(z) < 1.9",
                "    sear.stopSimulation()", ""));
        String text = run(script.toString());
        double turns = number(text, "(\\d+) turns in 30 s");
        assertTrue(text, turns >= 3);
        assertEquals("the same again in one session", 2,
            count(text, Math.round(turns) + " turns in 30 s\nin the room: True\n"));
    }

    @Test
    public void theDemoEndsByItselfWithoutATerminal() throws Exception {
        temporary.newFile("nothing");
        String text = run("scripts/demo.py");
        assertTrue(text, text.contains("\nDone."));
        assertEquals(6, count(text, "   LIDAR: 181 beams"));
        assertEquals(6, count(text, "sonar "));
        assertTrue(text, text.contains("GPS: latitude 3336.6"));
        assertTrue("it runs again on its own project", run("scripts/demo.py").contains("\nDone."));
    }
}
