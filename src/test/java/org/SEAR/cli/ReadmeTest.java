package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** What README and docs promise: their scripts run, their links and pictures are there. */
public class ReadmeTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Pattern SCRIPT = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL);
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)(#[^)]*)?\\)");

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void theScriptOfTheReadmeRuns() throws Exception {
        String output = run(scripts("README.md").get(0));
        assertTrue(output, output.contains("181 beams, the nearest at "));
        assertTrue(output, output.contains("driven 1.0"));
    }

    @Test
    public void theScriptForOtherProgramsExportsAllPorts() throws Exception {
        String output = run(scripts("docs/other-programs.md").get(1));
        for (String port : new String[] {"/dev/SEAR_Robot_01", "/dev/SEAR_LIDAR_01", "/dev/SEAR_GPS_01"}) {
            assertTrue(output, Pattern.compile(Pattern.quote(port) + " is /dev/\\S+").matcher(output).find());
        }
    }

    /** The dissertation's experiment 5.6.2.1: beside each obstacle of the row the sonar reads the way to its nearest point. */
    @Test
    public void theDriveAlongTheRowLogsWhatTheSonarSees() throws Exception {
        run(Files.readString(ROOT.resolve("scripts/beam_experiment.py")));
        List<String> rows = Files.readAllLines(folder.getRoot().toPath().resolve("beam_experiment.csv"));
        assertEquals("odometer_m,range_m", rows.get(0));
        double[][] waysAndRanges = {{1.0, 0.54}, {1.9, 0.4956}, {2.6, 0.74}, {3.5, 1.09}, {4.3, 0.3956}, {0.1, 3}, {4.9, 3}};
        for (double[] expected : waysAndRanges) {
            String row = rows.stream().skip(1).min(Comparator.comparingDouble(each ->
                Math.abs(Double.parseDouble(each.split(",")[0]) - expected[0]))).get();
            assertEquals(row, expected[1], Double.parseDouble(row.split(",")[1]), 0.01);
        }
        assertTrue(Files.readString(folder.getRoot().toPath().resolve("beam_experiment.svg")).startsWith("<svg"));
    }

    @Test
    public void everyLinkLeadsToAFile() throws IOException {
        List<String> broken = new ArrayList<>();
        List<Path> pages = new ArrayList<>();
        pages.add(ROOT.resolve("README.md"));
        try (Stream<Path> docs = Files.list(ROOT.resolve("docs"))) {
            docs.filter(page -> page.toString().endsWith(".md")).forEach(pages::add);
        }
        for (Path page : pages) {
            Matcher links = LINK.matcher(Files.readString(page).replaceAll("(?s)```.*?```|`[^`]*`", ""));
            while (links.find()) {
                if (!Files.exists(page.resolveSibling(links.group(1)))) {
                    broken.add(page.getFileName() + " -> " + links.group(1));
                }
            }
        }
        assertEquals("[]", broken.toString());
    }

    private static List<String> scripts(String page) throws IOException {
        List<String> scripts = new ArrayList<>();
        Matcher blocks = SCRIPT.matcher(Files.readString(ROOT.resolve(page)));
        while (blocks.find()) {
            scripts.add(blocks.group(1));
        }
        return scripts;
    }

    /** Runs a script in lock-step in a folder with the examples. */
    private String run(String script) throws Exception {
        Path examples = folder.newFolder("examples").toPath();
        try (Stream<Path> bundles = Files.list(ROOT.resolve("examples"))) {
            for (Path bundle : (Iterable<Path>) bundles::iterator) {
                Files.copy(bundle, examples.resolve(bundle.getFileName()));
            }
        }
        Path file = folder.getRoot().toPath().resolve("first.py");
        Files.writeString(file, script);
        return ScriptProcess.run(folder.getRoot().toPath(), file);
    }
}
