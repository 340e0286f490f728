// SPDX-License-Identifier: Apache-2.0
package org.SEAR.cli;

import static org.junit.Assert.assertEquals;
import static org.junit.Assert.assertTrue;

import java.io.File;
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
import org.SEAR.Needs;
import org.SEAR.SearProcess;
import org.SEAR.Slow;
import org.junit.Rule;
import org.junit.Test;
import org.junit.experimental.categories.Category;
import org.junit.rules.TemporaryFolder;

/**
 * Mistakes that beginners make, from {@code mistakes.txt}: each ends in a message that names line, object and remedy,
 * with the same words in Jython and Python 3. For each mistake the file has a title, the script, the exit status (or
 * {@code endless}), the expected output lines, and after {@code without} text that must not appear. What is marked
 * {@code in Jython} does not hold in Python 3, nor do the lines that warnings of the simulation name. Python 3 may
 * have its own status, {@code 1, in Python 3 0}.
 */
@Category(Slow.class)
@Needs({"installDist", "python3"})
public class MistakesTest {
    private static final Path ROOT = Path.of(System.getProperty("sear.root", ".")).toAbsolutePath();
    private static final int LEAST = 42;
    private static final int LEAST_PYTHON3 = 100;
    private static final String WITHOUT = "without ";
    private static final String JYTHON = "in Jython";
    private static final String PYTHON3 = ", in Python 3 ";
    private static final String LINE = " ?\\(?line \\d+ of script\\.py\\)?";
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

    /** @param python3 whether to leave out what holds in Jython only */
    private static List<Mistake> mistakes(boolean python3) throws IOException {
        List<Mistake> all = mistakes();
        for (Mistake mistake : all) {
            if (python3) {
                mistake.words.removeIf(words -> words.startsWith(JYTHON) || words.replaceAll(LINE, "").isEmpty());
                mistake.words.replaceAll(words -> words.replaceAll(LINE, ""));
            }
            mistake.words.replaceAll(words -> words.replace(JYTHON + " ", ""));
        }
        all.removeIf(mistake -> python3 && mistake.status.endsWith(JYTHON));
        all.forEach(mistake -> {
            String[] statuses = mistake.status.replace(" " + JYTHON, "").split(PYTHON3);
            mistake.status = statuses[python3 ? statuses.length - 1 : 0];
        });
        return all;
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

    private void run(ProcessBuilder command) throws IOException, InterruptedException {
        Path output = temporary.newFile().toPath();
        Process process = command.directory(temporary.newFolder()).redirectErrorStream(true)
            .redirectOutput(output.toFile()).start();
        try {
            assertTrue("the scripts have not ended:\n" + Files.readString(output),
                process.waitFor(PATIENCE_MINUTES, TimeUnit.MINUTES));
            assertEquals(Files.readString(output), 0, process.exitValue());
        } finally {
            process.destroyForcibly();
        }
    }

    @Test
    public void eachEndsInAMessageWithLineObjectAndRemedy() throws Exception {
        List<String> command = SearProcess.java(System.getProperty("java.class.path"), new String[] {"-Xmx512m"});
        command.add(MistakesRun.class.getName());
        compare(false, LEAST, command);
    }

    @Test
    public void python3UsesTheSameWords() throws Exception {
        // endless scripts are interrupted, which a shell ignores for background commands
        compare(true, LEAST_PYTHON3, new ArrayList<>(List.of("env", "--default-signal=INT", "python3",
            ROOT.resolve("src/test/python3/mistakes.py").toString())));
    }

    private void compare(boolean python3, int least, List<String> command) throws Exception {
        Path root = temporary.newFolder().toPath().toRealPath();
        Map<Path, Mistake> laid = new LinkedHashMap<>();
        for (Mistake mistake : mistakes(python3)) {
            Path folder = root.resolve(String.format("%03d", laid.size()));
            lay(folder, mistake);
            laid.put(folder, mistake);
        }
        assertTrue("only " + laid.size(), laid.size() >= least);
        command.add(root.toString());
        ProcessBuilder builder = new ProcessBuilder(command);
        builder.environment().put("PYTHONPATH", ROOT.resolve("python/src") + File.pathSeparator
            + System.getProperty("sear.python3"));
        builder.environment().put("SEAR_HOME", ROOT.resolve("build/install/sear").toString());
        run(builder);
        List<String> wrong = new ArrayList<>();
        for (Map.Entry<Path, Mistake> entry : laid.entrySet()) {
            look(entry.getKey(), entry.getValue(), wrong);
        }
        assertEquals("", String.join("\n\n", wrong));
    }

    private static void look(Path folder, Mistake mistake, List<String> wrong) throws IOException {
        String seen = Files.readString(folder.resolve("output.txt"));
        String status = Files.readString(folder.resolve("status.txt"));
        Path time = folder.resolve("seconds.txt");
        double seconds = Files.exists(time) ? Double.parseDouble(Files.readString(time)) : 0;
        List<String> missing = new ArrayList<>(mistake.words);
        missing.removeIf(seen::contains);
        boolean ends = mistake.status.equals("endless") || mistake.status.equals(status);
        List<String> tooMany = new ArrayList<>(mistake.without);
        tooMany.removeIf(words -> !seen.contains(words));
        if (!missing.isEmpty() || !tooMany.isEmpty() || !ends || seconds > MOST_SECONDS || mistake.words.isEmpty()) {
            wrong.add(mistake.title + ": exit status " + status + ", " + seconds + " s, without " + missing + ", with "
                + tooMany + ":\n" + seen);
        }
    }
}
