// SPDX-License-Identifier: Apache-2.0
package org.SEAR.documents;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertFalse;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.PathMatcher;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.Needs;
import org.SEAR.Slow;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/**
 * Gradle calls on all pages. Gradle resolves them in a dry run; CI runs the same tasks. Only the measurement runs here,
 * shortened.
 */
@Category(Slow.class)
@Needs("jmhClasses")
public class GradleCommandsTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final String GRADLE = "./gradlew ";
    private static final String JMH = "jmh -PjmhArgs=\"";
    private static final Pattern TESTS = Pattern.compile("--tests '([^']*)'");
    private static final long PATIENCE_SECONDS = 240;

    @Rule
    public final TemporaryFolder folder = new TemporaryFolder();

    /** Returns the arguments after ./gradlew of all command lines, without duplicates. */
    private static List<String> calls() {
        return DocBlock.pages().stream().flatMap(page -> DocBlock.commands(page, GRADLE).stream())
            .map(line -> line.replaceAll(" +#.*", "").substring(GRADLE.length())).distinct()
            .collect(Collectors.toList());
    }

    private String run(List<String> command) throws IOException, InterruptedException {
        Path output = folder.newFile().toPath();
        ProcessBuilder builder = new ProcessBuilder(command).directory(ROOT.toFile()).redirectErrorStream(true)
            .redirectOutput(output.toFile());
        builder.environment().put("CLASSPATH", System.getProperty("sear.jmhClasspath"));
        Process process = builder.start();
        try {
            assertTrue(command + Files.readString(output), process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS));
            assertEquals(command + Files.readString(output), 0, process.exitValue());
            return Files.readString(output);
        } finally {
            process.destroyForcibly();
        }
    }

    private String dryRun(String arguments) throws IOException, InterruptedException {
        return run(List.of("sh", "-c", "exec gradle --dry-run --offline --project-cache-dir \"$0\" " + arguments,
            folder.newFolder().toString()));
    }

    @Test
    public void gradleKnowsEachTaskAndOption() throws Exception {
        List<String> calls = calls();
        assertTrue(calls.toString(), calls.size() > 6);
        String plan = dryRun(String.join(" ", calls));
        for (String call : calls) {
            assertTrue(call + "\n" + plan, plan.contains(":" + call.replaceAll(" .*", "") + " SKIPPED"));
        }
    }

    /** The plan of a test has the fetching tasks of its class, and no others. */
    @Test
    public void aTestPlansOnlyWhatItNeeds() throws Exception {
        Pattern more = Pattern.compile(":(uv|rasterio|python3|opencv|style|installDist|distZip) SKIPPED");
        String quick = dryRun("test");
        assertFalse(quick, more.matcher(quick).find());
        String selected = dryRun("test --tests '*RoomsTest' --tests '*RasterioTest'");
        assertEquals(selected, List.of("uv", "rasterio"), more.matcher(selected).results().map(found -> found.group(1))
            .collect(Collectors.toList()));
    }

    @Test
    public void theTestsNamedOnAPageExist() throws IOException {
        List<String> patterns = new ArrayList<>();
        for (String call : calls()) {
            Matcher tests = TESTS.matcher(call);
            while (tests.find()) {
                patterns.add(tests.group(1));
            }
        }
        assertFalse(patterns.isEmpty());
        for (String pattern : patterns) {
            PathMatcher classes = FileSystems.getDefault().getPathMatcher("glob:" + pattern + ".java");
            try (Stream<Path> files = Files.walk(ROOT.resolve("src/test/java"))) {
                assertTrue(pattern, files.anyMatch(file -> classes.matches(file.getFileName())));
            }
        }
    }

    @Test
    public void theMeasurementOfThePageIsMade() throws Exception {
        List<String> measurements = calls().stream().filter(call -> call.startsWith(JMH)).collect(Collectors.toList());
        assertEquals(measurements.toString(), 1, measurements.size());
        List<String> command = new ArrayList<>(
            List.of(Path.of(System.getProperty("java.home"), "bin", "java").toString(), "org.openjdk.jmh.Main"));
        command.addAll(List.of(measurements.get(0).substring(JMH.length()).replace("\"", "").split(" ")));
        command.add(1, "-Djava.io.tmpdir=" + folder.getRoot());
        command.addAll(List.of("-f", "0", "-wi", "0", "-i", "1", "-r", "100ms"));
        String output = run(command);
        assertTrue(output, Pattern.compile("^\\S*Beams\\.fan +room-20 ", Pattern.MULTILINE).matcher(output).find());
    }
}
