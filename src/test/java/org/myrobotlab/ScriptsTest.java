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
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** The listings of the dissertation run one after the other with the command line, and do what it says; so does the demo. */
public class ScriptsTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final long PATIENCE_SECONDS = 240;
    private static final double DEGREE_LENGTH = 92_700;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    /**
     * Runs a script in the folder of this test.
     *
     * @return what it printed
     */
    private String run(String script) throws IOException, InterruptedException {
        File folder = temporary.getRoot();
        File output = new File(folder, script.replace('/', '_') + ".txt");
        ProcessBuilder builder = new ProcessBuilder(System.getProperty("java.home") + "/bin/java", "-Xmx512m", "-cp",
            System.getProperty("sear.cliClasspath"), "org.SEAR.cli.SearCommand", ROOT.resolve(script).toString(), "--headless", "--speed", "max",
            "--port", "none");
        Process process = builder.directory(folder).redirectErrorStream(true).redirectOutput(output)
            .redirectInput(ProcessBuilder.Redirect.from(new File(folder, "nothing"))).start();
        boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        String text = Files.readString(output.toPath(), StandardCharsets.UTF_8);
        assertTrue(script + " did not end:\n" + text, ended);
        assertEquals(script + ":\n" + text, 0, process.exitValue());
        return text;
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
    public void theListingsDoWhatTheDissertationSays() throws Exception {
        temporary.newFile("nothing");
        assertTrue(run("scripts/listing01.py").contains("Done creating Environment"));
        assertTrue(exists("environment/Box1_name.xml") && exists("environment/trash Can.xml") && exists("environment/Tree1_name.xml"));
        run("scripts/listing02.py");
        assertTrue(exists("robot/robotDynamics1.xml") && exists("robot/myRoomba.xml"));
        String drive = run("scripts/listing03.py");
        assertEquals(0.2, number(drive, "after a second forward: (-?[0-9.]+) m"), 0.03);
        assertEquals(0, number(drive, "after a second backward: (-?[0-9.]+) m"), 0.03);
        run("scripts/listing04.py");
        assertEquals(3, count(run("scripts/listing05.py"), "received 101 readings"));
        String points = run("scripts/listing06.py");
        assertEquals(2, count(points, "received 101 readings:"));
        assertTrue(points, Pattern.compile("(?m)^-?\\d+\t\\d+$").matcher(points).find());
        run("scripts/listing07.py");
        String positions = run("scripts/listing08.py");
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
        String answers = run("scripts/listing09.py");
        assertEquals(130, number(answers, "Sonar 1: (\\d+) cm"), 2);
        assertEquals(130, number(answers, "Sonar 2: (\\d+) cm"), 2);
        assertEquals(0, number(answers, "Acceleration x, y, z: (-?[0-9.]+)"), 0.2);
        assertEquals(0, number(answers, "Rotation x, y, z: (-?[0-9.]+)"), 2);
        assertEquals(90, number(answers, "Heading: (-?[0-9.]+) degrees"), 0.5);
        String bytes = run("scripts/listing10.py");
        assertTrue(bytes, bytes.contains("byte 0x0"));
        assertEquals(1.3, number(bytes, "SEAR itself says ([0-9.]+) m"), 0.02);
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
