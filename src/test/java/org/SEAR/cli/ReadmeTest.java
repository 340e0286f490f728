// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.SEAR.documents.DocBlock;
import org.SEAR.documents.UnpackedSear;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/** Promises of README and docs: scripts run, links and pictures exist. */
public class ReadmeTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final Pattern TABS = Pattern.compile("Open this in a browser:\\s+(http://localhost:\\d+/)");
    private static final long PATIENCE_SECONDS = 240;
    private static final long LOOK_MILLIS = 100;
    private static final Pattern LINK = Pattern.compile("\\]\\(([^)#:]+)(#[^)]*)?\\)");

    @Rule
    public TemporaryFolder folder = new TemporaryFolder();

    @Test
    public void theScriptOfTheReadmeRunsByItsCommands() throws Exception {
        UnpackedSear.at(folder.getRoot().toPath().resolve("build/install/sear"));
        int scripts = 0;
        for (String command : DocBlock.commands("README.md", "build/install/sear/bin/sear")) {
            Files.writeString(folder.getRoot().toPath().resolve("first.py"), DocBlock.of("README.md", "python").get(0));
            String output = command.contains("first.py") ? toTheEnd(command) : untilItsTabsAreThere(command);
            if (command.contains("first.py")) {
                assertTrue(output, output.contains("181 beams, the nearest at "));
                assertTrue(output, output.contains("driven 1.0"));
                if (command.contains("--speed max")) {
                    assertTrue("what README says that it prints: " + output,
                        output.endsWith(DocBlock.of("README.md", "text").get(0)));
                }
                scripts++;
            }
        }
        assertEquals(2, scripts);
    }

    /** Starts a command without a display in the folder of the test. */
    private Process start(String command) throws IOException {
        ProcessBuilder shell = new ProcessBuilder("sh", "-c", "exec " + command).directory(folder.getRoot())
            .redirectErrorStream(true).redirectOutput(output().toFile());
        shell.environment().keySet().removeAll(List.of("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"));
        shell.environment().put("JAVA_HOME", System.getProperty("java.home"));
        return shell.start();
    }

    private Path output() {
        return folder.getRoot().toPath().resolve("output.txt");
    }

    private String toTheEnd(String command) throws Exception {
        Process process = start(command);
        try {
            assertTrue(command + Files.readString(output()), process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
            assertEquals(command + Files.readString(output()), 0, process.exitValue());
            return Files.readString(output());
        } finally {
            process.destroyForcibly();
        }
    }

    private String untilItsTabsAreThere(String command) throws Exception {
        Process process = start(command);
        try {
            long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_SECONDS);
            Matcher address = TABS.matcher("");
            while (!address.find()) {
                assertTrue(command + Files.readString(output()), process.isAlive() && System.nanoTime() < end);
                LockSupport.parkNanos(TimeUnit.MILLISECONDS.toNanos(LOOK_MILLIS));
                address.reset(Files.readString(output()));
            }
            try (InputStream page = URI.create(address.group(1)).toURL().openStream()) {
                return new String(page.readAllBytes(), StandardCharsets.UTF_8);
            }
        } finally {
            process.destroyForcibly().waitFor();
        }
    }

    /** Runs all exports that the page shows, in the world of its script. */
    @Test
    public void theScriptsForOtherProgramsExportPorts() throws Exception {
        List<String> blocks = DocBlock.of("docs/other-programs.md", "python");
        assertEquals(5, blocks.size());
        Path link = folder.getRoot().toPath().resolve("ttySICK");
        String calls = blocks.get(0).replace("/tmp/ttySICK", link.toString()).replace("5001", "0").replace("5002", "0");
        String output = run(blocks.get(2) + calls + blocks.get(3) + "import os\nprint 'link', path, "
            + "os.path.exists(path), 'port', port\n");
        for (String port : new String[] {"/dev/SEAR_Robot_01", "/dev/SEAR_LIDAR_01", "/dev/SEAR_GPS_01"}) {
            assertTrue(output, Pattern.compile(Pattern.quote(port) + " is /dev/\\S+").matcher(output).find());
        }
        assertTrue(output, Pattern.compile("/dev/SEAR_LIDAR_01 is pseudo-terminal /dev/\\S+, pseudo-terminal "
            + Pattern.quote(link.toString()) + ", tcp port [1-9]\\d+, rfc2217 port [1-9]\\d+").matcher(output).find());
        assertTrue(output, Pattern.compile("link " + Pattern.quote(link.toString()) + " True port [1-9]\\d+")
            .matcher(output).find());
    }

    @Test
    public void aProjectCanHaveItsExports() throws Exception {
        run("from org.SEAR.POJOs import *\nlidar = LIDAR('lidar')\nroomba = Dynamics('drive', 4)\ngps = GPS('gps', "
            + "33.61, 182.5, -80.865)\n" + DocBlock.of("docs/other-programs.md", "python").get(1));
        for (String[] one : new String[][] {{"lidar", "ttySICK"}, {"drive", "tcp:5001"}, {"gps", "rfc2217:5002"}}) {
            String file = Files.readString(folder.getRoot().toPath().resolve("SEARproject/robot/" + one[0] + ".xml"));
            assertTrue(file, file.contains("<export>" + one[1] + "</export>"));
        }
    }

    @Test
    public void aScannerOnANetworkIsExportedToItsPort() throws Exception {
        run("from org.SEAR.POJOs import *\nlidar = LIDAR('lidar')\n"
            + DocBlock.of("docs/other-programs.md", "python").get(4));
        String file = Files.readString(folder.getRoot().toPath().resolve("SEARproject/robot/lidar.xml"));
        assertTrue(file, file.contains("<export>tcp:2112</export>") && file.contains("<model>LMS111</model>"));
    }

    /**
     * Experiment 5.6.2.1 of the dissertation: beside each obstacle of the row the sonar measures the distance to its
     * nearest point.
     */
    @Test
    public void theDriveAlongTheRowLogsTheSonarRanges() throws Exception {
        run(Files.readString(ROOT.resolve("scripts/beam_experiment.py")));
        List<String> rows = Files.readAllLines(folder.getRoot().toPath().resolve("beam_experiment.csv"));
        assertEquals("odometer_m,range_m", rows.get(0));
        double[][] waysAndRanges = {{1.0, 0.54}, {1.9, 0.4956}, {2.6, 0.74}, {3.5, 1.09}, {4.3, 0.3956},
            {0.1, 3}, {4.9, 3}};
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
