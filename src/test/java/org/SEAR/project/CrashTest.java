// SPDX-License-Identifier: Apache-2.0
package org.SEAR.project;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.Paths;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.SEAR.POJOs.Box;
import org.SEAR.HowMany;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.SEAR.project.bundle.Bundle;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;

/**
 * A process that saves and loads in a loop is killed at random moments. Afterwards either the old or the new project is
 * there, whole. {@code -Dsear.kills=100} sets the number of kills.
 */
@Category(Slow.class)
public class CrashTest {
    private static final int KILLS = HowMany.of("sear.kills", 100);
    /** Number of loads and saves after the start within which a process is killed. */
    private static final int STEPS = 5;
    private static final long FIRST_GUESS_NS = 20_000_000;
    /** Number of parallel processes, each with its own folder. */
    private static final int LANES = 2;
    private static final Pattern NEEDED = Pattern.compile("^(junit|hamcrest)");

    @Rule
    public final ProjectRule project = new ProjectRule();

    /**
     * Loads a and b in turn and saves c until it is killed. Writes a letter when it is warm, and one after each
     * operation.
     */
    public static void main(String[] places) throws Exception {
        Path root = Paths.get(places[0]);
        for (int warmUp = 0; warmUp < 3; warmUp++) {
            Bundle.check(root.resolve("a.sear"));
        }
        say('r');
        for (int i = 0; i < 100000; i++) {
            Bundle.load(root.resolve(i % 2 == 0 ? "a.sear" : "b.sear"), root.resolve("SEARproject"));
            say('l');
            Bundle.save(root.resolve("SEARproject"), root.resolve("c.sear"));
            say('s');
        }
    }

    private static void say(char letter) {
        System.out.write(letter);
        System.out.flush();
    }

    private Map<String, String> create(String which, int boxes) throws IOException {
        ProjectSwap.delete(project.folder());
        for (int i = 0; i < boxes; i++) {
            new Box(which + i, 1, 1, 1, 0);
        }
        Files.createDirectories(project.folder().resolve("assets"));
        byte[] asset = new byte[500000];
        new Random(boxes).nextBytes(asset);
        Files.write(project.folder().resolve("assets/data.bin"), asset);
        return project.files();
    }

    /** Class path without the jars that only tests need, which take longer to open than everything else. */
    private static String tests() {
        return Stream.of(System.getProperty("java.class.path").split(File.pathSeparator))
            .filter(entry -> entry.endsWith(".jar") ? NEEDED.matcher(new File(entry).getName()).find()
                : entry.endsWith("test"))
            .collect(Collectors.joining(File.pathSeparator));
    }

    private static Process start(Path root) throws IOException {
        List<String> command = SearProcess.java(tests(), new String[0]);
        command.addAll(List.of(CrashTest.class.getName(), root.toString()));
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        assertEquals('r', process.getInputStream().read());
        return process;
    }

    /**
     * Kills processes that work in one folder.
     * @return how many times the first project was there afterwards
     */
    private static int kill(Path root, long seed, Map<String, String> a, Map<String, String> b) throws Exception {
        Path folder = root.resolve("SEARproject");
        Random random = new Random(seed);
        int seenA = 0;
        long each = FIRST_GUESS_NS;
        for (int kill = 0; kill < KILLS / LANES; kill++) {
            Process process = start(root);
            int whole = random.nextInt(STEPS);
            long began = System.nanoTime();
            for (int step = 0; step < whole; step++) {
                assertEquals(step % 2 == 0 ? 'l' : 's', process.getInputStream().read());
            }
            // The duration of one operation depends on the machine. The kill comes at a random moment of the next one.
            each = whole == 0 ? each : (System.nanoTime() - began) / whole;
            boolean ended = process.waitFor((long) (random.nextDouble() * each), TimeUnit.NANOSECONDS);
            process.destroyForcibly().waitFor();
            assertTrue("it ended by itself", !ended);
            Project.read(folder);
            Map<String, String> found = ProjectRule.files(folder);
            assertTrue("kill " + kill + ": neither the old nor the new project, but " + found.keySet(), found.equals(a)
                || found.equals(b));
            Bundle.check(root.resolve("c.sear"));
            seenA += found.equals(a) ? 1 : 0;
        }
        return seenA;
    }

    @Test
    public void theProjectOnDiskIsAlwaysTheOldOrTheNewOne() throws Exception {
        Path root = project.getRoot().toPath();
        Map<String, String> a = create("a", 10);
        Bundle.save(project.folder(), root.resolve("a.sear"));
        Map<String, String> b = create("b", 15);
        Bundle.save(project.folder(), root.resolve("b.sear"));
        ExecutorService lanes = Executors.newFixedThreadPool(LANES);
        try {
            List<Future<Integer>> counts = new ArrayList<>();
            for (int i = 0; i < LANES; i++) {
                Path lane = Files.createDirectory(root.resolve("lane" + i));
                Files.copy(root.resolve("a.sear"), lane.resolve("a.sear"));
                Files.copy(root.resolve("b.sear"), lane.resolve("b.sear"));
                Files.copy(root.resolve("b.sear"), lane.resolve("c.sear"));
                Bundle.load(lane.resolve("b.sear"), lane.resolve("SEARproject"));
                long seed = 50 + i;
                counts.add(lanes.submit(() -> kill(lane, seed, a, b)));
            }
            int seenA = 0;
            for (Future<Integer> count : counts) {
                seenA += count.get();
            }
            assertTrue("both projects were seen: " + seenA, seenA > 0 && seenA < KILLS);
        } finally {
            lanes.shutdownNow();
        }
    }
}
