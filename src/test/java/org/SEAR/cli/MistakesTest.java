// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.SEAR.SearProcess;
import org.junit.Rule;
import org.junit.Test;
import org.junit.rules.TemporaryFolder;

/**
 * Mistakes that beginners make, from {@code mistakes.txt}: each ends in a message that names line, object and remedy.
 * For each mistake the file has a title, the script, the exit status (or {@code endless}), the expected output lines,
 * and after {@code without} text that must not appear.
 */
public class MistakesTest {
    private static final int LEAST = 42;
    private static final String WITHOUT = "without ";
    private static final long PATIENCE_MINUTES = 10;
    /** Limit of CPU time from MyRobotLab's start to its end, seconds; it does not grow on a busy machine. */
    private static final double MOST_SECONDS = 3;

    @Rule
    public final TemporaryFolder temporary = new TemporaryFolder();

    private static final class Mistake {
        private final String title;
        private final StringBuilder script = new StringBuilder();
        private String status = "";
        private final List<String> words = new ArrayList<>();
        private final List<String> without = new ArrayList<>();

        Mistake(String title) {
            this.title = title;
        }
    }

    private static List<Mistake> mistakes() throws IOException {
        List<Mistake> all = new ArrayList<>();
        try (InputStream in = MistakesTest.class.getResourceAsStream("mistakes.txt")) {
            boolean answer = false;
            for (String line : new String(in.readAllBytes(), StandardCharsets.UTF_8).split("\n")) {
                Mistake last = all.isEmpty() ? null : all.get(all.size() - 1);
                if (line.startsWith("== ")) {
                    all.add(new Mistake(line.substring(3)));
                    answer = false;
                } else if (line.startsWith("=> ")) {
                    last.status = line.substring(3);
                    answer = true;
                } else if (answer && !line.isEmpty()) {
                    if (line.startsWith(WITHOUT)) {
                        last.without.add(line.substring(WITHOUT.length()));
                    } else {
                        last.words.add(line);
                    }
                } else if (last != null && !answer) {
                    last.script.append(line).append('\n');
                }
            }
        }
        return all;
    }

    private static void lay(Path folder, Mistake mistake) throws IOException {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve("script.py"), mistake.script.toString());
        if (mistake.status.equals("endless")) {
            Files.writeString(folder.resolve("message.txt"), mistake.words.get(0));
        }
    }

    private void run(Path folder) throws IOException, InterruptedException {
        List<String> command = SearProcess.java(System.getProperty("java.class.path"), new String[] {"-Xmx512m"});
        command.addAll(List.of(MistakesRun.class.getName(), folder.toString()));
        Path output = temporary.newFile().toPath();
        Process process = new ProcessBuilder(command).directory(temporary.newFolder()).redirectErrorStream(true)
            .redirectOutput(output.toFile()).start();
        try {
            assertTrue("the scripts have not ended:\n" + Files.readString(output), process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES));
            assertEquals(Files.readString(output), 0, process.exitValue());
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    public void eachEndsInAMessageWithLineObjectAndRemedy() throws Exception {
        Path root = temporary.newFolder().toPath().toRealPath();
        Map<Path, Mistake> laid = new LinkedHashMap<>();
        for (Mistake mistake : mistakes()) {
            Path folder = root.resolve(String.format("%03d", laid.size()));
            lay(folder, mistake);
            laid.put(folder, mistake);
        }
        assertTrue("only " + laid.size(), laid.size() >= LEAST);
        run(root);
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<Path, Mistake> entry : laid.entrySet()) {
            look(entry.getKey(), entry.getValue(), wrong);
        }
        assertEquals("", String.join("\n\n", wrong));
    }

    private static void look(Path folder, Mistake mistake, List<String> wrong) throws IOException {
        String seen = Files.readString(folder.resolve("output.txt"));
        String status = Files.readString(folder.resolve("status.txt"));
        double seconds = Double.parseDouble(Files.readString(folder.resolve("seconds.txt")));
        List<String> missing = new ArrayList<>(mistake.words);
        missing.removeIf(seen::contains);
        boolean ends = mistake.status.equals("endless") || mistake.status.equals(status);
        List<String> tooMany = new ArrayList<>(mistake.without);
        tooMany.removeIf(words -> !seen.contains(words));
        if (!missing.isEmpty() || !tooMany.isEmpty() || !ends || seconds > MOST_SECONDS || mistake.words.isEmpty()) {
            wrong.add(mistake.title + ": exit status " + status + ", " + seconds + " s, without " + missing + ", with " + tooMany + ":\n" + seen);
        }
    }
}
