// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import org.SEAR.Slow;
import org.junit.Before;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** Follows docs/add-a-sensor.md word for word: writes its files and runs its commands. */
@Category(Slow.class)
public class AddASensorTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String HOME = "SEAR=/path/to/sear\n";
    private static final long PATIENCE_SECONDS = 300;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private Path sear;
    private Path folder;

    /** Lays out an unpacked SEAR from the compiled classes. */
    @Before
    public void layOut() throws IOException {
        sear = temporary.newFolder("unpacked sear").toPath();
        folder = temporary.newFolder("work").toPath();
        UnpackedSear.at(sear);
    }

    @Test
    public void itsFilesAndCommandsMakeASensorThatAScriptReads() throws Exception {
        StringBuilder output = new StringBuilder();
        int files = 0;
        for (DocBlock block : DocBlock.of("docs/add-a-sensor.md")) {
            if (block.file != null) {
                Files.writeString(folder.resolve(block.file), block.text);
                files++;
            } else {
                assertEquals("what is no file is a command", "sh", block.language);
                output.append(run(block.text));
            }
        }
        assertEquals(10, files);
        String text = output.toString();
        assertTrue(text, text.contains("Thermometer"));
        assertTrue(text, text.contains("ground: temperature at the world's origin. Legal: a number from -100 to 100 "
            + "degC; default 20"));
        assertTrue(text, text.contains("\n14.35 degC\n"));
        assertTrue(text, text.contains("right: 14.3"));
        assertTrue("what the thermal camera sees", Pattern.compile("\\n20( 20){7}\\n(.*\\n)*(20 )*34( 34)+.*\\n")
            .matcher(text).find());
        assertTrue(text, text.contains("\n[u'eye.coldest', u'eye.warmest']\n"));
    }

    /** The classes on the page equal those that other tests load, which begin with a line of the licence. */
    @Test
    public void itsClassesAreThoseOfTheTests() throws IOException {
        String page = Files.readString(ROOT.resolve("docs/add-a-sensor.md"));
        for (String file : List.of("Thermometer.java", "ThermometerSensor.java", "ThermalGrid.java",
            "ThermalImage.java", "ThermalGridSensor.java")) {
            String text = Files.readString(ROOT.resolve("src/test/java/org/example").resolve(file));
            assertTrue(file, page.contains("```java\n" + text.substring(text.indexOf('\n') + 1) + "```"));
        }
    }

    private String run(String commands) throws IOException, InterruptedException {
        Path output = Files.createTempFile(temporary.getRoot().toPath(), "output", ".txt");
        ProcessBuilder shell = new ProcessBuilder("sh", "-e", "-c", commands.replace(HOME, ""))
            .directory(folder.toFile()).redirectErrorStream(true).redirectOutput(output.toFile());
        shell.environment().put("SEAR", sear.toString());
        shell.environment().put("JAVA_HOME", System.getProperty("java.home"));
        shell.environment().merge("PATH", System.getProperty("java.home") + "/bin", (path, first) -> first
            + File.pathSeparator + path);
        Process process = shell.start();
        assertTrue(commands, process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
        String text = Files.readString(output, StandardCharsets.UTF_8);
        assertEquals(commands + text, 0, process.exitValue());
        return text;
    }
}
