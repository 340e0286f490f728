// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.SEAR.Slow;
import org.SEAR.web.MyRobotLab;
import org.junit.AfterClass;
import org.junit.BeforeClass;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** The client of docs/python3-http.md, run by the system's python3 against the embedded MyRobotLab. */
@Category(Slow.class)
public class Python3Test {
    private static final int LINES_OF_CLIENT = 10;
    private static final long PATIENCE_SECONDS = 240;

    private static MyRobotLab robotLab;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    @BeforeClass
    public static void startMyRobotLab() throws IOException, InterruptedException {
        robotLab = new MyRobotLab("sear = Runtime.start('sear', 'SEAR')\nsear.setSpeed(10)");
    }

    @AfterClass
    public static void stopMyRobotLab() {
        robotLab.close();
    }

    private static List<String> blocks() {
        return DocBlock.of("docs/python3-http.md", "python3");
    }

    /** Runs a program beside the page's client, with the address of the test's server. */
    private String run(String program) throws IOException, InterruptedException {
        Path folder = temporary.getRoot().toPath();
        String client = blocks().get(0);
        assertTrue(client.contains("http://localhost:8888\""));
        Files.writeString(folder.resolve("robotlab.py"),
            client.replace("http://localhost:8888\"", robotLab.url().replaceAll("/$", "") + "\""));
        Files.writeString(folder.resolve("program.py"), program);
        Path output = folder.resolve("output.txt");
        Process process = new ProcessBuilder("python3", "program.py").directory(folder.toFile())
            .redirectErrorStream(true).redirectOutput(output.toFile()).start();
        boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        String text = Files.readString(output, StandardCharsets.UTF_8);
        assertTrue("it has not ended:\n" + text, ended);
        assertEquals(text, 0, process.exitValue());
        return text;
    }

    @Test
    public void theClientHasTenLines() {
        assertEquals(LINES_OF_CLIENT, blocks().get(0).lines().filter(line -> !line.isBlank()).count());
    }

    @Test
    public void theProgramDrivesAndReads() throws Exception {
        String text = run(blocks().get(1));
        Matcher place = Pattern.compile("at (-?[0-9.]+) m north, (-?[0-9.]+) m east; the nearest thing is "
            + "([0-9.]+) m away").matcher(text);
        assertTrue(text, place.find());
        assertTrue("it was driven north: " + text, Double.parseDouble(place.group(1)) > -1.8);
        assertEquals(text, -1, Double.parseDouble(place.group(2)), 0.1);
        assertTrue(text, Pattern.compile("mm: \\d+ straight ahead").matcher(text).find());
    }

    @Test
    public void theErrorContainsTheCause() throws Exception {
        String text = run("import urllib.error\nfrom robotlab import Service\ntry:\n    Service('sear').getReading('no "
            + "such sensor')\nexcept urllib.error.HTTPError as error:\n    print(error.code, error.read().decode())\n");
        assertTrue(text, text.startsWith("500 ") && text.contains("no simulation runs: startSimulation() first"));
    }
}
