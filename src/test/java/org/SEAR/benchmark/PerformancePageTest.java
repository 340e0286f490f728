// SPDX-License-Identifier: Apache-2.0
package org.SEAR.benchmark;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.SEAR.documents.DocBlock;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/** {@code scripts/benchmark} runs, and docs/performance.md matches its figures. */
@Category(Slow.class)
@Needs("jmhClasses")
public class PerformancePageTest {
    private static final Path ROOT = Paths.get(System.getProperty("sear.root", ".")).toAbsolutePath();
    /** Timeout, seconds. A busy machine can take many times as long as a quiet one. */
    private static final int LONGEST = 600;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    private String run(String... options) throws IOException, InterruptedException {
        List<String> command = new ArrayList<>(
            Arrays.asList("python3", ROOT.resolve("src/jmh/python/benchmark.py").toString()));
        command.addAll(Arrays.asList(options));
        Path output = folder.newFile().toPath();
        ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(output.toFile());
        builder.environment().put("PYTHONIOENCODING", "utf-8");
        // figures of a quick run have no meaning
        builder.environment().put("JDK_JAVA_OPTIONS", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC");
        Process process = builder.start();
        boolean ended = process.waitFor(LONGEST, TimeUnit.SECONDS);
        process.destroyForcibly();
        String said = new String(Files.readAllBytes(output), StandardCharsets.UTF_8);
        assertTrue("it takes too long: " + said, ended);
        assertEquals(said, 0, process.exitValue());
        return said;
    }

    private static List<Path> curves(Path docs) throws IOException {
        try (Stream<Path> files = Files.list(docs.resolve("images"))) {
            return files.filter(file -> file.getFileName().toString().matches("speed-.*\\.svg")).sorted()
                .collect(Collectors.toList());
        }
    }

    /** The quick run shows that these commands work; here only their options are checked. */
    @Test
    public void theCommandsOfThePageHaveValidOptions() throws Exception {
        String help = run("--help");
        List<String> commands = DocBlock.commands("docs/performance.md", "scripts/benchmark");
        assertTrue(commands.toString(), commands.size() > 1);
        for (String command : commands) {
            for (String word : command.replaceAll(" *#.*", "").substring("scripts/benchmark".length()).trim()
                .split(" ")) {
                assertTrue(command, word.isEmpty() || Pattern.compile("^ +" + word + "\\b", Pattern.MULTILINE)
                    .matcher(help).find());
            }
        }
    }

    @Test
    public void tablesAndCurvesAreMadeFromRecordedNumbers() throws Exception {
        Path made = folder.newFolder().toPath();
        run("--page-only", ROOT.resolve("src/test/resources/performance/recorded.json").toString(), "--docs",
            made.toString());
        String page = Files.readString(made.resolve("performance.md"));
        for (String part : new String[] {"# How fast is SEAR?", "| hills-1000000 |", "| everything, 1000 boxes |",
            "| 8 LIDARs, 20 boxes |", "Not measured: ", "of 20 goals are met", "## How it is measured"}) {
            assertTrue(part + " is not in\n" + page, page.contains(part));
        }
        assertEquals(5, curves(made).size());
        for (Path curve : curves(made)) {
            assertTrue(page.contains("(images/" + curve.getFileName() + ")"));
            assertEquals("svg", DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(curve.toFile())
                .getDocumentElement().getTagName());
        }
    }

    /** Applies as soon as a run on a quiet machine is recorded. */
    @Test
    public void thePageMatchesItsFigures() throws Exception {
        Path numbers = ROOT.resolve("docs/performance.json");
        if (!Files.exists(numbers)) {
            return;
        }
        Path made = folder.newFolder().toPath();
        run("--page-only", numbers.toString(), "--docs", made.toString());
        assertEquals("docs/performance.md is not what \"scripts/benchmark --page-only docs/performance.json\" makes",
            Files.readString(made.resolve("performance.md")), Files.readString(ROOT.resolve("docs/performance.md")));
        for (Path curve : curves(made)) {
            assertEquals(Files.readString(curve),
                Files.readString(ROOT.resolve("docs/images").resolve(curve.getFileName())));
        }
    }

    @Test
    public void aQuickRunMeasuresEverythingOnce() throws Exception {
        Path work = folder.newFolder().toPath();
        String said = run("--quick", "--no-peers", "--no-script", "--work", work.toString(), "--classpath",
            System.getProperty("sear.jmhClasspath"));
        String page = Files.readString(work.resolve("performance.md"));
        for (String row : new String[] {"| hall-10 |", "| hills-1000 |", "| a LIDAR, 20 boxes |",
            "| everything, 20 boxes |", "| 10 |",
            "| 1 058 |", "| room-20 | colours | SEAR |", "| room-20 | depths | SEAR |",
            "| with noise | ", "| 3 | 1 | ", "| 3 | 0 | "}) {
            assertTrue(row + " is not in\n" + said, page.contains(row));
        }
        assertTrue(said, page.contains("In each world the engines went in turns"));
        for (String peer : new String[] {"embree", "mujoco", "pybullet"}) {
            assertTrue(said, page.contains("Not measured: " + peer + " left out by --no-peers."));
        }
        assertTrue(said, page.contains("| hall-10 | 0 |"));
    }
}
