// SPDX-License-Identifier: Apache-2.0
package org.SEAR.real;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.AfterClass;
import org.junit.BeforeClass;
import org.junit.Test;
import org.junit.runner.RunWith;
import org.junit.runners.Parameterized;

/**
 * Every script that comes with SEAR, twice in one session of the real MyRobotLab, prints the output of a run in the
 * embedded one: identical in lock-step, nearly the same numbers if the script waits by the clock.
 */
@RunWith(Parameterized.class)
public class ScriptsTest {
    private static final Pattern NUMBER = Pattern.compile("(?<![\\w.])-?\\d+(?:\\.\\d+)?");
    private static final double SHARE = 0.05;
    private static final double ABSOLUTE = 0.12;
    /** A computer that stalls shortens the ways that a script drives by the clock. */
    private static final int TRIALS_BY_THE_CLOCK = 3;
    private static ExecutorService others;
    private static Map<String, Future<String>> alone;

    private final Job job;

    public ScriptsTest(Job job) {
        this.job = job;
    }

    @Parameterized.Parameters(name = "{0}")
    public static List<Job> jobs() throws Exception {
        return Job.all();
    }

    /** Runs the scripts in the embedded MyRobotLab in parallel to the real one. */
    @BeforeClass
    public static void startTheEmbeddedOnes() throws Exception {
        others = Executors.newSingleThreadExecutor();
        alone = new TreeMap<>();
        for (Job job : Job.all()) {
            alone.put(job.toString(), others.submit(() -> alone(job)));
        }
    }

    private static String alone(Job job) throws Exception {
        Path folder = Files.createDirectories(RealMrlCopy.BUILD.resolve("embedded")
            .resolve(job.toString().replaceAll("\\W+", "_")));
        Path script = Files.writeString(folder.resolve("job.py"), job.alone());
        return RealMrlCopy.sear(folder, script.toString(), "--headless", "--speed", job.isByTheClock() ? "1" : "max",
            "--port", "none");
    }

    @AfterClass
    public static void end() throws Exception {
        others.shutdownNow();
        InRealMrl.release(RealMrl.shared());
    }

    @Test
    public void itPrintsTheSameAsAlone() throws Exception {
        Path script = Files.writeString(Files.createDirectories(RealMrlCopy.BUILD.resolve("scripts"))
            .resolve(job.toString().replaceAll("\\W+", "_") + ".py"), job.inSession());
        List<String> outputs = List.of(RealMrl.shared().run(script), RealMrl.shared().run(script));
        String expected = alone.get(job.toString()).get();
        if (job.isByTheClock()) {
            areNear(script, expected, outputs, 1);
        } else {
            assertEquals("alone and twice in the session", List.of(expected, expected, expected),
                List.of(expected, outputs.get(0), outputs.get(1)));
        }
    }

    private void areNear(Path script, String expected, List<String> outputs, int trial) throws Exception {
        try {
            outputs.forEach(output -> assertNear(expected, output));
        } catch (AssertionError e) {
            if (trial == TRIALS_BY_THE_CLOCK) {
                throw e;
            }
            List<String> again = List.of(RealMrl.shared().run(script), RealMrl.shared().run(script));
            areNear(script, alone(job), again, trial + 1);
        }
    }

    /**
     * Checks that both outputs have the same kinds of lines with numbers from the same ranges. By the clock, the number
     * of GPS fixes varies.
     */
    private static void assertNear(String expected, String output) {
        Map<String, List<double[]>> one = ranges(expected);
        Map<String, List<double[]>> other = ranges(output);
        assertEquals(output, one.keySet(), other.keySet());
        one.forEach((line, ranges) -> {
            for (int i = 0; i < ranges.size(); i++) {
                for (int end = 0; end < 2; end++) {
                    double value = ranges.get(i)[end];
                    assertEquals(line + "\n" + expected + "\n" + output, value, other.get(line).get(i)[end],
                        ABSOLUTE + SHARE * Math.abs(value));
                }
            }
        });
    }

    /** Returns minimum and maximum of each number over all lines that differ only in numbers. */
    private static Map<String, List<double[]>> ranges(String text) {
        Map<String, List<double[]>> ranges = new TreeMap<>();
        for (String line : text.split("\n")) {
            List<double[]> here = ranges.computeIfAbsent(NUMBER.matcher(line).replaceAll("#"),
                key -> new ArrayList<>());
            Matcher number = NUMBER.matcher(line);
            for (int i = 0; number.find(); i++) {
                double value = Double.parseDouble(number.group());
                if (i == here.size()) {
                    here.add(new double[] {value, value});
                }
                here.get(i)[0] = Math.min(here.get(i)[0], value);
                here.get(i)[1] = Math.max(here.get(i)[1], value);
            }
        }
        assertTrue(text, !ranges.isEmpty());
        return ranges;
    }
}
